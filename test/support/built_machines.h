// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/machine/tolerances.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// How one machine that was built differs from what was meant, as shares of its tolerances: of each leg the slider
/// point and the platform point along their axes (-1 to 1) and in any direction (of length 1 at most), the rail (of
/// length 1 at most), strut length and joint zero (-1 to 1).
struct Deviation
{
  static constexpr std::size_t COUNT = 16;
  std::array<std::array<double, COUNT>, 3> share{};

  /// Keeps what belongs to one vector within a ball.
  void project()
  {
    for (auto& leg : share)
      for (const auto& [first, count] : { std::pair<std::size_t, std::size_t>{ 6, 3 }, { 9, 3 }, { 12, 2 } })
      {
        double square = 0.0;
        for (std::size_t k = first; k < first + count; ++k)
          square += leg[k] * leg[k];
        for (std::size_t k = first; square > 1.0 && k < first + count; ++k)
          leg[k] /= std::sqrt(square) * (1.0 + 1e-12);
      }
  }
};

/// A vertex of the tolerances, or any point of them.
inline Deviation randomDeviation(Random& random)
{
  Deviation deviation;
  const bool is_vertex = random.once(2);
  for (auto& leg : deviation.share)
    for (double& share : leg)
      share = is_vertex ? random.sign() : random.uniform(-1.0, 1.0);
  deviation.project();
  return deviation;
}

/// Written from the definition: each number of the machine moved by itself. Rounding leaves it within the tolerances
/// but for some 1e-16 of its numbers.
inline Machine built(const Machine& meant, const Deviation& deviation)
{
  Machine::Legs legs = meant.legs();
  for (std::size_t i = 0; i < 3; ++i)
  {
    SlidingStrut& strut = slidingStrut(legs[i]);
    const StrutTolerance by = strut.tolerance;
    const auto& share = deviation.share[i];
    Eigen::Vector3d origin = mid(strut.origin), platform = mid(strut.platform), axis = mid(strut.axis).normalized();
    for (int k = 0; k < 3; ++k)
    {
      const std::size_t j = static_cast<std::size_t>(k);
      origin[k] += by.slider[j] * share[j] + by.slider_ball * share[6 + j];
      platform[k] += by.platform[j] * share[3 + j] + by.platform_ball * share[9 + j];
    }
    const Eigen::Vector3d first = axis.unitOrthogonal();
    const Eigen::Vector3d turn = share[12] * first + share[13] * axis.cross(first);
    const double angle = by.direction * turn.norm();
    if (angle > 0.0)
      axis = std::cos(angle) * axis + std::sin(angle) * turn.normalized();
    strut.origin = enclose(origin);
    strut.platform = enclose(platform);
    strut.axis = enclose(axis);
    if (!squaredNorm(strut.axis).contains(1.0))
      for (Interval& component : strut.axis)
        component = component + Interval(-1e-16, 1e-16);
    strut.direction = 0;
    strut.length = Interval(strut.length.mid() + by.length * share[14]);
    // the controller reads q where the joint is at q + z
    legs[i].limits =
        Interval(legs[i].limits.lower() + by.zero * share[15], legs[i].limits.upper() + by.zero * share[15]);
    strut.tolerance = {};
  }
  return { meant.name(), legs, meant.zero() };
}

using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongMatrix = Eigen::Matrix<long double, 3, 3>;

inline LongVector toLong(const IntervalVector& v)
{
  return mid(v).cast<long double>();
}

/// A sphere that the tool stands on: its strut about the slider.
struct StrutSphereOf
{
  LongVector center;
  long double radius;
};

/// That of a leg, part of the way from what was meant (0) to what was built (1), at the joint value at which the
/// nominal leg has the tool at p, but for an error; nothing where that does not reach.
inline std::optional<StrutSphereOf> sphereOf(const SlidingStrut& meant, const SlidingStrut& built, const LongVector& p,
                                             long double error, long double part)
{
  const LongVector was = toLong(meant.axis).normalized(), now = toLong(built.axis).normalized();
  const LongVector offset = p - toLong(meant.origin) + toLong(meant.platform);
  const long double along = was.dot(offset), length = meant.length.mid();
  const long double square = length * length - (offset - along * was).squaredNorm();
  if (square <= 0.0L)
    return std::nullopt;
  const long double joint = along - meant.working_mode * std::sqrt(square) + part * error;
  const LongVector first = toLong(meant.origin) - toLong(meant.platform);
  const LongVector last = toLong(built.origin) - toLong(built.platform);
  const LongVector direction = (was + part * (now - was)).normalized();
  return StrutSphereOf{ first + part * (last - first) + joint * direction,
                        length + part * (built.length.mid() - length) };
}

/// The point on three spheres that Newton's method comes to.
inline LongVector meetingOf(const std::array<StrutSphereOf, 3>& spheres, LongVector from)
{
  for (int step = 0; step < 20; ++step)
  {
    LongMatrix rows;
    LongVector rest;
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      const auto& [center, radius] = spheres[static_cast<std::size_t>(i)];
      rows.row(i) = (from - center).transpose();
      rest[i] = ((from - center).squaredNorm() - radius * radius) / 2;
    }
    const LongVector change = rows.partialPivLu().solve(rest);
    from -= change;
    if (change.norm() < 1e-17L)
      break;
  }
  return from;
}

/// How far the tool of the machine that was built stands from the point where the nominal machine has it at the same
/// joint values but for their errors [m]; infinite where it cannot be assembled. Written from the definition, followed
/// from the nominal machine to the built one.
/// @param share of the errors of the joints, -1 to 1
inline double toolError(const Machine& meant, const Machine& is, const Deviation& deviation, const JointValues& errors,
                        const std::array<double, 3>& share, const Eigen::Vector3d& point)
{
  const LongVector p = point.cast<long double>();
  LongVector at = p;
  for (const long double part : { 0.5L, 1.0L })
  {
    std::array<StrutSphereOf, 3> spheres;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SlidingStrut& was = slidingStrut(meant.legs()[i]);
      const auto sphere = sphereOf(was, slidingStrut(is.legs()[i]), p,
                                   was.tolerance.zero * deviation.share[i][15] + errors[i] * share[i], part);
      if (!sphere)
        return INF;
      spheres[i] = *sphere;
    }
    at = meetingOf(spheres, at);
  }
  return static_cast<double>((at - p).norm());
}

/// The longest of them over all signs of the joints' errors [m].
inline double largestToolError(const Machine& meant, const Deviation& deviation, const JointValues& errors,
                               const Eigen::Vector3d& point)
{
  const Machine is = built(meant, deviation);
  double largest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
    largest = std::max(largest,
                       toolError(meant, is, deviation, errors,
                                 { corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0 }, point));
  return largest;
}

/// What is asked of the machine where its tool stands: errors of position are about where it is believed to stand.
inline Criterion withoutErrors(Criterion criterion)
{
  criterion.position_error_max = 0.0;
  return criterion;
}

/// Whether the machine that was built so satisfies the criterion at the point, in 100 digits.
inline bool isGood(const Machine& meant, const Deviation& deviation, const Criterion& criterion,
                   const Eigen::Vector3d& point)
{
  try
  {
    return Oracle(built(meant, deviation), withoutErrors(criterion)).isGood(point) &&
           (criterion.position_error_max == 0.0 ||
            largestToolError(meant, deviation, criterion.joint_error_max, point) <= criterion.position_error_max);
  }
  catch (const std::invalid_argument&)
  {
    return false;  // no machine
  }
}

/// How far that machine is from violating it there, in floating point.
inline double marginOf(const Machine& meant, const Deviation& deviation, const Criterion& criterion,
                       const Eigen::Vector3d& point)
{
  try
  {
    const double margin = BoxTest(built(meant, deviation), withoutErrors(criterion)).margin(point);
    return criterion.position_error_max == 0.0
               ? margin
               : std::min(margin, 1.0 - largestToolError(meant, deviation, criterion.joint_error_max, point) /
                                            criterion.position_error_max);
  }
  catch (const std::invalid_argument&)
  {
    return -1.0;
  }
}

/// The deviation that the slopes of the margin there point to: of a vector to the end of its ball.
inline Deviation steepest(const Machine& meant, const Deviation& from, const Criterion& criterion,
                          const Eigen::Vector3d& point)
{
  Deviation slope;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (std::size_t k = 0; k < Deviation::COUNT; ++k)
    {
      Deviation up = from, down = from;
      up.share[leg][k] += 1e-3;
      down.share[leg][k] -= 1e-3;
      const double rise = marginOf(meant, up, criterion, point) - marginOf(meant, down, criterion, point);
      const bool is_vector = k >= 6 && k < 14;
      slope.share[leg][k] = is_vector ? -1e12 * rise : rise > 0.0 ? -1.0 : 1.0;
    }
  slope.project();
  return slope;
}

/// The worst deviation that descents from some starts find: down the slope, then one share at a time to either end, or
/// half-way.
inline Deviation worstDeviation(const Machine& meant, const Criterion& criterion, const Eigen::Vector3d& point,
                                Random& random, int starts)
{
  Deviation worst;
  double least = marginOf(meant, worst, criterion, point);
  for (int start = 0; start < starts; ++start)
  {
    Deviation at;
    for (auto& leg : at.share)
      for (double& share : leg)
        share = start == 0 ? 0.0 : random.sign();
    at.project();
    double margin = marginOf(meant, at, criterion, point);
    for (int step = 0; step < 3; ++step)
    {
      const Deviation next = steepest(meant, at, criterion, point);
      const double reached = marginOf(meant, next, criterion, point);
      at = reached < margin ? next : at;
      margin = std::min(margin, reached);
    }
    for (int round = 0; round < 3; ++round)
      for (std::size_t leg = 0; leg < 3; ++leg)
        for (std::size_t k = 0; k < Deviation::COUNT; ++k)
          for (const double share : { -1.0, 1.0, -0.5, 0.5 })
          {
            Deviation next = at;
            next.share[leg][k] = share;
            next.project();
            const double reached = marginOf(meant, next, criterion, point);
            if (reached < margin)
            {
              margin = reached;
              at = next;
            }
          }
    if (margin < least)
    {
      least = margin;
      worst = at;
    }
  }
  return worst;
}
}  // namespace test
}  // namespace pkm_workspace
