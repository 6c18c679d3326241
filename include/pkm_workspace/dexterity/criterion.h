// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pkm_workspace/common/budget.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/interval/interval.h"
#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// A number of each leg, in their order; 0 where none is known.
using JointValues = std::array<double, 3>;

/// What is asked of every point of a region (paper, section 2.1.1): that the struts reach it, and each of the bounds
/// that are set. Values with defaults; validate() tells what is wrong.
struct Criterion
{
  // Elsewhere, for what is compiled for one instruction set only must not be what all others get.
  Criterion();
  Criterion(const Criterion& other);
  Criterion(Criterion&& other) noexcept;
  Criterion& operator=(const Criterion& other);
  Criterion& operator=(Criterion&& other) noexcept;
  ~Criterion();

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

  // Of a machine with motors and tolerances (docs/conditions.md); 0 = none is asked for. In every direction of the
  // tool:
  double tool_speed_min = 0.0;      ///< least speed that the joints allow [m/s]
  double tool_force_min = 0.0;      ///< least static force that the joints allow [N]
  double stiffness_min = 0.0;       ///< least stiffness [N/m]
  double position_error_max = 0.0;  ///< largest error of position, to first order in the joints' errors; of a machine
                                    ///< with tolerances, of these too, to all orders [m]
  // Of each strut against its rail:
  double strut_angle_min = 0.0;  ///< least angle, in (0, pi/2) [rad]
  double strut_angle_max = 0.0;  ///< largest angle, >= strut_angle_min [rad]
  double ball_tilt_max = 0.0;    ///< largest tilt of its ball joints from their axes, in (0, pi/2) [rad]
  bool hinge_limits = false;     ///< whether the limits of the machine's passive hinges hold too

  // What these count with (joint_data.h).
  JointValues joint_speed_max{};   ///< [m/s], for tool_speed_min
  JointValues joint_effort_max{};  ///< [N], for tool_force_min
  JointValues joint_stiffness{};   ///< of the drives [N/m], for stiffness_min
  JointValues strut_stiffness{};   ///< along the struts [N/m], for stiffness_min; 0 = rigid
  JointValues joint_error_max{};   ///< [m], for position_error_max
  /// Which joints have angles for values, so that their numbers are in [rad/s], [N m], [N m/rad] and [rad]: for words
  /// only, as withJointData() sets it.
  std::array<bool, 3> has_angle{};
  JointValues strut_tilt_max{};  ///< of each strut's ball joints [rad], where it is less than ball_tilt_max

  std::vector<Zone> zones;   ///< that the tool keeps within or out of
  double tool_radius = 0.0;  ///< by which all of them are moved, away from what the tool has to keep to [m]

  /// Appends one sentence for each value that is out of range.
  void validate(Problems& problems) const;

  /// Whether velocity or force factors bound psi from below, or from above.
  bool boundsBelow() const { return set == Set::DEXTROUS || force_max > 0.0; }
  bool boundsAbove() const { return set == Set::DEXTROUS || force_min > 0.0; }
  bool boundsCondition() const { return kappa_max > 0.0; }
  /// Whether anything is asked of the factors. Where it is not, the set is bounded by single conditions.
  bool boundsFactors() const { return boundsBelow() || boundsAbove() || boundsCondition() || boundsMore(); }
  /// Whether anything is asked of speeds, forces, stiffness, errors or angles.
  bool boundsMore() const
  {
    return definesSign() || tool_speed_min > 0.0 || strut_angle_min > 0.0 || strut_angle_max > 0.0 ||
           ball_tilt_max > 0.0 || hinge_limits;
  }
  /// What the ball joints of a leg's strut may tilt by [rad]; 0 = any.
  double tiltOf(std::size_t leg) const
  {
    return strut_tilt_max[leg] > 0.0 && strut_tilt_max[leg] < ball_tilt_max ? strut_tilt_max[leg] : ball_tilt_max;
  }
  /// Whether det A has no zero in the set, so that one point of a connected region settles its sign.
  /// @param is_tolerated whether it is asked of all machines within tolerances: errors of position are then about the
  /// nominal one
  bool settlesAspect(bool is_tolerated = false) const
  {
    return boundsBelow() || boundsCondition() || definesSign(is_tolerated);
  }
  /// Encloses the larger of psi_min and 1 / force_max. @pre boundsBelow()
  Interval leastFactor() const;
  /// Encloses the smaller of psi_max and 1 / force_min. @pre boundsAbove()
  Interval largestFactor() const;

private:
  /// Whether a condition fails where det A is 0, besides those on factors.
  bool definesSign(bool is_tolerated = false) const
  {
    return tool_force_min > 0.0 || stiffness_min > 0.0 || (position_error_max > 0.0 && !is_tolerated);
  }
};

/// Whether they ask for the same: criterion_bytes.h.
bool operator==(const Criterion& a, const Criterion& b);

/// All that the criterion asks for, in words; each number tells itself from all others.
std::string describe(const Criterion& criterion);
}  // namespace pkm_workspace
