// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/candidate.h"
#include "pkm_workspace/region/linear_programme.h"
#include "pkm_workspace/region/rail_travel.h"
#include "pkm_workspace/region/witness_points.h"

namespace pkm_workspace
{
/// Finds large regions by sequential linear programming on the criterion at the witness points (docs/theory.md,
/// the largest region). Floating point: what it finds is a good guess, to be certified by checkContainment.
class LocalSearch
{
public:
  /// Keeps references: the witness points may grow between calls. @param centers where the center may lie [m]
  /// @param angles by which regions may be turned, not a single 0 where they are [rad]
  /// @param travel where bad points are those of the places of centers, or nullptr
  LocalSearch(const BoxTest& test, const Shape& shape, const WitnessPoints& witnesses, const Box& centers,
              const Interval& angles = 0.0, const RailTravel* travel = nullptr);

  /// Climbs from a start. @param precision of the size
  /// @return the best candidate whose witness points satisfy the criterion; size <= 0 when there is none
  Candidate climb(const Candidate& start, double precision);

private:
  struct Step
  {
    Candidate candidate;
    double violation;  ///< how far the worst witness point misses the criterion or is inside, as a length [m]
  };

  /// How a bad point leaves a region.
  struct Exit
  {
    Eigen::Vector3d normal;
    double support;  ///< how the normal's support grows with the size
    double depth;    ///< how far inside the point is [m]
    double turn;     ///< how that grows with the angle [m]
  };

  Step assess(const Candidate& candidate);
  bool reachesInto(const StrutSphere& sphere, const Candidate& candidate) const;
  double excessOf(const Candidate& candidate) const;
  Exit exitOf(const Candidate& candidate, const Eigen::Vector3d& point) const;
  void addExits(double trust);
  double merit(const Step& step) const;
  Candidate propose(const Step& step, double trust);
  void linearize(double trust);
  void addRow(const AffineForm<double>& form, double trust, std::size_t witness);
  double largestTurn(double trust) const;
  Eigen::Vector3d sweepOf(std::size_t witness) const;
  void addSpheres(double trust);
  bool addCuts(double trust);

  const BoxTest& test_;
  const Shape& shape_;
  const WitnessPoints& witnesses_;
  Box centers_;
  Interval angles_;
  const RailTravel* travel_;
  std::vector<StrutSphere> spheres_;  ///< none of bodies that are not convex
  double scale_;                      ///< the longest strut [m]
  double reach_;                      ///< how the largest half extent grows with the size
  double slack_ = 0.0;                ///< largest violation that the programme may leave [m]
  Candidate from_;                    ///< that the programme is about
  double turn_ = 0.0;                 ///< largest turn that it may propose [rad]
  LinearProgramme<6> programme_;  ///< unknowns: steps of center, size and violation in units of the trust region; turn
  std::vector<GrowingVector> places_;      ///< of the witness points, at that candidate
  std::vector<Eigen::Vector3d> bad_;       ///< those near to it
  std::vector<NecessaryForms> necessary_;  ///< one for each witness point
  std::vector<double> margins_;
};
}  // namespace pkm_workspace
