// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/interval/interval.h"
#include "support/exact.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
class IntervalQueryContainment : public ModeAndSpread
{
};

TEST_P(IntervalQueryContainment, midLiesInsideAndRadiusAndWidthReachTheEnds)
{
  for (int seed = 0; seed < cases(); ++seed)
  {
    const Interval x = operands(seed).interval();
    struct Queries
    {
      double mid, radius, width;
    };
    const auto got = under<Queries>(mode(), [&] { return Queries{ x.mid(), x.radius(), x.width() }; });
    ASSERT_TRUE(x.contains(got.mid)) << x << " seed " << seed;
    ASSERT_GE(got.width, tightest(mpfr_sub, x.upper(), x.lower()).upper) << x << " seed " << seed;
    ASSERT_GE(got.radius, tightest(mpfr_sub, x.upper(), got.mid).upper) << x << " seed " << seed;
    ASSERT_GE(got.radius, tightest(mpfr_sub, got.mid, x.lower()).upper) << x << " seed " << seed;
    ASSERT_EQ(got.radius == 0.0, x.isSingle()) << x << " seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(All, IntervalQueryContainment, everyModeAndSpread(), nameOf);
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
