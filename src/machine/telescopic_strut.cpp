// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/telescopic_strut.h"

#include <algorithm>
#include <cmath>

#include "numbers.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/machine/telescopic_strut_forms.h"

namespace pkm_workspace
{
EnclosedTelescope enclosed(const TelescopicStrut& strut)
{
  return { UNIT_MATRIX, strut.foot - strut.platform, strut.length };
}

void validate(const TelescopicStrut& strut, const std::string& place, Problems& problems)
{
  if (!isBounded(strut.foot) || !isBounded(strut.platform))
    complain(problems, place, ": foot and platform point must be finite numbers");
  else if (!isOrdinary(strut.foot) || !isOrdinary(strut.platform))
    complain(problems, place, ": foot and platform point must be within 1e9 m");
  if (!isOrdinaryLength(strut.length))
    complain(problems, place, ": strut length ", strut.length, " m at joint value 0 must be from 1e-9 m to 1e9 m");
}

void validateLimits(const TelescopicStrut& strut, const Interval& limits, const std::string& place, Problems& problems)
{
  if (std::isfinite(limits.lower()) && !(strut.length + Interval(limits.lower())).certainlyPositive())
    complain(problems, place, ": at its lower joint limit ", limits.lower(), " m its strut of ", strut.length.mid(),
             " m has no length left: the limit must be above ", -strut.length.mid(), " m");
}

std::string exactText(const TelescopicStrut& strut)
{
  return " telescopic" + exactText(strut.foot) + exactText(strut.platform) + exactText(strut.length) +
         exactText(static_cast<const PassiveJoints&>(strut));
}

TelescopicStrut moved(const TelescopicStrut& strut, const IntervalMatrix& rotation, const IntervalVector& translation)
{
  TelescopicStrut result = strut;
  result.foot = rotation * strut.foot + translation;
  result.platform = rotation * strut.platform;
  turn(rotation, result);
  return result;
}

TelescopicStrut between(const TelescopicStrut& first, const TelescopicStrut& last, const Interval& t)
{
  return { between(static_cast<const PassiveJoints&>(first), last), between(first.foot, last.foot, t),
           between(first.platform, last.platform, t), between(first.length, last.length, t) };
}

std::string describe(const TelescopicStrut& strut)
{
  TextStream text;
  text << "strut of variable length, " << strut.length.mid() << " m at 0";
  return text.str();
}

OuterBound outerBound(const EnclosedTelescope& strut, const std::optional<Interval>& /*steepest*/)
{
  return { IntervalMatrix{}, strut.center, Interval(1.0) };
}

Interval driveRange(const EnclosedTelescope& /*strut*/, const std::optional<Interval>& /*steepest*/)
{
  return { 0.0, INF };
}

Interval jointRange(const EnclosedTelescope& strut, const std::optional<Interval>& /*steepest*/,
                    const std::function<Interval(const IntervalVector&)>& along)
{
  IntervalVector x;
  for (std::size_t k = 0; k < 3; ++k)
    x[k] = along(UNIT_MATRIX[k]) - strut.center[k];
  return sqrtAboveZero(squaredNorm(x)) - strut.length;
}

IntervalVector pointsWithin(const EnclosedTelescope& strut, const Interval& joints,
                            const std::optional<Interval>& /*steepest*/)
{
  const double longest = std::max(0.0, (strut.length + joints).upper());
  const Interval either(-longest, longest);
  return strut.center + IntervalVector{ either, either, either };
}

LegReach reachAt(const EnclosedTelescope& strut, const IntervalVector& p)
{
  return { Interval(0.0), norm(p - strut.center) };
}

/// A ball, less one within it.
Interval volumeOfJoints(const EnclosedTelescope& strut, const Interval& joints)
{
  const auto cube = [&strut](double joint) {
    const Interval length = strut.length + Interval(joint);
    return Interval(std::max(0.0, length.lower()), std::max(0.0, length.upper())) * sqr(length);
  };
  return Interval(4.0) / Interval(3.0) * pi() * (cube(joints.upper()) - cube(joints.lower()));
}

LegSphere sphereAt(const EnclosedTelescope& strut, double joint)
{
  return { mid(strut.center), strut.length.mid() + joint };
}

Eigen::Vector3d drivenPoint(const TelescopicStrut& strut, double /*joint*/)
{
  return mid(strut.foot);
}

bool evaluateNear(const EnclosedTelescope& strut, const Eigen::Vector3d& p, LegAtPoint& leg)
{
  const PlainTelescope<double> constants = plain(ofForms<double>(strut));
  const PlainVector<double> point = { p.x(), p.y(), p.z() };
  evaluate(
      constants, point, [](double x) { return std::sqrt(x); }, leg.state);
  leg.joint = jointOf(constants, point, leg.state);
  return true;
}
}  // namespace pkm_workspace
