// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "pkm_workspace/interval/interval.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr double MAX = std::numeric_limits<double>::max();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

const Interval EMPTY = Interval::empty();
const Interval ENTIRE = Interval::entire();
const Interval POSITIVE(0.0, INF);
const Interval NEGATIVE(-INF, 0.0);

TEST(IntervalEdges, boundsThatAreNoSetOfNumbersAreRefusedWithTheirValues)
{
  using Error = std::invalid_argument;
  expectThrow<Error>([] { Interval(2.0, 1.0); }, R"(lower <= upper.*\[2, 1\])");
  expectThrow<Error>([] { Interval(0.1, -0.5); }, R"(\[0\.1, -0\.5\])");
  expectThrow<Error>([] { Interval(1.0, NOT_A_NUMBER); }, R"(\[1, nan\])");
  expectThrow<Error>([] { Interval(NOT_A_NUMBER, 1.0); }, R"(\[nan, 1\])");
  expectThrow<Error>([] { Interval x(NOT_A_NUMBER); }, R"(\[nan, nan\])");
  expectThrow<Error>([] { Interval(INF, -INF); }, R"(\[inf, -inf\])");
  expectThrow<Error>([] { Interval x(INF); }, R"(\[inf, inf\])");
  expectThrow<Error>([] { Interval x(-INF); }, R"(\[-inf, -inf\])");
}

TEST(IntervalEdges, operationsOutsideOfTheirDomainAreRefusedWithTheirOperand)
{
  using Error = std::domain_error;
  expectThrow<Error>([] { Interval(1.0) / Interval(0.0); }, R"(division by \[0, 0\].*contains 0)");
  expectThrow<Error>([] { Interval(1.0) / Interval(-1.0, 2.0); }, R"(\[-1, 2\])");
  expectThrow<Error>([] { Interval(0.0) / Interval(-2.0, -0.0); }, "contains 0");
  expectThrow<Error>([] { ENTIRE / ENTIRE; }, R"(\[-inf, inf\])");
  expectThrow<Error>([] { sqrt(Interval(-1.0, 4.0)); }, R"(square root of \[-1, 4\].*below 0)");
  expectThrow<Error>([] { sqrt(Interval(-0x1p-1074, 4.0)); }, "below 0");
  EXPECT_THROW(sin(INF), std::invalid_argument);
  EXPECT_THROW(cos(NOT_A_NUMBER), std::invalid_argument);
}

TEST(IntervalEdges, emptyOperandsGiveEmptyResults)
{
  const Interval one(1.0);
  for (const Interval& result :
       { -EMPTY, EMPTY + one, one + EMPTY, EMPTY - one, one - EMPTY, EMPTY * one, one * EMPTY, EMPTY * ENTIRE,
         EMPTY / one, one / EMPTY, EMPTY / Interval(0.0), sqr(EMPTY), sqrt(EMPTY), abs(EMPTY), hull(EMPTY, EMPTY),
         intersection(EMPTY, one), intersection(one, EMPTY), intersection(Interval(1.0, 2.0), Interval(3.0, 4.0)) })
  {
    EXPECT_TRUE(result.isEmpty()) << result;
    EXPECT_EQ(result, EMPTY);
  }
  EXPECT_EQ(hull(EMPTY, one), one);
  EXPECT_EQ(hull(one, EMPTY), one);
}

TEST(IntervalEdges, theEmptySetHasNoMembersAndNoSign)
{
  EXPECT_FALSE(EMPTY.contains(0.0));
  EXPECT_FALSE(EMPTY.contains(INF));
  EXPECT_FALSE(EMPTY.intersects(ENTIRE));
  EXPECT_FALSE(ENTIRE.intersects(EMPTY));
  EXPECT_TRUE(EMPTY.isSubsetOf(Interval(3.0)));
  EXPECT_FALSE(Interval(3.0).isSubsetOf(EMPTY));
  EXPECT_FALSE(EMPTY.certainlyPositive());
  EXPECT_FALSE(EMPTY.certainlyNegative());
  EXPECT_FALSE(EMPTY.isSingle());
  EXPECT_FALSE(EMPTY.isBounded());
  EXPECT_EQ(EMPTY.width(), 0.0);
  EXPECT_EQ(EMPTY.radius(), 0.0);
}

TEST(IntervalEdges, zeroTimesTheUnboundedIsZero)
{
  EXPECT_EQ(Interval(0.0) * ENTIRE, Interval(0.0));
  EXPECT_EQ(POSITIVE * Interval(-0.0), Interval(0.0));
  EXPECT_EQ(Interval(0.0, 1.0) * POSITIVE, POSITIVE);
  EXPECT_EQ(Interval(-1.0, 0.0) * POSITIVE, NEGATIVE);
  EXPECT_EQ(Interval(-1.0, 1.0) * Interval(1.0, INF), ENTIRE);
}

TEST(IntervalEdges, unboundedOperandsFollowTheLimits)
{
  EXPECT_EQ(POSITIVE + POSITIVE, POSITIVE);
  EXPECT_EQ(POSITIVE + NEGATIVE, ENTIRE);
  EXPECT_EQ(POSITIVE - POSITIVE, ENTIRE);
  EXPECT_EQ(-POSITIVE, NEGATIVE);
  EXPECT_EQ(NEGATIVE * NEGATIVE, POSITIVE);
  EXPECT_EQ(Interval(2.0, INF) * Interval(3.0, INF), Interval(6.0, INF));
  EXPECT_EQ(Interval(1.0, 2.0) / Interval(1.0, INF), Interval(0.0, 2.0));
  EXPECT_EQ(Interval(1.0, 2.0) / Interval(-INF, -1.0), Interval(-2.0, 0.0));
  EXPECT_EQ(POSITIVE / Interval(2.0), POSITIVE);
  EXPECT_EQ(POSITIVE / Interval(1.0, INF), POSITIVE);
  EXPECT_EQ(Interval(1.0, INF) / Interval(-INF, -1.0), NEGATIVE);
  EXPECT_EQ(ENTIRE / Interval(1.0, INF), ENTIRE);
  EXPECT_EQ(sqr(NEGATIVE), POSITIVE);
  EXPECT_EQ(sqrt(Interval(4.0, INF)), Interval(2.0, INF));
  EXPECT_EQ(abs(ENTIRE), POSITIVE);
  EXPECT_EQ(ENTIRE.width(), INF);
  EXPECT_EQ(POSITIVE.radius(), INF);
}

TEST(IntervalEdges, overflowAndUnderflowAreEnclosed)
{
  if (!rounding::SOUND)
    GTEST_SKIP() << "the canary build has no width";
  constexpr double TINIEST = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(Interval(MAX) + Interval(MAX), Interval(MAX, INF));
  EXPECT_EQ(Interval(-MAX) * Interval(2.0), Interval(-INF, -MAX));
  EXPECT_EQ(Interval(MAX) / Interval(0.5), Interval(MAX, INF));
  EXPECT_EQ(Interval(TINIEST) * Interval(TINIEST), Interval(0.0, TINIEST));
  EXPECT_EQ(Interval(-TINIEST) / Interval(MAX), Interval(-TINIEST, 0.0));
  EXPECT_EQ(sqr(Interval(-TINIEST, 0.0)), Interval(0.0, TINIEST));
}

TEST(IntervalEdges, signsAndOrderAreCertainOnly)
{
  EXPECT_TRUE(Interval(1.0, 2.0).certainlyPositive());
  EXPECT_FALSE(Interval(0.0, 2.0).certainlyPositive());
  EXPECT_TRUE(Interval(-2.0, -1.0).certainlyNegative());
  EXPECT_FALSE(Interval(-2.0, 0.0).certainlyNegative());
  EXPECT_TRUE(Interval(1.0, 2.0).intersects(Interval(2.0, 3.0)));
  EXPECT_EQ(intersection(Interval(1.0, 2.0), Interval(2.0, 3.0)), Interval(2.0));
  EXPECT_FALSE(Interval(1.0, 2.0).contains(NOT_A_NUMBER));
  EXPECT_EQ(Interval(-3.0, 2.0).magnitude(), 3.0);
  EXPECT_EQ(Interval(-3.0, 2.0).mignitude(), 0.0);
  EXPECT_EQ(Interval(-3.0, -2.0).mignitude(), 2.0);
}

TEST(IntervalEdges, printedBoundsReadBackToTheSameNumbers)
{
  std::ostringstream text;
  text << Interval(0.1, 1.0 / 3.0) << " " << Interval::empty() << " " << 0.1;
  EXPECT_EQ(text.str(), "[0.1, 0.3333333333333333] [empty] 0.1");
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
