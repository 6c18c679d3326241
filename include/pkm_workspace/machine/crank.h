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

namespace pkm_workspace
{
/// A kind of leg: a crank that turns about a fixed axis, and a forearm of fixed length from the crank's tip to the
/// platform point B, as the Delta has it. Its joint value is the crank's angle th [rad]: the tip is at
/// pivot + r (u cos th + v sin th). Lengths [m], all in the machine's root frame. The formulas are in crank_forms.h;
/// what its functions are for, in sliding_strut.h.
struct Crank : PassiveJoints
{
  IntervalVector pivot;     ///< the point of the axis about which the tip turns [m]
  IntervalVector along;     ///< u: unit direction of the crank at joint value 0
  IntervalVector across;    ///< v: unit direction across the crank's axis and u, in which its tip starts to turn
  Interval radius = 1.0;    ///< r: from the axis to the tip [m]
  IntervalVector platform;  ///< b: platform point B seen from the tool point P [m]
  Interval length = 1.0;    ///< L: of the forearm, from the tip to B [m]
  int working_mode = 1;     ///< s: sign of n . (v cos th - u sin th), the forearm along the way of the tip, +1 or -1
  /// Joint values are within pi of this [rad].
  double reference = 0.0;
  /// What transmission factors count a turn of 1 rad as [m]; 0: the radius, which makes it the way of the tip.
  double drive_scale = 0.0;
};

/// In the constants of one arithmetic (docs/theory.md). Row is what dotOffset() takes for a vector.
template <class Number, class Vector, class Matrix, class Row>
struct CrankConstants
{
  Matrix identity;
  Row row_u;  ///< u and v, turned to the reference
  Row row_v;
  Vector center;  ///< c = pivot - b [m]
  Vector u;
  Vector v;
  Number radius;           ///< r [m]
  Number half_per_radius;  ///< 1 / (2 r) [1/m]
  Number squares;          ///< r^2 - L^2 [m^2]
  Number squared_length;   ///< L^2 [m^2]
  Number sign;             ///< s, the working mode
  Number gear;             ///< r over the drive scale
  Number per_gear;         ///< its inverse
  Number per_scale;        ///< 1 over the drive scale [1/m]
  Number reference;        ///< [rad]
};

struct EnclosedCrank : CrankConstants<Interval, IntervalVector, IntervalMatrix, IntervalVector>
{
  Interval length;  ///< L [m]
};

EnclosedCrank enclosed(const Crank& crank);

void validate(const Crank& crank, const std::string& place, Problems& problems);
/// Both ends or none, within pi of the reference.
void validateLimits(const Crank& crank, const Interval& limits, const std::string& place, Problems& problems);
std::string exactText(const Crank& crank);
Crank moved(const Crank& crank, const IntervalMatrix& rotation, const IntervalVector& translation);
Crank between(const Crank& first, const Crank& last, const Interval& t);
std::string differenceOfModes(const Crank& first, const Crank& last);
inline const IntervalVector* slideOf(const Crank& /*crank*/)
{
  return nullptr;
}
std::string describe(const Crank& crank);
/// What transmission factors count a turn of 1 rad as [m].
inline Interval driveScale(const Crank& crank)
{
  return crank.drive_scale > 0.0 ? Interval(crank.drive_scale) : crank.radius;
}
inline bool hasAngle(const Crank& /*crank*/)
{
  return true;
}

/// Of the stretched leg, r + L.
inline Interval lengthOf(const EnclosedCrank& crank)
{
  return crank.radius + crank.length;
}
OuterBound outerBound(const EnclosedCrank& crank, const std::optional<Interval>& steepest);
Interval driveRange(const EnclosedCrank& crank, const std::optional<Interval>& steepest);
Interval jointRange(const EnclosedCrank& crank, const std::optional<Interval>& steepest,
                    const std::function<Interval(const IntervalVector& u)>& along);
IntervalVector pointsWithin(const EnclosedCrank& crank, const Interval& joints,
                            const std::optional<Interval>& steepest);
/// |k| and the distance of p - c from the crank's axis (docs/theory.md).
LegReach reachAt(const EnclosedCrank& crank, const IntervalVector& p);
Interval volumeOfJoints(const EnclosedCrank& crank, const Interval& joints);

LegSphere sphereAt(const EnclosedCrank& crank, double joint);
Eigen::Vector3d drivenPoint(const Crank& crank, double joint);
bool isInMode(const EnclosedCrank& crank, double joint, const Eigen::Vector3d& row);
}  // namespace pkm_workspace
