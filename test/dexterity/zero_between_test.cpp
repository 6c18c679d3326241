// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/zero_between.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double LEAST = std::numeric_limits<double>::denorm_min();
constexpr double LARGEST = std::numeric_limits<double>::max();

int signOf(double value)
{
  return value < 0.0 ? -1 : value > 0.0 ? 1 : 0;
}
}  // namespace

TEST(ZeroBetween, findsTheZeroOfALinearFunction)
{
  for (const double zero : { 0.0, 0.3, -0.7, 0.5, -0.9999 })
  {
    Vector3d low(-1.0, 2.0, -3.0);
    Vector3d high(1.0, 2.0, 5.0);
    narrowZero(low, high, 1e-9, [zero](const Vector3d& p) { return signOf(p.x() - zero); });
    EXPECT_LE((high - low).norm(), 1e-9);
    EXPECT_LE(low.x(), zero);
    EXPECT_GE(high.x(), zero);
  }
}

// Far from the origin neighbouring doubles are further apart than what is asked for.
TEST(ZeroBetween, endsWhereDoublesEnd)
{
  Vector3d low = Vector3d::Constant(1e12);
  Vector3d high = Vector3d::Constant(1e12 + 1.0);
  int looks = 0;
  narrowZero(low, high, 1e-6, [&looks](const Vector3d& p) { return ++looks, signOf(p.x() - (1e12 + 0.3)); });
  EXPECT_LE((high - low).maxCoeff(), 0x1p-11);  // four of them
  EXPECT_LE(looks, 40);
}

TEST(ZeroBetween, endsForAnyNumbers)
{
  int looks = 0;
  const std::vector<std::function<int(const Vector3d&)>> signs = {
    [](const Vector3d&) { return 0; },
    [](const Vector3d&) { return -1; },
    [](const Vector3d&) { return 1; },
    [&looks](const Vector3d&) { return looks % 2 == 0 ? -1 : 1; },
    [&looks](const Vector3d&) { return looks % 3 - 1; },
    [](const Vector3d& p) { return signOf(p.x()); },
  };
  const double values[] = { 0.0, 1.0, -1.0, LEAST, -LEAST, LARGEST, -LARGEST, INF, -INF, NOT_A_NUMBER, 1e12 };
  for (const double finest : { 1e-6, 0.0, -1.0, INF, NOT_A_NUMBER })
    for (const double first : values)
      for (const double last : values)
        for (std::size_t k = 0; k < signs.size(); ++k)
        {
          Vector3d low(first, 0.0, 1.0);
          Vector3d high(last, 0.0, first);
          looks = 0;
          narrowZero(low, high, finest, [&](const Vector3d& p) { return ++looks, signs[k](p); });
          EXPECT_LE(looks, 2 * MOST_STEPS) << first << " to " << last << ", finest " << finest << ", sign " << k;
        }
}
}  // namespace test
}  // namespace pkm_workspace
