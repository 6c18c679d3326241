// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/rounding.h"

#include <gtest/gtest.h>

#include "support/exact.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using rounding::Bounds;

/// One operation: how the library encloses it, and the oracle.
struct Operation
{
  const char* name;
  Bounds (*enclose)(double, double);
  MpfrBinary exact;
};
const Operation OPERATIONS[] = { { "+", rounding::add, mpfr_add },
                                 { "*", rounding::multiply, mpfr_mul },
                                 { "/", rounding::divide, mpfr_div } };

/// What one case found: the operands, the enclosure and the tightest one.
struct Finding
{
  const char* operation;
  double a, b;
  Bounds enclosure, best;
};

std::ostream& operator<<(std::ostream& stream, const Finding& x)
{
  return stream << std::hexfloat << x.a << " " << x.operation << " " << x.b << ": [" << x.enclosure.lower << ", "
                << x.enclosure.upper << "], exactly within [" << x.best.lower << ", " << x.best.upper << "]";
}

/// Hands each operation on the operands of each case to @p judge, until one fails.
template <class Judge>
void forEachOperation(const RoundingMode& mode, const Spread& spread, const Judge& judge)
{
  for (int seed = 0; seed < cases() && !testing::Test::HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Operands operands(spread, static_cast<std::uint64_t>(seed));
    const double a = operands.number();
    const double b = operands.partner(a);
    for (const auto& operation : OPERATIONS)
      if (b != 0.0 || operation.exact != mpfr_div)
        judge(Finding{ operation.name, a, b, under<Bounds>(mode, [&] { return operation.enclose(a, b); }),
                       tightest(operation.exact, a, b) });
    const double r = std::abs(a);
    judge(
        Finding{ "sqrt", r, r, under<Bounds>(mode, [&] { return rounding::squareRoot(r); }), tightest(mpfr_sqrt, r) });
  }
}

class RoundingContainment : public ModeAndSpread
{
};

TEST_P(RoundingContainment, boundsHoldTheExactResult)
{
  forEachOperation(mode(), spread(), [](const Finding& x) {
    ASSERT_LE(x.enclosure.lower, x.best.lower) << x;
    ASSERT_GE(x.enclosure.upper, x.best.upper) << x;
  });
}

class RoundingTightness : public ModeAndSpread
{
};

TEST_P(RoundingTightness, boundsAreNeighbouringDoublesAndExactResultsAreSingle)
{
  if (!rounding::SOUND)
    GTEST_SKIP() << "the canary build has no width";
  forEachOperation(mode(), spread(), [](const Finding& x) {
    ASSERT_EQ(x.enclosure.lower, x.best.lower) << x;
    ASSERT_EQ(x.enclosure.upper, x.best.upper) << x;
  });
}

INSTANTIATE_TEST_SUITE_P(All, RoundingContainment, everyModeAndSpread(), nameOf);
INSTANTIATE_TEST_SUITE_P(All, RoundingTightness, everyModeAndSpread(), nameOf);

TEST(RoundingMode, isReallySetForThePropertiesAbove)
{
  const std::function<double()> third = [] {
    volatile double one = 1.0;
    return one / 3.0;
  };
  EXPECT_LT(under(ROUNDING_MODES[2], third), under(ROUNDING_MODES[1], third));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "the mode must be back";
}

#ifdef __SSE2__
TEST(RoundingMode, reallyFlushesForThePropertiesAbove)
{
  const std::function<double()> half = [] {
    volatile double least = std::numeric_limits<double>::min();
    return least / 2.0;
  };
  EXPECT_GT(under(ROUNDING_MODES[0], half), 0.0);
  EXPECT_EQ(under(MODES[4], half), 0.0);
}
#endif

class RoundingSelfTest : public testing::TestWithParam<RoundingMode>
{
};

/// Threads that flush subnormal numbers to zero included: nothing is lost on them.
TEST_P(RoundingSelfTest, acceptsThisMachineInEveryRoundingMode)
{
  EXPECT_EQ(under<std::string>(GetParam(), rounding::selfTest), "");
}

INSTANTIATE_TEST_SUITE_P(All, RoundingSelfTest, testing::ValuesIn(MODES), nameOfMode);

}  // namespace
}  // namespace test
}  // namespace pkm_workspace
