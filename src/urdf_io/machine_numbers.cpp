// SPDX-License-Identifier: BSD-3-Clause
#include "machine_numbers.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// Numbers for <axis>: rails that share one direction get the same ones, others get others.
Vector3d axisNumbers(const Machine& machine, int i, const std::array<LegNumbers, 3>& before)
{
  const IntervalVector& axis = slidingStrut(machine.leg(i)).axis;
  const auto fits = [&](const Vector3d& candidate) {
    bool distinct = true;
    for (int j = 0; j < i; ++j)
    {
      const Direction other = directionIn(Frame(), before[static_cast<std::size_t>(j)].axis);
      const bool parallel = exactlyParallel(directionIn(Frame(), candidate), other) != 0;
      distinct = distinct && parallel == (parallelSense(machine.leg(i), machine.leg(j)) != 0);
    }
    return distinct && intersects(unitVector(candidate), axis);
  };
  return nearestThat(mid(axis), machine, fits);
}

/// Bounds of the joint over all that the machine reaches: with M = sum P_i, P_i = I - e_i e_i^T, its points lie in the
/// ellipsoid (p - p_0)^T M (p - p_0) <= sum L_i^2 - sum |P_i (p_0 - c_i)|^2. One strut length to either side of the
/// zero configuration where M is nearly singular, for rails that are nearly parallel.
std::pair<double, double> reachableTravel(const Machine& machine, int leg)
{
  Matrix3d m = Matrix3d::Zero();
  Vector3d right_side = Vector3d::Zero();
  std::array<Matrix3d, 3> projectors;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d axis = mid(slidingStrut(machine.leg(i)).axis);
    projectors[static_cast<std::size_t>(i)] = Matrix3d::Identity() - axis * axis.transpose();
    m += projectors[static_cast<std::size_t>(i)];
    right_side += projectors[static_cast<std::size_t>(i)] * mid(machine.center(i));
  }
  const double length = slidingStrut(machine.leg(leg)).length.mid();
  const Vector3d axis = mid(slidingStrut(machine.leg(leg)).axis);
  if (Eigen::SelfAdjointEigenSolver<Matrix3d>(m).eigenvalues()[0] < 0.05)
    return { -length, length };
  const Matrix3d inverse = m.inverse();
  const Vector3d middle = inverse * right_side;
  double radius_squared = 0.0;
  for (int i = 0; i < 3; ++i)
    radius_squared += std::pow(slidingStrut(machine.leg(i)).length.upper(), 2) -
                      (projectors[static_cast<std::size_t>(i)] * (middle - mid(machine.center(i)))).squaredNorm();
  const double radius = std::sqrt(std::max(0.0, radius_squared) * axis.dot(inverse * axis)) + 1e-6 * length;
  const double along = axis.dot(middle - mid(machine.center(leg)));
  const double eta = slidingStrut(machine.leg(leg)).working_mode * length;
  return { along - radius - std::max(eta, 0.0), along + radius - std::min(eta, 0.0) };
}

/// The next multiple of about a tenth of @p length below or above.
double roundNumber(double value, double length, double (*round)(double))
{
  const int digits = 1 - static_cast<int>(std::floor(std::log10(length)));
  const double scale = std::pow(10.0, std::abs(digits));
  return digits >= 0 ? round(value * scale) / scale : round(value / scale) * scale;
}

void setLimits(const Machine& machine, int i, LegNumbers& numbers)
{
  const Interval& own = machine.leg(i).limits;
  const double length = slidingStrut(machine.leg(i)).length.mid();
  const auto travel = reachableTravel(machine, i);
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

void setHinges(LegNumbers& numbers)
{
  const Vector3d along = numbers.strut.normalized();
  Vector3d first = numbers.axis.cross(along);
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
        "' cannot be written as a URDF: with all joints at 0 m no tool point is in its working mode"
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
    const SlidingStrut& leg = slidingStrut(machine.leg(i));
    LegNumbers& numbers = all[static_cast<std::size_t>(i)];
    numbers.joint = machine.leg(i).joint;
    numbers.speed = knownOr0(machine.leg(i).speed);
    numbers.effort = knownOr0(machine.leg(i).effort);
    numbers.origin = mid(leg.origin);
    numbers.platform = mid(leg.platform);
    numbers.axis = axisNumbers(machine, i, all);
    numbers.strut = nearestThat(mid(zero.strut[static_cast<std::size_t>(i)]), machine,
                                [&leg](const Vector3d& v) { return lengthOf(enclose(v)).intersects(leg.length); });
    setLimits(machine, i, numbers);
    setDrawnTravel(numbers);
    setHinges(numbers);
  }
  return all;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
