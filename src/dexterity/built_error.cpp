// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/conditions/built_error.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/built_error.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
BuiltLeg builtLeg(const SlidingStrut& strut, double error)
{
  const StrutTolerance& by = strut.tolerance;
  const Interval length = strut.length, angle = by.direction;
  const Interval balls = Interval(by.slider_ball) + Interval(by.platform_ball);
  const Interval drive = Interval(error) + Interval(by.zero);
  BuiltLeg leg;
  leg.drive = Enclosed<double>(drive);
  Interval squares(0.0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Interval side = Interval(by.slider[k]) + Interval(by.platform[k]);
    leg.sides[k] = Enclosed<double>(side);
    leg.axes[k] = EnclosedVector<double>(IntervalVector{ by.axes[0][k], by.axes[1][k], by.axes[2][k] });
    squares += sqr(side);
  }
  leg.constant = Enclosed<double>(length * (balls + Interval(by.length)));
  leg.sine = Enclosed<double>(by.direction > 0.0 ? sin(by.direction) : Interval(0.0));
  // 1 + 1e-9: the axes are columns of a rotation up to rounding
  leg.spread = (sqrtAboveZero(squares) * Interval(1.0 + 1e-9) + balls + drive).upper();
  leg.turn = by.direction;
  leg.versine = (length * (Interval(1.0) - cos(by.direction))).upper();
  leg.rest = (length * angle * drive + Interval(0.5) * sqr(Interval(by.length))).upper();
  return leg;
}

Interval largestError(const Configuration& there, const IntervalVector& reach)
{
  constexpr double SIGNS[4][3] = { { 1.0, 1.0, 1.0 }, { -1.0, 1.0, 1.0 }, { 1.0, -1.0, 1.0 }, { 1.0, 1.0, -1.0 } };
  Interval largest(0.0);
  for (const auto& signs : SIGNS)
  {
    IntervalVector sum;
    for (std::size_t leg = 0; leg < 3; ++leg)
      sum = sum + Interval(signs[leg]) * reach[leg] * cross(there.strut[(leg + 1) % 3], there.strut[(leg + 2) % 3]);
    const Interval length = norm(sum);
    largest = { std::max(largest.lower(), length.lower()), std::max(largest.upper(), length.upper()) };
  }
  const Interval det_a = abs(there.det_a);
  return det_a.certainlyPositive() ? largest / det_a : Interval(0.0, INF);
}

namespace
{
Interval enclosureOf(const Enclosed<double>& x)
{
  return { x.lower(), x.upper() };
}

/// What the leg reaches at the configuration of the nominal machine.
Interval reachOf(const BuiltLeg& by, const SlidingStrut& strut, const Configuration& there, std::size_t i)
{
  const IntervalVector& row = there.strut[i];
  const IntervalVector across = row - there.eta[i] * strut.axis;
  Interval reach = enclosureOf(by.drive) * abs(there.eta[i]) + enclosureOf(by.constant) +
                   abs(there.rho[i]) * enclosureOf(by.sine) * norm(across);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const IntervalVector axis = { strut.tolerance.axes[0][k], strut.tolerance.axes[1][k], strut.tolerance.axes[2][k] };
    reach += enclosureOf(by.sides[k]) * abs(dot(axis, row));
  }
  return reach;
}

/// What rows differ by at most, where the tool is off by no more than @p error [m].
Interval offOf(const BuiltLeg& by, const Interval& joint, double error)
{
  return Interval(error) + Interval(by.spread) + abs(joint) * Interval(by.turn);
}

/// An upper bound of what is of second order there.
Interval slackOf(const BuiltLeg& by, const Interval& joint, double error)
{
  const Interval square = sqr(offOf(by, joint, error));
  return Interval((Interval(0.5) * square + abs(joint) * Interval(by.versine) + Interval(by.rest)).upper());
}
}  // namespace

namespace
{
/// What each parameter of a leg makes of y, and the parameters for which y is largest (ParameterSet).
struct LargestReach
{
  std::array<double, STRUT_PARAMETERS> slope{};
  std::array<double, STRUT_PARAMETERS> parameter{};
  double sum = 0.0;
};

LargestReach largestReach(const SlidingStrut& strut, const Eigen::Vector3d& row, double joint)
{
  const StrutSpread spread = spreadOf(strut);
  const auto along = [&row](const PlainVector<double>& v) { return row.x() * v[0] + row.y() * v[1] + row.z() * v[2]; };
  LargestReach found;
  for (std::size_t j = 0; j < 4; ++j)
    found.slope[j] = along(spread.center_slopes[j]);
  for (std::size_t j = 0; j < 2; ++j)
    found.slope[4 + j] = joint * along(spread.axis_slopes[j]);
  found.slope[6] = 0.5 * spread.squared_length_slope;
  const auto& slope = found.slope;
  double ball = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    ball = std::hypot(ball, spread.set.ball[k] * slope[k]);
  const double turn = std::hypot(slope[4], slope[5]);
  for (std::size_t j = 0; j < STRUT_PARAMETERS; ++j)
  {
    const double side = slope[j] < 0.0 ? -1.0 : 1.0;
    if (j < 3)
      found.parameter[j] =
          side * spread.set.box[j] + (ball > 0.0 ? spread.set.ball[j] * spread.set.ball[j] * slope[j] / ball : 0.0);
    else
      found.parameter[j] = j == 4 || j == 5 ? (turn > 0.0 ? slope[j] / turn : 0.0) : side;
    found.sum += slope[j] * found.parameter[j];
  }
  return found;
}
}  // namespace

std::optional<WorstMachine> worstOfBuilt(const Machine& machine, const Criterion& criterion,
                                         const Eigen::Vector3d& point)
{
  const Machine nominal = withTolerances(machine, {});
  const auto there = configurationAt(nominal, point);
  if (!there)
    return std::nullopt;
  std::array<LargestReach, 3> legs;
  Eigen::Matrix3d rows;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const std::size_t leg = static_cast<std::size_t>(i);
    rows.row(i) = mid(there->strut[leg]).transpose();
    legs[leg] = largestReach(slidingStrut(machine.legs()[leg]), rows.row(i), there->rho[leg].mid());
    legs[leg].sum += criterion.joint_error_max[leg] * std::abs(there->eta[leg].mid());
  }
  const Eigen::Matrix3d inverse = rows.inverse();
  Eigen::Vector3d signs = Eigen::Vector3d::Ones(), error = Eigen::Vector3d::Zero();
  for (int pattern = 0; pattern < 4; ++pattern)
  {
    const Eigen::Vector3d some(pattern == 1 ? -1.0 : 1.0, pattern == 2 ? -1.0 : 1.0, pattern == 3 ? -1.0 : 1.0);
    const Eigen::Vector3d off =
        inverse * Eigen::Vector3d(some.x() * legs[0].sum, some.y() * legs[1].sum, some.z() * legs[2].sum);
    signs = off.norm() > error.norm() ? some : signs;
    error = off.norm() > error.norm() ? off : error;
  }
  WorstMachine worst;
  worst.subject = { ConditionKind::POSITION_ERROR_MAX };
  worst.margin = 1.0 - error.norm() / criterion.position_error_max;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (std::size_t j = 0; j < STRUT_PARAMETERS; ++j)
    {
      const Eigen::Index i = static_cast<Eigen::Index>(leg);
      worst.parameter[leg * STRUT_PARAMETERS + j] = signs[i] * legs[leg].parameter[j] * (1.0 - 0x1p-40);
      worst.loss[leg * STRUT_PARAMETERS + j] = std::max(
          0.0, signs[i] * legs[leg].slope[j] * legs[leg].parameter[j] * error.dot(inverse.col(i)) / error.norm());
    }
  return worst;
}

Interval errorOfBuilt(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point)
{
  constexpr int MOST_STEPS = 50;
  const auto there = configurationAt(withTolerances(machine, {}), point);
  if (!there)
    return { 0.0, INF };
  std::array<BuiltLeg, 3> legs;
  IntervalVector reach;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SlidingStrut& strut = slidingStrut(machine.leg(static_cast<int>(i)));
    legs[i] = builtLeg(strut, criterion.joint_error_max[i]);
    reach[i] = reachOf(legs[i], strut, *there, i);
  }
  const auto slack = [&](double error) {
    return IntervalVector{ slackOf(legs[0], there->rho[0], error), slackOf(legs[1], there->rho[1], error),
                           slackOf(legs[2], there->rho[2], error) };
  };
  const Interval first = largestError(*there, reach);
  // none is within less than the first order without what may follow; all are within what bounds itself
  const double least = std::max(0.0, (Interval(first.lower()) - largestError(*there, slack(first.lower()))).lower());
  double most = first.upper();
  for (int step = 0; step < MOST_STEPS; ++step)
  {
    IntervalVector all = reach + slack(most);
    for (std::size_t i = 0; i < 3; ++i)  // at least what makes the rows regular
      all[i] = std::max(all[i].upper(), (Interval(most) * offOf(legs[i], there->rho[i], most)).upper());
    const double next = largestError(*there, all).upper();
    if (next < most)
      return { least, most };
    most = next * (1.0 + 1e-9) + 1e-300;
  }
  return { least, INF };
}
}  // namespace pkm_workspace
