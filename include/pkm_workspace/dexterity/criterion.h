// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/common/budget.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// What is asked of every point of a region (paper, section 2.1.1): that the struts reach it, and each of the bounds
/// that are set. Values with defaults; validate() tells what is wrong.
struct Criterion
{
  /// Whether the velocity transmission factors psi are bounded: DEXTROUS asks for psi_min and psi_max, REACHABLE does
  /// not.
  enum class Set
  {
    DEXTROUS,
    REACHABLE
  };

  /// Which sign of det A counts: the machine's own, the opposite one, or either of them.
  enum class Aspect
  {
    OWN,
    OTHER,
    BOTH
  };

  /// The sign of det A that counts, for a machine whose own is that: 1 or -1, or 0 for either.
  int wantedSign(int own) const { return aspect == Aspect::BOTH ? 0 : aspect == Aspect::OWN ? own : -own; }

  Set set = Set::DEXTROUS;
  Aspect aspect = Aspect::OWN;
  double psi_min = 0.5;       ///< least velocity transmission factor, without unit, > 0
  double psi_max = 2.0;       ///< largest velocity transmission factor, without unit, >= psi_min
  double force_min = 0.0;     ///< least force transmission factor 1 / psi, without unit, > 0; 0 = none is asked for
  double force_max = 0.0;     ///< largest force transmission factor, without unit, >= force_min; 0 = none
  double kappa_max = 0.0;     ///< largest condition number psi_3 / psi_1 of J, without unit, >= 1; 0 = none
  bool joint_limits = false;  ///< whether the joint limits of the machine hold too

  /// Appends one sentence for each value that is out of range.
  void validate(Problems& problems) const;

  /// Whether velocity or force factors bound psi from below, or from above.
  bool boundsBelow() const { return set == Set::DEXTROUS || force_max > 0.0; }
  bool boundsAbove() const { return set == Set::DEXTROUS || force_min > 0.0; }
  bool boundsCondition() const { return kappa_max > 0.0; }
  /// Whether anything is asked of the factors. Where it is not, the set is bounded by single conditions.
  bool boundsFactors() const { return boundsBelow() || boundsAbove() || boundsCondition(); }
  /// Whether det A has no zero in the set, so that one point of a connected region settles its sign.
  bool settlesAspect() const { return boundsBelow() || boundsCondition(); }
  /// Encloses the larger of psi_min and 1 / force_max. @pre boundsBelow()
  Interval leastFactor() const;
  /// Encloses the smaller of psi_max and 1 / force_min. @pre boundsAbove()
  Interval largestFactor() const;
};

/// Whether they ask for the same: criterion_bytes.h.
bool operator==(const Criterion& a, const Criterion& b);

/// All that the criterion asks for, in words; each number tells itself from all others.
std::string describe(const Criterion& criterion);
}  // namespace pkm_workspace
