// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// One leg (paper, section 3.1): a slider on a rail, and a strut (a parallelogram, so that the platform never turns)
/// from the slider point A to the platform point B. Lengths [m], all in the machine's root frame.
struct Leg
{
  std::string joint = "";                ///< name of the prismatic joint
  IntervalVector origin;                 ///< a: slider point A at joint value 0 [m]
  IntervalVector axis;                   ///< e: unit direction of the rail
  IntervalVector platform;               ///< b: platform point B seen from the tool point P [m]
  Interval length = 1.0;                 ///< L: strut length |AB| [m]
  int working_mode = 1;                  ///< s: sign of eta = (strut vector) . e, +1 or -1
  Interval limits = Interval::entire();  ///< values that the prismatic joint may take [m]
  /// Rails that are known to share one direction have the same number here, or the opposite one where they point
  /// against each other. 0: no more is known than the axis.
  int direction = 0;
};

/// 1 where two rails are known to have the same direction, -1 for the opposite one, otherwise 0: their numbers say so,
/// or both axes are exact. Enclosures that are the same are no reason.
int parallelSense(const Leg& a, const Leg& b);

/// Numbers for Leg::direction. @param sense what parallelSense() is to be for legs i and j < i
std::array<int, 3> sharedDirections(const std::function<int(std::size_t i, std::size_t j)>& sense);
/// The same for legs that are to keep the directions that these share, when they are turned all together.
std::array<int, 3> sharedDirections(const std::array<Leg, 3>& legs);

/// The geometry of a translational machine with three legs: a value, immutable once made.
///
/// Every number is an enclosure of the exact number it stands for (mostly of zero or one-ulp width). Legs that
/// share a direction have one enclosure of it.
///
/// Formulas (docs/theory.md; paper, section 3.2), with c = a - b and p the tool point:
///   q = (I - e e^T)(p - c),  eta = s sqrt(L^2 - |q|^2),  strut d = q + eta e,  rho = e^T (p - c) - eta,
///   A pdot = B rhodot with A = rows d^T, B = diag(eta), J^-1 = B^-1 A.
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
  /// c = a - b of leg i [m].
  const IntervalVector& center(int i) const { return centers_[static_cast<std::size_t>(i)]; }
  /// I - e e^T of leg i.
  const IntervalMatrix& projector(int i) const { return projectors_[static_cast<std::size_t>(i)]; }
  /// Tool point of the zero configuration [m].
  const Eigen::Vector3d& zero() const { return zero_; }
  /// Sign of det A in the machine's own aspect: +1 or -1.
  int aspect() const { return aspect_; }
  /// Whether the three rails are known to be parallel: then nothing but the joint values changes along them.
  bool hasParallelRails() const;
  /// Whether any joint has a limit.
  bool hasJointLimits() const;
  /// The largest strut length, rounded up [m]: the scale of everything.
  double scale() const;
  /// A name for exactly this geometry, limits, working mode and aspect included: a UUID (version 5).
  std::string geometryHash() const;

  /// The same machine with other joint limits, working modes or aspect is another value: copy legs() and construct.
private:
  std::string name_;
  Legs legs_;
  Eigen::Vector3d zero_;
  std::array<IntervalVector, 3> centers_;
  std::array<IntervalMatrix, 3> projectors_;
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
/// serial = min |eta_i| / L_i and parallel = |det A| / (L_1 L_2 L_3), both in [0, 1], 0 at the singularity.
struct SingularityMeasures
{
  double serial;
  double parallel;
};
SingularityMeasures singularityMeasures(const Machine& machine, const Jacobians& jacobians);
}  // namespace pkm_workspace
