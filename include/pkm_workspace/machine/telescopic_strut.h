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
/// A kind of leg: a strut of variable length from a foot A, which stays where it is, to the platform point B, as the
/// legs of tripods and hexapods have it. Its joint value lengthens the strut. Lengths [m], all in the machine's root
/// frame. The formulas are in telescopic_strut_forms.h; what its functions are for, in sliding_strut.h.
struct TelescopicStrut : PassiveJoints
{
  IntervalVector foot;      ///< a: the point A [m]
  IntervalVector platform;  ///< b: platform point B seen from the tool point P [m]
  Interval length = 1.0;    ///< |AB| at joint value 0 [m]
};

/// In the constants of one arithmetic (docs/theory.md).
template <class Number, class Vector, class Matrix, class Row>
struct TelescopicConstants
{
  Matrix identity;
  Vector center;  ///< c = a - b [m]
  Number length;  ///< at joint value 0 [m]
};

using EnclosedTelescope = TelescopicConstants<Interval, IntervalVector, IntervalMatrix, IntervalVector>;

EnclosedTelescope enclosed(const TelescopicStrut& strut);

void validate(const TelescopicStrut& strut, const std::string& place, Problems& problems);
/// The strut has a length at every joint value within the limits.
void validateLimits(const TelescopicStrut& strut, const Interval& limits, const std::string& place, Problems& problems);
std::string exactText(const TelescopicStrut& strut);
TelescopicStrut moved(const TelescopicStrut& strut, const IntervalMatrix& rotation, const IntervalVector& translation);
TelescopicStrut between(const TelescopicStrut& first, const TelescopicStrut& last, const Interval& t);
inline std::string differenceOfModes(const TelescopicStrut& first, const TelescopicStrut& last)
{
  return differenceOf(first, last);
}
inline const IntervalVector* slideOf(const TelescopicStrut& /*strut*/)
{
  return nullptr;
}
std::string describe(const TelescopicStrut& strut);
inline Interval driveScale(const TelescopicStrut& /*strut*/)
{
  return 1.0;
}
inline bool hasAngle(const TelescopicStrut& /*strut*/)
{
  return false;
}

inline const Interval& lengthOf(const EnclosedTelescope& strut)
{
  return strut.length;
}
/// None: it may be as long as its limits allow.
OuterBound outerBound(const EnclosedTelescope& strut, const std::optional<Interval>& steepest);
Interval driveRange(const EnclosedTelescope& strut, const std::optional<Interval>& steepest);
Interval jointRange(const EnclosedTelescope& strut, const std::optional<Interval>& steepest,
                    const std::function<Interval(const IntervalVector& u)>& along);
IntervalVector pointsWithin(const EnclosedTelescope& strut, const Interval& joints,
                            const std::optional<Interval>& steepest);
/// It reaches every point: 0 and its length there.
LegReach reachAt(const EnclosedTelescope& strut, const IntervalVector& p);
Interval volumeOfJoints(const EnclosedTelescope& strut, const Interval& joints);

LegSphere sphereAt(const EnclosedTelescope& strut, double joint);
Eigen::Vector3d drivenPoint(const TelescopicStrut& strut, double joint);
inline bool isInMode(const EnclosedTelescope& /*strut*/, double /*joint*/, const Eigen::Vector3d& /*row*/)
{
  return true;
}
}  // namespace pkm_workspace
