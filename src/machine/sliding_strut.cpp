// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/sliding_strut.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numbers.h"
#include "pkm_workspace/machine/sliding_strut_forms.h"

namespace pkm_workspace
{
namespace
{
IntervalMatrix projectorAcross(const IntervalVector& axis)
{
  IntervalMatrix projector;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
    {
      const Interval product = row == column ? sqr(axis[row]) : axis[row] * axis[column];
      projector[row][column] = Interval(row == column ? 1.0 : 0.0) - product;
    }
  return projector;
}

IntervalVector directionBetween(const IntervalVector& first, const IntervalVector& last, const Interval& t)
{
  const IntervalVector sum = between(first, last, t);
  if (first == last || sum == first || sum == last)
    return sum;
  const Interval length = norm(sum);
  if (!length.certainlyPositive())
    throw std::invalid_argument("the rails of the two machines point in opposite directions");
  return { sum[0] / length, sum[1] / length, sum[2] / length };
}
Interval eitherWay(const Interval& x)
{
  return { -x.upper(), x.upper() };
}

/// c = a - b of all struts within the tolerances. A joint value that is wrong by z is that of a slider z back on its
/// rail.
IntervalVector centersOf(const SlidingStrut& strut, const IntervalVector& axis)
{
  const StrutTolerance& by = strut.tolerance;
  IntervalVector center = strut.origin - strut.platform;
  if (by.isZero())
    return center;
  for (std::size_t k = 0; k < 3; ++k)
  {
    Interval sum = eitherWay(Interval(by.slider_ball) + Interval(by.platform_ball));
    for (std::size_t j = 0; j < 3; ++j)
      sum += by.axes[k][j] * eitherWay(Interval(by.slider[j]) + Interval(by.platform[j]));
    center[k] += sum + eitherWay(by.zero) * axis[k];
  }
  return center;
}

/// The directions within the tolerance: two unit vectors at an angle t are 2 sin (t / 2) <= t apart.
IntervalVector directionsOf(const SlidingStrut& strut)
{
  IntervalVector axis = strut.axis;
  if (strut.tolerance.direction > 0.0)
    for (Interval& component : axis)
      component = intersection(component + eitherWay(strut.tolerance.direction), Interval(-1.0, 1.0));
  return axis;
}
}  // namespace

EnclosedStrut enclosed(const SlidingStrut& strut)
{
  EnclosedStrut constants;
  constants.along = constants.axis = directionsOf(strut);
  constants.projector = projectorAcross(constants.axis);
  constants.center = centersOf(strut, constants.axis);
  constants.length = strut.tolerance.length > 0.0 ? strut.length + eitherWay(strut.tolerance.length) : strut.length;
  constants.squared_length = sqr(constants.length);
  constants.sign = Interval(strut.working_mode);
  return constants;
}

namespace
{
/// A tenth of a strut is no tolerance, but a number in another unit.
void validateTolerance(const SlidingStrut& strut, const std::string& place, Problems& problems)
{
  constexpr double MOST_SHARE = 0.1;
  const StrutTolerance& by = strut.tolerance;
  const double most = MOST_SHARE * strut.length.mid();
  const auto check = [&](const char* what, double value) {
    if (value > most)
      complain(problems, place, ": a tolerance of ", value, " m of ", what, " must be at most ", most,
               " m, a tenth of the strut's length");
  };
  check("its strut's length", by.length);
  check("its joint's zero", by.zero);
  check("its slider point", *std::max_element(by.slider.begin(), by.slider.end()) + by.slider_ball);
  check("its platform point", *std::max_element(by.platform.begin(), by.platform.end()) + by.platform_ball);
}
}  // namespace

void validate(const SlidingStrut& strut, const std::string& place, Problems& problems)
{
  if (!isBounded(strut.origin) || !isBounded(strut.platform) || !isBounded(strut.axis))
    complain(problems, place, ": rail origin, axis and platform point must be finite numbers");
  else if (!isOrdinary(strut.origin) || !isOrdinary(strut.platform))
    complain(problems, place, ": rail origin and platform point must be within 1e9 m");
  else if (!squaredNorm(strut.axis).contains(1.0))
    complain(problems, place, ": the axis must have unit length, its squared length is ", squaredNorm(strut.axis));
  if (!isOrdinaryLength(strut.length))
    complain(problems, place, ": strut length ", strut.length, " m must be from 1e-9 m to 1e9 m");
  validateTolerance(strut, place, problems);
  if (strut.working_mode != 1 && strut.working_mode != -1)
    complain(problems, place, ": working mode ", strut.working_mode, " must be +1 or -1");
}

std::string exactText(const SlidingStrut& strut)
{
  return " mode " + std::to_string(strut.working_mode) + exactText(strut.origin) + exactText(strut.axis) +
         exactText(strut.platform) + exactText(strut.length) + exactText(static_cast<const PassiveJoints&>(strut)) +
         exactText(strut.tolerance);
}

SlidingStrut moved(const SlidingStrut& strut, const IntervalMatrix& rotation, const IntervalVector& translation)
{
  SlidingStrut result = strut;
  result.origin = rotation * strut.origin + translation;
  result.axis = rotation * strut.axis;
  result.platform = rotation * strut.platform;
  turn(rotation, result);
  result.tolerance.axes = rotation * strut.tolerance.axes;
  return result;
}

SlidingStrut between(const SlidingStrut& first, const SlidingStrut& last, const Interval& t)
{
  SlidingStrut strut = first;
  static_cast<PassiveJoints&>(strut) = between(static_cast<const PassiveJoints&>(first), last);
  strut.origin = between(first.origin, last.origin, t);
  strut.axis = directionBetween(first.axis, last.axis, t);
  strut.platform = between(first.platform, last.platform, t);
  strut.length = between(first.length, last.length, t);
  return strut;
}

std::string differenceOfModes(const SlidingStrut& first, const SlidingStrut& last)
{
  if (first.working_mode != last.working_mode)
    return "have opposite working modes";
  if (exactText(first.tolerance) != exactText(last.tolerance))
    return "have different tolerances: give both the same";
  return differenceOf(first, last);
}

std::string describe(const SlidingStrut& strut)
{
  TextStream text;
  text << "strut " << strut.length.mid() << " m";
  return text.str();
}

/// Where b^2 = L^2 - |q|^2 is at least L^2 / steepest^2 (paper, section 4.2; with the margin that psi_max gives).
OuterBound outerBound(const EnclosedStrut& strut, const std::optional<Interval>& steepest)
{
  const Interval radius =
      steepest ? strut.length * sqrtAboveZero(Interval(1.0) - Interval(1.0) / sqr(*steepest)) : strut.length;
  return { strut.projector, strut.center, radius };
}

/// s times L / steepest to L, or s times 0 to L.
Interval driveRange(const EnclosedStrut& strut, const std::optional<Interval>& steepest)
{
  const double longest = strut.length.upper();
  const double least = steepest ? (strut.length / *steepest).lower() : 0.0;
  return strut.sign * Interval(std::min(least, longest), longest);
}

/// rho = e . (p - c) - eta.
Interval jointRange(const EnclosedStrut& strut, const std::optional<Interval>& steepest,
                    const std::function<Interval(const IntervalVector&)>& along)
{
  return along(strut.axis) - dot(strut.axis, strut.center) - driveRange(strut, steepest);
}

/// p = c + q + t e, where t = rho + eta and |eta| <= L.
IntervalVector pointsWithin(const EnclosedStrut& strut, const Interval& joints, const std::optional<Interval>& steepest)
{
  const Interval eta = driveRange(strut, std::nullopt);
  return strut.center + outerBound(strut, steepest).offsets() + (joints + eta) * strut.axis;
}

LegReach reachAt(const EnclosedStrut& strut, const IntervalVector& p)
{
  LegState<Interval, IntervalVector> state;
  evaluateAcross(strut, p, state);
  return { norm(state.row), strut.length };
}

/// For each offset across the rail, of which there are pi L^2, joint value and way along it differ by a constant.
Interval volumeOfJoints(const EnclosedStrut& strut, const Interval& joints)
{
  return pi() * sqr(strut.length) * (Interval(joints.upper()) - Interval(joints.lower()));
}

/// The root of L^2 - |q|^2 is taken of (L - |q|) (L + |q|).
bool evaluateNear(const EnclosedStrut& strut, const Eigen::Vector3d& p, LegAtPoint& leg)
{
  const PlainStrut<double> constants = plain(ofForms<double>(strut));
  const PlainVector<double> point = { p.x(), p.y(), p.z() };
  const double length = strut.length.mid();
  double across = 0.0;
  const auto root = [&, &q = leg.state.row](double) {
    across = std::sqrt(squaredNorm(q));  // the row is q as yet
    return std::sqrt(std::max(0.0, (length - across) * (length + across)));
  };
  evaluate(constants, point, root, leg.state);
  leg.joint = jointOf(constants, point, leg.state);
  return across <= length;
}

LegSphere sphereAt(const EnclosedStrut& strut, double joint)
{
  return { mid(strut.center) + joint * mid(strut.axis), strut.length.mid() };
}

Eigen::Vector3d drivenPoint(const SlidingStrut& strut, double joint)
{
  return mid(strut.origin) + joint * mid(strut.axis);
}

bool isInMode(const EnclosedStrut& strut, double /*joint*/, const Eigen::Vector3d& row)
{
  return strut.sign.mid() * row.dot(mid(strut.axis)) > 0.0;
}
}  // namespace pkm_workspace
