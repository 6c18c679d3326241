// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/interval/interval_vector.h"
#include "pkm_workspace/machine/leg_bounds.h"
#include "pkm_workspace/machine/passive_joints.h"
#include "pkm_workspace/machine/strut_tolerance.h"

namespace pkm_workspace
{
/// A kind of leg (paper, section 3.1): a slider on a rail, and a strut of fixed length (a parallelogram, so that the
/// platform never turns) from the slider point A to the platform point B. Its joint value moves the slider. Lengths
/// [m], all in the machine's root frame. The formulas are in sliding_strut_forms.h.
struct SlidingStrut : PassiveJoints
{
  IntervalVector origin;    ///< a: slider point A at joint value 0 [m]
  IntervalVector axis;      ///< e: unit direction of the rail
  IntervalVector platform;  ///< b: platform point B seen from the tool point P [m]
  Interval length = 1.0;    ///< L: strut length |AB| [m]
  int working_mode = 1;     ///< s: sign of eta = (strut vector) . e, +1 or -1
  /// Rails that are known to share one direction have the same number here, or the opposite one where they point
  /// against each other. 0: no more is known than the axis.
  int direction = 0;
  /// The numbers above are what was meant; what was built is within these.
  StrutTolerance tolerance = {};
};

/// A sliding strut as its formulas need it, in the constants of one arithmetic (docs/theory.md; paper, section 3.2).
/// Row is what dotOffset() takes for a vector.
template <class Number, class Vector, class Matrix, class Row>
struct StrutConstants
{
  Matrix projector;       ///< I - e e^T
  Row along;              ///< e
  Vector center;          ///< c = a - b [m]
  Vector axis;            ///< e, the unit direction of the rail
  Number squared_length;  ///< L^2 [m^2]
  Number sign;            ///< s, the working mode
};

struct EnclosedStrut : StrutConstants<Interval, IntervalVector, IntervalMatrix, IntervalVector>
{
  Interval length;  ///< L [m]
};

/// Of all struts within its tolerances.
EnclosedStrut enclosed(const SlidingStrut& strut);

// What a machine asks of each kind of leg.

/// Collects what is wrong with the leg by itself.
void validate(const SlidingStrut& strut, const std::string& place, Problems& problems);
/// Collects what is wrong with joint limits for it.
inline void validateLimits(const SlidingStrut& /*strut*/, const Interval& /*limits*/, const std::string& /*place*/,
                           Problems& /*problems*/)
{}
/// Its numbers, digit by digit: legs with the same text are the same. Other kinds begin with their name.
std::string exactText(const SlidingStrut& strut);
/// The same leg in the frame where a point p is R p + t.
SlidingStrut moved(const SlidingStrut& strut, const IntervalMatrix& rotation, const IntervalVector& translation);
/// The leg at a share t of the way from one to the other: exact at both ends, and where both numbers are the same.
/// @throws std::invalid_argument where there is none between
SlidingStrut between(const SlidingStrut& first, const SlidingStrut& last, const Interval& t);
/// Why no leg is between these; "" where each share has one.
std::string differenceOfModes(const SlidingStrut& first, const SlidingStrut& last);
/// The line along which the tool may move with nothing changed but the joint value, which it changes as much.
inline const IntervalVector* slideOf(const SlidingStrut& strut)
{
  return &strut.axis;
}

/// For logs: "strut 0.5 m".
std::string describe(const SlidingStrut& strut);
/// By what a joint velocity is multiplied before transmission factors compare it with others: 1, of an angle [m].
inline Interval driveScale(const SlidingStrut& /*strut*/)
{
  return 1.0;
}
/// Whether its joint value is an angle [rad].
inline bool hasAngle(const SlidingStrut& /*strut*/)
{
  return false;
}

// What bounds follow from a leg by itself, for all of its working mode. @param steepest encloses the largest |n| / b
// that is asked for, or nothing

/// What its size is measured by [m].
inline const Interval& lengthOf(const EnclosedStrut& strut)
{
  return strut.length;
}
/// The points that it can reach.
OuterBound outerBound(const EnclosedStrut& strut, const std::optional<Interval>& steepest);
/// b there [m].
Interval driveRange(const EnclosedStrut& strut, const std::optional<Interval>& steepest);
/// The joint values there [m]. @param along encloses u . p over the points that count
Interval jointRange(const EnclosedStrut& strut, const std::optional<Interval>& steepest,
                    const std::function<Interval(const IntervalVector& u)>& along);
/// Encloses the points with these joint values [m].
IntervalVector pointsWithin(const EnclosedStrut& strut, const Interval& joints,
                            const std::optional<Interval>& steepest);
/// Encloses what the leg's reach is measured by at p, and the most that it may be [m]: |q| and L.
LegReach reachAt(const EnclosedStrut& strut, const IntervalVector& p);
/// Bounds the volume of the points that the leg reaches with these joint values [m^3].
Interval volumeOfJoints(const EnclosedStrut& strut, const Interval& joints);

// In floating point.

/// The sphere on which the tool is when the joint has this value [m].
LegSphere sphereAt(const EnclosedStrut& strut, double joint);
/// The point that the joint moves: the slider A [m].
Eigen::Vector3d drivenPoint(const SlidingStrut& strut, double joint);
/// Whether a row n of the parallel Jacobian belongs to the leg's working mode at this joint value.
bool isInMode(const EnclosedStrut& strut, double joint, const Eigen::Vector3d& row);
}  // namespace pkm_workspace
