// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <sstream>

#include "pkm_workspace/interval/interval.h"
#include "support/exact.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
Interval toInterval(const rounding::Bounds& bounds)
{
  return Interval(bounds.lower, bounds.upper);
}

/// The smallest interval of doubles with all results for a member of x and a member of y; the operation is monotone in
/// each.
Interval smallest(MpfrBinary function, const Interval& x, const Interval& y)
{
  Interval result = Interval::empty();
  for (const double a : { x.lower(), x.upper() })
    for (const double b : { y.lower(), y.upper() })
      result = hull(result, toInterval(tightest(function, a, b)));
  return result;
}

Interval smallest(MpfrUnary function, const Interval& x)
{
  return hull(toInterval(tightest(function, x.lower())), toInterval(tightest(function, x.upper())));
}

class IntervalTightness : public ModeAndSpread
{
protected:
  void SetUp() override
  {
    if (!rounding::SOUND)
      GTEST_SKIP() << "the canary build has no width";
  }
};

TEST_P(IntervalTightness, resultsAreTheSmallestThatDoublesAllow)
{
  for (int seed = 0; seed < cases(); ++seed)
  {
    Operands values = operands(seed);
    const Interval x = values.interval();
    const Interval y = values.partner(x);
    const RoundingScope scope(mode());
    ASSERT_EQ(x + y, smallest(mpfr_add, x, y)) << x << " + " << y << " seed " << seed;
    ASSERT_EQ(x - y, smallest(mpfr_sub, x, y)) << x << " - " << y << " seed " << seed;
    ASSERT_EQ(x * y, smallest(mpfr_mul, x, y)) << x << " * " << y << " seed " << seed;
    if (!y.contains(0.0))
    {
      ASSERT_EQ(x / y, smallest(mpfr_div, x, y)) << x << " / " << y << " seed " << seed;
    }
    ASSERT_EQ(sqr(x), smallest(mpfr_sqr, abs(x))) << x << " seed " << seed;
    ASSERT_EQ(sqrt(abs(x)), smallest(mpfr_sqrt, abs(x))) << x << " seed " << seed;
  }
}

/// IEEE 1788's inclusion: what is computed from parts lies within what is computed from the whole.
class IntervalInclusion : public ModeAndSpread
{
};

TEST_P(IntervalInclusion, partsGivePartsOfTheResult)
{
  for (int seed = 0; seed < cases(); ++seed)
  {
    Operands values = operands(seed);
    const Interval x = values.interval();
    const Interval y = values.partner(x);
    const Interval a = values.part(x);
    const Interval b = values.part(y);
    const RoundingScope scope(mode());
    const auto message = [&] {
      std::ostringstream text;
      text << a << " in " << x << ", " << b << " in " << y << ", seed " << seed;
      return text.str();
    };
    ASSERT_TRUE((a + b).isSubsetOf(x + y)) << message();
    ASSERT_TRUE((a - b).isSubsetOf(x - y)) << message();
    ASSERT_TRUE((a * b).isSubsetOf(x * y)) << message();
    if (!y.contains(0.0))
    {
      ASSERT_TRUE((a / b).isSubsetOf(x / y)) << message();
    }
    ASSERT_TRUE(sqr(a).isSubsetOf(sqr(x))) << message();
    ASSERT_TRUE(sqr(a).isSubsetOf(a * a)) << message();
    ASSERT_TRUE(sqrt(abs(a)).isSubsetOf(sqrt(abs(x)))) << message();
    ASSERT_TRUE(hull(a, b).isSubsetOf(hull(x, y))) << message();
    ASSERT_TRUE(intersection(a, b).isSubsetOf(intersection(x, y))) << message();
  }
}

INSTANTIATE_TEST_SUITE_P(All, IntervalTightness, everyRoundingModeAndSpread(), nameOf);
INSTANTIATE_TEST_SUITE_P(All, IntervalInclusion, everyRoundingModeAndSpread(), nameOf);

TEST(IntervalWidth, ofExactResultsIsZero)
{
  EXPECT_TRUE((Interval(7.0) / Interval(7.0)).isSingle());
  EXPECT_TRUE((Interval(0.1) - Interval(0.1)).isSingle());
  EXPECT_TRUE(sqrt(Interval(0x1p-1074) * Interval(0x1p10)).isSingle());
  EXPECT_TRUE((Interval(0x1p-1000) / Interval(0x1p70)).isSingle());
  EXPECT_TRUE((Interval(0x1p-537) * Interval(0x1p-537)).isSingle());
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
