// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/interval_vector.h"
#include "pkm_workspace/machine/leg.h"

namespace pkm_workspace
{
/// The geometry of a translational machine with three legs: a value, immutable once made.
///
/// Every number is an enclosure of the exact number it stands for (mostly of zero or one-ulp width). Legs that
/// share a direction have one enclosure of it.
///
/// Formulas (docs/theory.md; paper, section 3.2): A pdot = B qdot, where a leg with its joint value q gives a row n of
/// A and an entry b of the diagonal B (leg_state.h), and J^-1 = B^-1 A. For sliding struts n = d, b = eta and q = rho.
/// Thread-safe: it is never written to after construction.
class Machine
{
public:
  using Legs = std::array<Leg, 3>;

  /// @param name of the machine
  /// @param legs in the order of the joints
  /// @param zero tool point of the assembled zero configuration [m]: its det A fixes the aspect of the machine
  /// @throws std::invalid_argument listing everything that is wrong: not finite, axis not of unit length, length not
  /// positive, axes apart that are said to share a direction, working mode not +-1, zero not reachable, a serial or
  /// parallel singularity at zero
  Machine(std::string name, Legs legs, const Eigen::Vector3d& zero);

  const std::string& name() const { return name_; }
  const Legs& legs() const { return legs_; }
  const Leg& leg(int i) const { return legs_[static_cast<std::size_t>(i)]; }
  /// Leg i, prepared for its formulas: all within its tolerances.
  const EnclosedLeg& enclosed(int i) const { return enclosed_[static_cast<std::size_t>(i)]; }
  /// The same without tolerances, as it was meant: for floating point.
  const EnclosedLeg& meant(int i) const { return meant_[static_cast<std::size_t>(i)]; }
  /// The point c of leg i [m]: its formulas depend on p - c.
  const IntervalVector& center(int i) const;
  /// Tool point of the zero configuration [m].
  const Eigen::Vector3d& zero() const { return zero_; }
  /// Sign of det A in the machine's own aspect: +1 or -1.
  int aspect() const { return aspect_; }
  /// Whether all three legs are known to slide in one direction: then nothing but the joint values changes along it.
  bool hasParallelRails() const;
  /// Whether it stands for all machines within tolerances: what is said of it holds for each of them.
  bool hasTolerances() const;
  /// Whether any joint has a limit.
  bool hasJointLimits() const;
  /// Whether any passive hinge has one.
  bool hasHingeLimits() const;
  /// Along the strut of leg i, from A to B, where its ball joints are not tilted; of any length.
  std::vector<IntervalVector> ballAxes(int i) const;
  /// The largest length of a leg, rounded up [m]: the scale of everything.
  double scale() const;
  /// A name for exactly this geometry, limits, working mode and aspect included: a UUID (version 5).
  std::string geometryHash() const;

  /// The same machine with other joint limits, working modes or aspect is another value: copy legs() and construct.
private:
  std::string name_;
  Legs legs_;
  Eigen::Vector3d zero_;
  std::array<EnclosedLeg, 3> enclosed_;
  std::array<EnclosedLeg, 3> meant_;
  int aspect_ = 1;
};

/// The machine as it stands at one tool point: enclosures of everything that section 3.2 of the paper names.
struct Configuration
{
  IntervalVector rho;                   ///< joint values [m]
  IntervalVector eta;                   ///< d . e per leg [m]; 0 at a serial singularity
  std::array<IntervalVector, 3> strut;  ///< d = vector from A to B, per leg [m]: the rows of A
  Interval det_a;                       ///< det A [m^3]; 0 at a parallel singularity
};

/// Inverse kinematics in the machine's working mode.
/// @param p tool point [m], or a set of them
/// @return enclosures over p, or nothing when a leg is not proved to reach every point of p
std::optional<Configuration> configurationAt(const Machine& machine, const IntervalVector& p);
std::optional<Configuration> configurationAt(const Machine& machine, const Eigen::Vector3d& p);

/// Inverse kinematics in floating point. @return rho [m], or nothing where a leg does not reach.
std::optional<Eigen::Vector3d> inverseKinematics(const Machine& machine, const Eigen::Vector3d& p);

/// Forward kinematics in floating point: the tool point with the machine's working mode in every leg and its sign of
/// det A.
/// @param rho joint values [m] @return the tool point [m], or nothing when no assembly of that kind exists
std::optional<Eigen::Vector3d> forwardKinematics(const Machine& machine, const Eigen::Vector3d& rho);

/// Jacobians of the machine at a reachable point, in floating point (paper, section 3.2).
struct Jacobians
{
  Eigen::Matrix3d a;          ///< parallel Jacobian A: rows are the struts d^T [m]
  Eigen::Vector3d b;          ///< diagonal of the serial Jacobian B: eta [m]
  Eigen::Matrix3d j_inverse;  ///< J^-1 = B^-1 A: joint velocities of a tool velocity
  Eigen::Matrix3d j;          ///< J = A^-1 B: tool velocity of joint velocities
};

/// @return nothing where a leg does not reach or stands at a serial singularity. At a parallel one J is huge or not
/// finite.
std::optional<Jacobians> jacobians(const Machine& machine, const Eigen::Vector3d& p);

/// Velocity transmission factors psi: the singular values of J^-1, ascending, in floating point (paper, section 2.1.1).
Eigen::Vector3d transmissionFactors(const Jacobians& jacobians);

/// How near a configuration is to the singularities of section 3.2 of the paper, without units:
/// serial = min |b_i| / |n_i| and parallel = |det A| / (|n_1| |n_2| |n_3|), both in [0, 1], 0 at the singularity.
struct SingularityMeasures
{
  double serial;
  double parallel;
};
SingularityMeasures singularityMeasures(const Jacobians& jacobians);
}  // namespace pkm_workspace
