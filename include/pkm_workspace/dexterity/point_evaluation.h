// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
/// One of the conditions that a criterion is made of, at one tool point.
struct Limit
{
  using Kind = ConditionKind;

  Kind kind = Kind::REACH;
  int leg = -1;          ///< 0, 1, 2; -1 where the condition is about all legs
  Interval value = 0.0;  ///< encloses what is bounded
  double bound = 0.0;    ///< what bounds it
  /// Encloses how far it is within its bound, in the same unit; negative where it is violated
  Interval margin = 0.0;
  /// Of a hinge which one of SlidingStrut::stops, of a zone which one of Criterion::zones; otherwise -1.
  int which = -1;
  std::string zone = {};  ///< what a zone is called; otherwise empty

  bool isViolated() const { return margin.certainlyNegative(); }
};

/// The limits of the joints that the machine has, where it stands like this.
std::vector<Limit> jointLimits(const Machine& machine, const std::array<Interval, 3>& rho);

/// "reach", "joint_lower", ..., "kappa_max".
std::string name(Limit::Kind kind);

/// The machine at one tool point. Enclosures, except where it says otherwise.
struct PointEvaluation
{
  BoxVerdict verdict = BoxVerdict::UNDECIDED;       ///< whether the point satisfies the criterion
  BoxVerdict within_reach = BoxVerdict::UNDECIDED;  ///< whether all struts reach it, in whatever aspect
  /// Everything else is there where they are proved to, away from serial singularities.
  bool has_values = false;
  std::array<Interval, 3> psi;  ///< velocity transmission factors, ascending
  std::array<Interval, 3> rho;  ///< joint values [m]
  Interval condition = 0.0;     ///< psi_3 / psi_1; unbounded at parallel singularities
  Interval det_a = 0.0;         ///< [m^3]
  std::vector<Limit>
      limits = {};  ///< all that the criterion asks for; only those on the reach where there is nothing else

  /// The one that is violated most, or that is nearest to be: margins are compared over the length of the longest strut
  /// for lengths, over the larger of value and bound for factors. A criterion always asks for the reach.
  const Limit& binding() const;
  double scale = 1.0;  ///< length of the longest strut [m]
};

/// Evaluates points for one machine and criterion. Thread-safe: constant after construction.
class PointEvaluator
{
public:
  /// @throws std::invalid_argument when the criterion is not valid
  PointEvaluator(const Machine& machine, const Criterion& criterion);

  const Machine& machine() const { return machine_; }
  const Criterion& criterion() const { return criterion_; }
  const BoxTest& test() const { return test_; }
  /// @throws std::invalid_argument for a point that is not finite
  PointEvaluation operator()(const Eigen::Vector3d& point) const;

private:
  static void addValues(const Configuration& there, const PieceMotion& motion, PointEvaluation& result);

  Machine machine_;
  Criterion criterion_;
  BoxTest test_;
  BoxTest reach_test_;
};

/// The same once.
PointEvaluation evaluatePoint(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point);
}  // namespace pkm_workspace
