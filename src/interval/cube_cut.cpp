// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/cube_cut.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
namespace
{
/// Two numbers from 0 to 1 that a share lies between.
struct Share
{
  double lower;
  double upper;
};
constexpr Share NONE{ 0.0, 0.0 };
constexpr Share ALL{ 1.0, 1.0 };
constexpr Share ANY{ 0.0, 1.0 };

/// Slopes below this share of the steepest one count as an error: the formula divides by each slope.
constexpr double FLAT = 1e-5;
/// More than some dozens of roundings change, relative to what they round.
constexpr double ROUNDINGS = rounding::SOUND ? 64.0 * std::numeric_limits<double>::epsilon() : 0.0;
/// Divisors below this might meet numbers that underflow.
constexpr double LEAST_DIVISOR = 1e-200;

/// The slopes that are not nearly flat, as magnitudes.
struct Slopes
{
  std::array<double, 3> steep{};
  std::size_t count = 0;
  double sum = 0.0;
};

/// sum over the corners s of s_1 ... s_n max(0, constant + s . a)^n, rounded.
double cornerSum(double constant, const Slopes& slopes)
{
  double sum = 0.0;
  for (unsigned corner = 0; corner < (1U << slopes.count); ++corner)
  {
    double height = constant;
    double power = 1.0;
    for (std::size_t j = 0; j < slopes.count; ++j)
    {
      const bool minus = (corner >> j) % 2 == 1;
      height += minus ? -slopes.steep[j] : slopes.steep[j];
      power = minus ? -power : power;
    }
    for (std::size_t j = 0; j < slopes.count; ++j)
      power *= std::max(height, 0.0);
    sum += power;
  }
  return sum;
}

/// With n slopes a_j > 0 the share is cornerSum / (n! 2^n a_1 ... a_n). No height is above the largest L, and none is
/// off by more than some roundings of the slopes' sum: the power by less than n L^(n - 1) times that.
/// @pre constant <= 0
Share shareBeyondMiddle(double constant, const Slopes& slopes)
{
  const double largest = constant + slopes.sum + ROUNDINGS * slopes.sum;
  if (largest <= 0.0)
    return NONE;
  double divisor = 1.0;
  double error = 8.0 * ROUNDINGS * (slopes.sum + largest);
  for (std::size_t j = 0; j < slopes.count; ++j)
  {
    divisor *= 2.0 * static_cast<double>(j + 1) * slopes.steep[j];
    error *= j == 0 ? 1.0 : 2.0 * largest;
  }
  const double share = cornerSum(constant, slopes) / divisor;
  const double slack = 2.0 * error / divisor + ROUNDINGS * (std::abs(share) + ROUNDINGS);
  if (!(divisor > LEAST_DIVISOR && std::isfinite(slack)))
    return ANY;
  return { std::min(1.0, std::max(0.0, share - slack)), std::min(1.0, std::max(0.0, share + slack)) };
}

Share shareOf(double constant, const Slopes& slopes)
{
  if (constant <= 0.0)
    return shareBeyondMiddle(constant, slopes);
  const Share below = shareBeyondMiddle(-constant, slopes);
  const double lower = below.upper > 0.0 ? std::max(0.0, 1.0 - below.upper - ROUNDINGS) : 1.0;
  return { lower, std::min(1.0, 1.0 - below.lower + ROUNDINGS) };
}

Share shareOf(double constant, const std::array<double, 3>& slopes)
{
  if (std::isinf(constant))
    return constant > 0.0 ? ALL : NONE;
  const double steepest = std::max({ std::abs(slopes[0]), std::abs(slopes[1]), std::abs(slopes[2]) });
  Slopes kept;
  double flat = 0.0;
  for (const double slope : slopes)
    if (std::abs(slope) <= FLAT * steepest)
      flat += std::abs(slope);
    else
    {
      kept.steep[kept.count++] = std::abs(slope);
      kept.sum += std::abs(slope);
    }
  if (!(std::abs(constant) + kept.sum + flat < INF))
    return ANY;
  if (kept.count == 0)
    return constant >= 0.0 ? ALL : NONE;
  if (flat == 0.0)
    return shareOf(constant, kept);
  flat += ROUNDINGS * (std::abs(constant) + flat);
  return { shareOf(constant - flat, kept).lower, shareOf(constant + flat, kept).upper };
}

/// An upper bound of the share that is cut off at a level of inner.
double lost(double inner, const CubeCut& cut)
{
  return shareOf(-inner, cut.gradient).upper;
}

/// By how much the inner plane of one cut has to be moved in for no point within it to be beyond that of another; INF
/// where no way would do.
double stepWithin(const CubeCut& cut, const CubeCut& other)
{
  const auto dot = [](const CubeCut& a, const CubeCut& b) {
    return a.gradient[0] * b.gradient[0] + a.gradient[1] * b.gradient[1] + a.gradient[2] * b.gradient[2];
  };
  const double scale = dot(cut, other) / dot(cut, cut);
  if (!(scale > 0.0 && std::isfinite(scale)) || !std::isfinite(cut.inner) || !std::isfinite(other.inner))
    return INF;
  // other - scale (cut - step) is not negative on the cube
  const Interval s(scale);
  Interval needed = s * Interval(cut.inner) - Interval(other.inner);
  for (std::size_t j = 0; j < 3; ++j)
    needed += abs(Interval(other.gradient[j]) - s * Interval(cut.gradient[j]));
  return std::max(0.0, (needed / s).upper());
}

/// An upper bound of the share of the cube that the inner planes cut off together.
double lostToAll(const CubeCut* cuts, std::size_t count)
{
  std::size_t deepest = 0;
  double most = -1.0;
  for (std::size_t k = 0; k < count; ++k)
    if (const double share = lost(cuts[k].inner, cuts[k]); share > most)
    {
      most = share;
      deepest = k;
    }
  double inner = count > 0 ? cuts[deepest].inner : INF;
  Interval sum(0.0);
  for (std::size_t k = 0; k < count; ++k)
  {
    if (k == deepest)
      continue;
    const double alone = lost(cuts[k].inner, cuts[k]);
    const double step = stepWithin(cuts[deepest], cuts[k]);
    const double moved = std::isinf(step) ? -INF : (Interval(cuts[deepest].inner) - Interval(step)).lower();
    const double together = lost(std::min(inner, moved), cuts[deepest]);
    if (together - most < alone)
    {
      inner = std::min(inner, moved);
      most = together;
    }
    else
      sum += Interval(alone);
  }
  return (sum + Interval(std::max(0.0, most))).upper();
}
}  // namespace

Interval shareAbove(double constant, const std::array<double, 3>& slopes)
{
  const Share share = shareOf(constant, slopes);
  return { share.lower, share.upper };
}

Interval shareWithin(const CubeCut* cuts, std::size_t count)
{
  double upper = 1.0;
  for (std::size_t k = 0; k < count; ++k)
    upper = std::min(upper, shareOf(cuts[k].outer, cuts[k].gradient).upper);
  double lower = count > 0 ? 0.0 : 1.0;
  if (count == 1)
    lower = shareOf(cuts[0].inner, cuts[0].gradient).lower;
  else if (count > 1 && upper > 0.0)
    lower = (Interval(1.0) - Interval(lostToAll(cuts, count))).lower();
  return { std::min(upper, std::max(0.0, lower)), upper };
}
}  // namespace pkm_workspace
