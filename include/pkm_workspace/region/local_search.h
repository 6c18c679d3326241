// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/linear_programme.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// A region c + h K, by its numbers.
struct Candidate
{
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double size = 0.0;
};

/// Finds large regions by sequential linear programming on the criterion at the witness points (design, section 3, item
/// 5). Floating point: what it finds is a good guess, to be certified by checkContainment.
class LocalSearch
{
public:
  /// @param centers where the center may lie [m]
  LocalSearch(const BoxTest& test, const Shape& shape, const Box& centers);

  /// Climbs from a start. @param witnesses points of K that are looked at
  /// @return the best candidate whose witness points satisfy the criterion; size <= 0 when there is none
  Candidate climb(const Candidate& start, const std::vector<Eigen::Vector3d>& witnesses);

private:
  struct Step
  {
    Candidate candidate;
    double violation;  ///< how far the criterion is missed at the worst witness point, as a length [m]
  };

  Step assess(const Candidate& candidate, const std::vector<Eigen::Vector3d>& witnesses) const;
  double merit(const Step& step) const;
  Candidate propose(const Step& step, double trust, const std::vector<Eigen::Vector3d>& witnesses);
  void linearize(const Candidate& from, double trust, const Eigen::Vector3d& witness);
  void addRow(const AffineForm<double>& form, double scale, double trust, const Eigen::Vector3d& witness);
  bool addCuts(double trust);

  const BoxTest& test_;
  const Shape& shape_;
  Box centers_;
  double scale_;        ///< the longest strut [m]
  double reach_;        ///< largest half extent of K
  double slack_ = 0.0;  ///< largest violation that the programme may leave [m]
  LinearProgramme<5>
      programme_;  ///< unknowns: step of the center, step of the size, violation; in units of the trust region
  std::vector<SymmetricForms<double>> matrices_;
  std::vector<Eigen::Vector3d> matrix_witnesses_;
};
}  // namespace pkm_workspace
