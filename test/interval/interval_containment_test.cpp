// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <thread>

#include "pkm_workspace/interval/interval.h"
#include "support/exact.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
struct BinaryOperation
{
  const char* name;
  Interval (*evaluate)(const Interval&, const Interval&);
  MpfrBinary exact;
};
const BinaryOperation BINARY[] = {
  { "+", [](const Interval& x, const Interval& y) { return x + y; }, mpfr_add },
  { "-", [](const Interval& x, const Interval& y) { return x - y; }, mpfr_sub },
  { "*", [](const Interval& x, const Interval& y) { return x * y; }, mpfr_mul },
  { "/", [](const Interval& x, const Interval& y) { return x / y; }, mpfr_div },
};

struct UnaryOperation
{
  const char* name;
  Interval (*evaluate)(const Interval&);
  MpfrUnary exact;
};
const UnaryOperation UNARY[] = {
  { "-", [](const Interval& x) { return -x; }, mpfr_neg },
  { "sqr", sqr, mpfr_sqr },
  { "abs", abs, mpfr_abs },
  { "sqrt of abs", [](const Interval& x) { return sqrt(abs(x)); },
    [](mpfr_t result, const mpfr_t x, mpfr_rnd_t direction) {
      mpfr_abs(result, x, MPFR_RNDN);
      return mpfr_sqrt(result, result, direction);
    } },
};

constexpr int MEMBERS_OF_EACH = 6;

/// Whether the enclosure, computed under @p mode, holds the results for members of x and y; the text says what is
/// wrong.
testing::AssertionResult holds(const BinaryOperation& op, const RoundingMode& mode, const Interval& x,
                               const Interval& y, Operands& operands)
{
  const Interval enclosure = under<Interval>(mode, [&] { return op.evaluate(x, y); });
  for (int i = 0; i < MEMBERS_OF_EACH; ++i)
  {
    const double a = operands.member(x);
    const double b = operands.member(y);
    const auto exact = tightest(op.exact, a, b);
    if (!(enclosure.lower() <= exact.lower && exact.upper <= enclosure.upper()))
      return testing::AssertionFailure() << x << " " << op.name << " " << y << " = " << enclosure << " lacks "
                                         << Interval(a) << " " << op.name << " " << Interval(b);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult holds(const UnaryOperation& op, const RoundingMode& mode, const Interval& x,
                               Operands& operands)
{
  const Interval enclosure = under<Interval>(mode, [&] { return op.evaluate(x); });
  for (int i = 0; i < MEMBERS_OF_EACH; ++i)
  {
    const double a = operands.member(x);
    const auto exact = tightest(op.exact, a);
    if (!(enclosure.lower() <= exact.lower && exact.upper <= enclosure.upper()))
      return testing::AssertionFailure() << op.name << x << " = " << enclosure << " lacks the result for "
                                         << Interval(a);
  }
  return testing::AssertionSuccess();
}

/// All operations on the operands of one case.
testing::AssertionResult everyOperationHolds(const RoundingMode& mode, const Spread& spread, int seed)
{
  Operands operands(spread, static_cast<std::uint64_t>(seed));
  const Interval x = operands.interval();
  const Interval y = operands.partner(x);
  for (const auto& op : BINARY)
    if (op.exact != mpfr_div || !y.contains(0.0))
      if (auto result = holds(op, mode, x, y, operands); !result)
        return result << ", seed " << seed;
  for (const auto& op : UNARY)
    if (auto result = holds(op, mode, x, operands); !result)
      return result << ", seed " << seed;
  return testing::AssertionSuccess();
}

class IntervalContainment : public ModeAndSpread
{
};

TEST_P(IntervalContainment, operationsHoldTheResultsForAllMembers)
{
  for (int seed = 0; seed < cases(); ++seed)
    ASSERT_TRUE(everyOperationHolds(mode(), spread(), seed));
}

INSTANTIATE_TEST_SUITE_P(All, IntervalContainment, everyModeAndSpread(), nameOf);

TEST(IntervalContainment, doesNotDependOnOtherThreadsAndTheirModes)
{
  std::vector<std::thread> threads;
  for (const auto& mode : MODES)
    threads.emplace_back([&mode] {
      for (int seed = 0; seed < cases(); ++seed)
        for (const auto& spread : SPREADS)
          EXPECT_TRUE(everyOperationHolds(mode, spread, seed));
      mpfr_free_cache();
    });
  for (auto& thread : threads)
    thread.join();
}

TEST(IntervalContainment, sineAndCosineHoldTheExactValueBetweenNeighbours)
{
  for (int seed = 0; seed < cases(); ++seed)
    for (const auto& mode : MODES)
    {
      Random random(static_cast<std::uint64_t>(seed));
      const double angle = random.sign() * std::ldexp(random.uniform(1.0, 2.0), random.integer(-60, 20));
      const Interval sine = under<Interval>(mode, [&] { return sin(angle); });
      const Interval cosine = under<Interval>(mode, [&] { return cos(angle); });
      ASSERT_TRUE(sin(Exact(angle)).mayLieIn(sine)) << "sin " << Interval(angle) << " seed " << seed;
      ASSERT_TRUE(cos(Exact(angle)).mayLieIn(cosine)) << "cos " << Interval(angle) << " seed " << seed;
      ASSERT_LE(sine.upper(), std::nextafter(sine.lower(), 2.0));
      ASSERT_LE(cosine.upper(), std::nextafter(cosine.lower(), 2.0));
    }
  EXPECT_EQ(sin(0.0), Interval(0.0));
  EXPECT_EQ(cos(0.0), Interval(1.0));
}

TEST(IntervalContainment, anglesHoldThoseOfAllDirections)
{
  for (int seed = 0; seed < cases(); ++seed)
    for (const auto& mode : MODES)
      for (const auto& spread : SPREADS)
      {
        Operands operands(spread, static_cast<std::uint64_t>(seed));
        const Interval x = operands.interval(), y = operands.interval();
        const Interval angles = under<Interval>(mode, [&] { return angleOf(x, y); });
        for (int i = 0; i < MEMBERS_OF_EACH; ++i)
        {
          const double a = operands.member(x), b = operands.member(y);
          const auto exact = tightest(mpfr_atan2, b, a);
          ASSERT_LE(angles.lower(), exact.lower) << x << ", " << y << " seed " << seed;
          ASSERT_GE(angles.upper(), exact.upper) << x << ", " << y << " seed " << seed;
        }
      }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
