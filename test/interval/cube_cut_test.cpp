// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/cube_cut.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;
using Number = boost::multiprecision::cpp_bin_float_100;

/// The integral over y in [-1, 1] of the length of { z in [-1, 1] : height + y slope_y + z slope_z >= 0 }, exactly: the
/// length is a straight line between the places where the plane leaves the square.
Number squareAbove(const Number& height, const Number& slope_y, const Number& slope_z)
{
  const auto length = [&](const Number& y) {
    const Number end = (height + y * slope_y) / slope_z;
    return Number(end < -1 ? Number(0) : end > 1 ? Number(2) : Number(1 + end));
  };
  std::vector<Number> places = { -1, 1 };
  for (const int side : { -1, 1 })
    if (slope_y != 0)
      if (const Number y = (-height + side * slope_z) / slope_y; y > -1 && y < 1)
        places.push_back(y);
  std::sort(places.begin(), places.end());
  Number sum = 0;
  for (std::size_t k = 1; k < places.size(); ++k)
    sum += (places[k] - places[k - 1]) * (length(places[k]) + length(places[k - 1])) / 2;
  return sum;
}

/// The share of the cube by its sections: between the places where the plane passes a corner of the section their area
/// is a parabola, which Simpson's rule integrates exactly. Slopes are not 0.
Number shareBySections(double constant, const std::array<double, 3>& slopes)
{
  const Number x_slope = abs(Number(slopes[0])), y_slope = abs(Number(slopes[1])), z_slope = abs(Number(slopes[2]));
  std::vector<Number> places = { -1, 1 };
  for (const int y : { -1, 1 })
    for (const int z : { -1, 1 })
      if (const Number x = (-Number(constant) - y * y_slope - z * z_slope) / x_slope; x > -1 && x < 1)
        places.push_back(x);
  std::sort(places.begin(), places.end());
  const auto area = [&](const Number& x) { return squareAbove(constant + x * x_slope, y_slope, z_slope); };
  Number sum = 0;
  for (std::size_t k = 1; k < places.size(); ++k)
  {
    const Number& a = places[k - 1];
    const Number& b = places[k];
    sum += (b - a) * (area(a) + 4 * area((a + b) / 2) + area(b)) / 6;
  }
  return sum / 8;
}

/// Slopes of very different sizes, now and then of the same, and a plane that mostly meets the cube.
void drawPlane(test::Random& random, double& constant, std::array<double, 3>& slopes)
{
  double sum = 0.0;
  for (double& slope : slopes)
  {
    slope = random.once(5) ? 0.5 : random.uniform(-1.0, 1.0) * std::pow(10.0, random.uniform(-7.0, 0.0));
    slope = slope == 0.0 ? 1.0 : slope;
    sum += std::abs(slope);
  }
  constant = random.once(4) ? random.sign() * sum * (1.0 - std::pow(10.0, random.uniform(-9.0, -1.0)))
                            : random.uniform(-1.1, 1.1) * sum;
}
/// Some cuts, two of which are now and then nearly the same plane in another scale.
std::vector<CubeCut> drawCuts(test::Random& random)
{
  std::vector<CubeCut> cuts(static_cast<std::size_t>(random.integer(1, 4)));
  for (CubeCut& cut : cuts)
  {
    drawPlane(random, cut.inner, cut.gradient);
    cut.inner = random.once(6) ? INF : cut.inner + 0.5;
    cut.outer = random.once(6) ? INF : cut.inner + random.uniform(0.0, 0.1);
  }
  if (random.once(2))
  {
    cuts.push_back(cuts[0]);
    for (double& slope : cuts.back().gradient)
      slope *= 3.0 + random.uniform(0.0, 0.01);
    cuts.back().inner = 3.0 * cuts[0].inner + random.uniform(-0.05, 0.05);
    cuts.back().outer = INF;
  }
  return cuts;
}

bool isBeyondAll(const std::vector<CubeCut>& cuts, double CubeCut::*plane, const std::array<double, 3>& delta)
{
  for (const CubeCut& cut : cuts)
    if (cut.*plane + cut.gradient[0] * delta[0] + cut.gradient[1] * delta[1] + cut.gradient[2] * delta[2] < 0.0)
      return false;
  return true;
}
}  // namespace

TEST(CubeCut, shareAboveAPlane)
{
  EXPECT_TRUE(shareAbove(0.0, { 0.3, -0.2, 1.0 }).contains(0.5));
  EXPECT_TRUE((shareAbove(-2.0, { 1.0, 1.0, -1.0 }) * Interval(48.0)).contains(1.0));  // a corner, 1/6 of 8
  EXPECT_TRUE((shareAbove(-1.0, { 1.0, 0.0, 1.0 }) * Interval(8.0)).contains(1.0));    // an edge, 1/2 of 4
  EXPECT_TRUE(shareAbove(0.5, { 0.0, 1.0, 0.0 }).contains(0.75));
  EXPECT_EQ(shareAbove(-1e-300, { 0.0, 0.0, 0.0 }), Interval(0.0));
  EXPECT_EQ(shareAbove(0.0, { 0.0, 0.0, 0.0 }), Interval(1.0));
  EXPECT_EQ(shareAbove(INF, { 1.0, 1e-9, 1.0 }), Interval(1.0));
  EXPECT_EQ(shareAbove(-INF, { 1.0, 1e-9, 1.0 }), Interval(0.0));
  EXPECT_EQ(shareAbove(-3.5, { 1.0, 1.0, 1.0 }), Interval(0.0));
  EXPECT_EQ(shareAbove(3.5, { 1.0, 1.0, 1.0 }), Interval(1.0));
}

TEST(CubeCutContainment, shareIsTheSumOfTheSections)
{
  test::Random random(SEED);
  for (int k = 0; k < test::cases(3000); ++k)
  {
    double constant;
    std::array<double, 3> slopes;
    drawPlane(random, constant, slopes);
    const Number exact = shareBySections(constant, slopes);
    const Interval share = shareAbove(constant, slopes);
    ASSERT_TRUE(share.lower() <= exact && exact <= share.upper())
        << "seed " << SEED << ", case " << k << ": " << share << ", exact " << exact;
    EXPECT_LT(share.width(), 2e-4) << k;
  }
}

TEST(CubeCutContainment, partsOfMeasuresHoldTheExactProduct)
{
  test::Random random(SEED);
  for (int k = 0; k < test::cases(10000); ++k)
  {
    const double measure = std::ldexp(random.uniform(1.0, 2.0), random.integer(-60, 20));
    const double share = random.once(8) ? 1.0 : random.uniform(0.0, 1.0);
    const Interval part = partOf(Interval(measure), Interval(share));
    EXPECT_LE(Number(part.lower()), Number(measure) * share) << "case " << k;
    EXPECT_GE(Number(part.upper()), Number(measure) * share) << "case " << k;
  }
}

TEST(CubeCut, numbersWithoutMeaningSayNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Interval& share : { shareAbove(nan, { 1.0, 1.0, 1.0 }), shareAbove(0.0, { nan, 1.0, 1.0 }),
                                 shareAbove(0.1, { INF, 1.0, 1.0 }), shareAbove(1e-310, { 1e-309, 1e-310, 2e-309 }) })
    EXPECT_EQ(share, Interval(0.0, 1.0));
}

TEST(CubeCut, shareWithinSeveralPlanesHoldsThePointsThatAre)
{
  test::Random random(SEED);
  for (int k = 0; k < test::cases(100); ++k)
  {
    const std::vector<CubeCut> cuts = drawCuts(random);
    const int points = 2000;
    int surely = 0, maybe = 0;
    for (int n = 0; n < points; ++n)
    {
      const std::array<double, 3> delta = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                            random.uniform(-1.0, 1.0) };
      surely += isBeyondAll(cuts, &CubeCut::inner, delta) ? 1 : 0;
      maybe += isBeyondAll(cuts, &CubeCut::outer, delta) ? 1 : 0;
    }
    const Interval share = shareWithin(cuts.data(), cuts.size());
    const double slack = 5.0 * 0.5 / std::sqrt(points);
    EXPECT_LE(share.lower(), static_cast<double>(surely) / points + slack) << "seed " << SEED << ", case " << k;
    EXPECT_GE(share.upper(), static_cast<double>(maybe) / points - slack) << "seed " << SEED << ", case " << k;
  }
}

// One condition that is known in two ways is not paid for twice.
TEST(CubeCut, planesThatAreNearlyOneCutOffOnce)
{
  const CubeCut cut{ { 0.5, 0.3, 0.2 }, 0.0, INF };
  CubeCut again{ { 1.0, 0.6, 0.4 }, 0.0, INF };
  const std::array<CubeCut, 2> same = { cut, again };
  EXPECT_NEAR(shareWithin(same.data(), 2).lower(), 0.5, 1e-11);
  again.gradient[0] += 1e-4;
  again.inner -= 1e-4;
  const std::array<CubeCut, 2> near = { cut, again };
  EXPECT_GT(shareWithin(near.data(), 2).lower(), 0.4998);
  EXPECT_LE(shareWithin(near.data(), 2).lower(), 0.5);
  const CubeCut opposite{ { -0.5, -0.3, -0.2 }, 0.1, INF };
  const std::array<CubeCut, 2> slab = { cut, opposite };
  const double inner = shareAbove(0.1, cut.gradient).upper() - 0.5;
  EXPECT_LE(shareWithin(slab.data(), 2).lower(), inner);
  EXPECT_GT(shareWithin(slab.data(), 2).lower(), inner - 1e-9);
  EXPECT_EQ(shareWithin(nullptr, 0), Interval(1.0));
}
}  // namespace pkm_workspace
