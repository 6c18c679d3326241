// SPDX-License-Identifier: BSD-3-Clause
#include "machine_numbers.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/rails.h"
#include "placement.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The vector with one component moved by @p steps doubles.
Vector3d nudged(Vector3d v, Eigen::Index component, int steps)
{
  for (int i = 0; i < std::abs(steps); ++i)
    v[component] = std::nextafter(v[component], steps > 0 ? INF : -INF);
  return v;
}

/// The vector nearest to @p v, of those that differ in one component only, that @p fits: in the largest one, or in
/// another where that one changes nothing, as the length of an axis does.
/// @throws std::invalid_argument where none does
template <class Fits>
Vector3d nearestThat(const Vector3d& v, const Machine& machine, const Fits& fits)
{
  std::array<Eigen::Index, 3> components = { 0, 1, 2 };
  std::sort(components.begin(), components.end(),
            [&v](Eigen::Index a, Eigen::Index b) { return std::abs(v[a]) > std::abs(v[b]); });
  for (const Eigen::Index component : components)
    for (int step = 0; step <= 64; ++step)
      for (const int steps : { step, -step })
        if (fits(nudged(v, component, steps)))
          return nudged(v, component, steps);
  throw std::invalid_argument("machine '" + machine.name() +
                              "' cannot be written as a URDF: no doubles near its axes and struts read back as them");
}

/// Numbers for the <axis> of a rail: rails that share one direction get the same ones, others get others.
Vector3d axisNumbers(const SlidingStrut& strut, const Machine& machine, int i, const std::array<LegNumbers, 3>& before)
{
  const auto fits = [&](const Vector3d& candidate) {
    bool distinct = true;
    for (int j = 0; j < i; ++j)
    {
      const LegNumbers& other = before[static_cast<std::size_t>(j)];
      const bool parallel = exactlyParallel(directionIn(Frame(), candidate), directionIn(Frame(), other.axis)) != 0;
      distinct = distinct &&
                 (other.form != LegForm::SLIDER || parallel == (parallelSense(machine.leg(i), machine.leg(j)) != 0));
    }
    return distinct && intersects(unitVector(candidate), strut.axis);
  };
  return nearestThat(mid(strut.axis), machine, fits);
}

/// Numbers for the vector from A to B.
Vector3d strutNumbers(const IntervalVector& strut, const Interval& length, const Machine& machine)
{
  return nearestThat(mid(strut), machine, [&](const Vector3d& v) { return lengthOf(enclose(v)).intersects(length); });
}

void setDrive(const SlidingStrut& strut, const Machine& machine, int i, std::array<LegNumbers, 3>& all)
{
  LegNumbers& numbers = all[static_cast<std::size_t>(i)];
  numbers.origin = mid(strut.origin);
  numbers.axis = axisNumbers(strut, machine, i, all);
}

void setDrive(const TelescopicStrut& strut, const Machine& /*machine*/, int i, std::array<LegNumbers, 3>& all)
{
  LegNumbers& numbers = all[static_cast<std::size_t>(i)];
  numbers.form = LegForm::TELESCOPE;
  numbers.origin = mid(strut.foot);
  numbers.axis = numbers.strut;
}

void setDrive(const Crank& crank, const Machine& machine, int i, std::array<LegNumbers, 3>& all)
{
  if (crank.drive_scale > 0.0)
    throw std::invalid_argument("machine '" + machine.name() + "' cannot be written as a URDF: leg " +
                                std::to_string(i + 1) + " counts a turn of its crank as " + exact(crank.drive_scale) +
                                " m, and no URDF says so; leave the drive scale out");
  LegNumbers& numbers = all[static_cast<std::size_t>(i)];
  numbers.form = LegForm::CRANK;
  numbers.origin = mid(crank.pivot);
  const IntervalVector axis = cross(crank.along, crank.across);
  numbers.axis = nearestThat(mid(axis), machine, [&](const Vector3d& v) { return intersects(unitVector(v), axis); });
  const IntervalVector unit = unitVector(numbers.axis);
  numbers.arm = nearestThat(crank.radius.mid() * mid(crank.along), machine, [&](const Vector3d& v) {
    const IntervalVector along = unitVector(v);
    return lengthOf(enclose(v)).intersects(crank.radius) && intersects(along, crank.along) &&
           intersects(cross(unit, along), crank.across) && dot(unit, enclose(v)).contains(0.0);
  });
}

const Interval& strutLength(const Leg& leg)
{
  return visitLeg([](const auto& kind) -> const Interval& { return kind.length; }, leg.kind);
}

const IntervalVector& platformPoint(const Leg& leg)
{
  return visitLeg([](const auto& kind) -> const IntervalVector& { return kind.platform; }, leg.kind);
}

/// What leg i bounds the machine's points by; a strut of variable length by its upper limit.
OuterBound boundOf(const Machine& machine, int i)
{
  const auto* const strut = std::get_if<TelescopicStrut>(&machine.leg(i).kind);
  const double upper = machine.leg(i).limits.upper();
  if (strut == nullptr)
    return outerBound(machine.enclosed(i), std::nullopt);
  if (!std::isfinite(upper))
    return { IntervalMatrix{}, machine.center(i), Interval(0.0) };
  return { Frame().rotation, machine.center(i), strut->length + Interval(upper) };
}

/// Bounds of a rail's joint over all that the machine reaches, by |P_i (p - c_i)| <= r_i of all legs: with M = sum P_i
/// its points lie in the ellipsoid (p - p_0)^T M (p - p_0) <= sum r_i^2 - sum |P_i (p_0 - c_i)|^2. One strut length to
/// either side of the zero configuration where M is nearly singular, for rails that are nearly parallel.
std::pair<double, double> reachableTravel(const SlidingStrut& strut, const Machine& machine, int leg)
{
  Matrix3d m = Matrix3d::Zero();
  Vector3d right_side = Vector3d::Zero();
  std::array<Matrix3d, 3> projectors;
  for (int i = 0; i < 3; ++i)
  {
    const IntervalMatrix projector = boundOf(machine, i).projector;
    Matrix3d& rows = projectors[static_cast<std::size_t>(i)];
    rows << mid(projector[0]).transpose(), mid(projector[1]).transpose(), mid(projector[2]).transpose();
    m += rows;
    right_side += rows * mid(machine.center(i));
  }
  const double length = strut.length.mid();
  const Vector3d axis = mid(strut.axis);
  if (Eigen::SelfAdjointEigenSolver<Matrix3d>(m).eigenvalues()[0] < 0.05)
    return { -length, length };
  const Matrix3d inverse = m.inverse();
  const Vector3d middle = inverse * right_side;
  double radius_squared = 0.0;
  for (int i = 0; i < 3; ++i)
    radius_squared += std::pow(boundOf(machine, i).radius.upper(), 2) -
                      (projectors[static_cast<std::size_t>(i)] * (middle - mid(machine.center(i)))).squaredNorm();
  const double radius = std::sqrt(std::max(0.0, radius_squared) * axis.dot(inverse * axis)) + 1e-6 * length;
  const double along = axis.dot(middle - mid(machine.center(leg)));
  const double eta = strut.working_mode * length;
  return { along - radius - std::max(eta, 0.0), along + radius - std::min(eta, 0.0) };
}

/// Nothing bounds it: as short as a strut may well be, and twice as long as at joint value 0.
std::pair<double, double> reachableTravel(const TelescopicStrut& strut, const Machine& /*machine*/, int /*leg*/)
{
  return { -0.8 * strut.length.mid(), strut.length.mid() };
}

std::pair<double, double> reachableTravel(const Crank& /*crank*/, const Machine& /*machine*/, int /*leg*/)
{
  return { -INF, INF };
}

/// The next multiple of about a tenth of @p length below or above.
double roundNumber(double value, double length, double (*round)(double))
{
  if (!std::isfinite(value))
    return value;
  const int digits = 1 - static_cast<int>(std::floor(std::log10(length)));
  const double scale = std::pow(10.0, std::abs(digits));
  return digits >= 0 ? round(value * scale) / scale : round(value / scale) * scale;
}

void setLimits(const Machine& machine, int i, LegNumbers& numbers)
{
  const Interval& own = machine.leg(i).limits;
  const double length = strutLength(machine.leg(i)).mid();
  const auto travel =
      visitLeg([&](const auto& kind) { return reachableTravel(kind, machine, i); }, machine.leg(i).kind);
  const double lowest = std::min(own.upper(), roundNumber(travel.first, length, std::floor));
  numbers.lower = std::isfinite(own.lower()) ? own.lower() : lowest;
  const double highest = std::max(numbers.lower, roundNumber(travel.second, length, std::ceil));
  numbers.upper = std::isfinite(own.upper()) ? own.upper() : highest;
}

/// Limits of a machine of the catalogue are mostly those of reach: near the zero configuration is what a rail is for.
void setDrawnTravel(LegNumbers& numbers)
{
  const double length = numbers.strut.norm();
  const double forward = numbers.axis.dot(numbers.strut) > 0.0 ? 1.0 : -1.0;
  numbers.drawn = { std::max(numbers.lower, std::min(-0.4 * forward, 0.7 * forward) * length),
                    std::min(numbers.upper, std::max(-0.4 * forward, 0.7 * forward) * length) };
}

double knownOr0(double limit)
{
  return std::isfinite(limit) ? limit : 0.0;
}

/// The first axis is across a rail, and as near as can be to a crank's.
void setHinges(LegNumbers& numbers)
{
  const Vector3d along = numbers.strut.normalized();
  Vector3d first = numbers.axis.cross(along);
  if (numbers.form == LegForm::CRANK)
    first = numbers.axis - along.dot(numbers.axis) * along;
  if (first.norm() < 0.01)
  {
    Eigen::Index largest = 0;
    along.cwiseAbs().maxCoeff(&largest);
    const Vector3d other = Vector3d::Unit((largest + 1) % 3);
    first = other - along.dot(other) * along;
  }
  numbers.revolute = first.normalized();
  numbers.parallelogram = along.cross(numbers.revolute).normalized();
}

/// The machine at joint values 0, where a URDF has to show it assembled. At the zero configuration itself where that is
/// it.
Configuration atJointsZero(const Machine& machine)
{
  auto zero = configurationAt(machine, machine.zero());
  bool joints_zero = true;
  for (const Interval& rho : zero->rho)
    joints_zero = joints_zero && rho.magnitude() <= 1e-9 * machine.scale();
  const auto p = joints_zero ? machine.zero() : forwardKinematics(machine, Eigen::Vector3d::Zero());
  if (p && !joints_zero)
    zero = configurationAt(machine, *p);
  if (!p || !zero)
    throw std::invalid_argument(
        "machine '" + machine.name() +
        "' cannot be written as a URDF: with all joints at 0 no tool point is in its working mode"
        " and on its side of the parallel singularity");
  return *zero;
}
}  // namespace

std::array<LegNumbers, 3> numbersOf(const Machine& machine)
{
  const Configuration zero = atJointsZero(machine);
  std::array<LegNumbers, 3> all;
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = machine.leg(i);
    LegNumbers& numbers = all[static_cast<std::size_t>(i)];
    numbers.joint = leg.joint;
    numbers.speed = knownOr0(leg.speed);
    numbers.effort = knownOr0(leg.effort);
    numbers.platform = mid(platformPoint(leg));
    numbers.strut = strutNumbers(zero.strut[static_cast<std::size_t>(i)], strutLength(leg), machine);
    visitLeg([&](const auto& kind) { setDrive(kind, machine, i, all); }, leg.kind);
    setLimits(machine, i, numbers);
    setDrawnTravel(numbers);
    setHinges(numbers);
  }
  return all;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
