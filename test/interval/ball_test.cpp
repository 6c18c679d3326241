// SPDX-License-Identifier: BSD-3-Clause
// Balls hold what they should: against exact numbers, in all rounding modes.
#include "pkm_workspace/interval/ball.h"

#include <gtest/gtest.h>

#include <cfenv>

#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Wide =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<400>, boost::multiprecision::et_off>;

/// A member of a ball: its middle and a share of the radius.
struct Member
{
  Ball ball;
  Wide value;
};

/// Magnitudes from 1e-12 to 1e12, radii from nothing to as much; middles that have more digits than a double.
Member someMember(Random& random)
{
  if (random.once(50))
    return { Ball(), Wide(0) };
  const double middle = random.sign() * std::pow(10.0, random.uniform(-12.0, 12.0));
  const double radius = random.once(3) ? 0.0 : std::abs(middle) * std::pow(10.0, random.uniform(-40.0, 0.3));
  const double share = random.once(3) ? random.sign() : random.uniform(-1.0, 1.0);
  const Ball::Middle more = (Ball(middle) * Ball(1.0 / 3.0) + Ball(middle * 0x1p-60)).middle();
  return { Ball(more, radius), Wide(more) + Wide(radius) * Wide(share) };
}

void expectHas(const Ball& ball, const Wide& value)
{
  EXPECT_LE(Wide(ball.lower()), value);
  EXPECT_GE(Wide(ball.upper()), value);
  EXPECT_FALSE(ball.isPositive() && value <= 0);
  EXPECT_FALSE(ball.isNegative() && value >= 0);
}
}  // namespace

TEST(Ball, hasWhatItsMembersBecome)
{
  Random random(SEED);
  for (const int mode : { FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO })
    for (int k = 0; k < cases(20000); ++k)
    {
      const Member a = someMember(random);
      const Member b = someMember(random);
      std::fesetround(mode);
      const Ball sum = a.ball + b.ball;
      const Ball difference = a.ball - b.ball;
      const Ball product = a.ball * b.ball;
      const Ball quotient = a.ball / b.ball;
      const Ball wider = a.ball.widenedBy(b.ball.most());
      const Ball root = sqrt(a.ball);
      const Ball hull =
          Ball::between(std::min(a.ball.lower(), b.ball.lower()), std::max(a.ball.upper(), b.ball.upper()));
      std::fesetround(FE_TONEAREST);
      expectHas(sum, a.value + b.value);
      expectHas(difference, a.value - b.value);
      expectHas(product, a.value * b.value);
      expectHas(wider, a.value + b.value);
      expectHas(wider, a.value - b.value);
      if (std::isfinite(quotient.radius()))
        expectHas(quotient, a.value / b.value);
      if (a.value >= 0)
        expectHas(root, sqrt(a.value));
      expectHas(hull, a.value);
      expectHas(hull, b.value);
      if (HasFailure())
        return;
    }
}

TEST(Ball, isExactWhereNothingIsRounded)
{
  EXPECT_EQ((Ball(0.1) + Ball(0.2)).radius(), 0.0);
  EXPECT_EQ((Ball(0.1) * Ball(0.2) - Ball(1e-12)).radius(), 0.0);
  EXPECT_EQ((Ball(0.0) * Ball(0.1)).radius(), 0.0);
  EXPECT_GT((Ball(1.0) + Ball(0x1p-140)).radius(), 0.0);
  EXPECT_GT((Ball(1.0) / Ball(3.0)).radius(), 0.0);
}

TEST(Ball, staysNarrow)
{
  const Ball third = Ball(1.0) / Ball(3.0);
  EXPECT_LT(third.radius(), 1e-38);
  EXPECT_LT((third * Ball(3.0) - Ball(1.0)).most(), 1e-37);
  EXPECT_LT(sqrt(Ball(2.0)).radius(), 1e-37);
}

TEST(Ball, divisionByWhatMayBeNothingTellsNothing)
{
  const Ball quotient = Ball(1.0) / Ball(Ball::Middle(1), 1.0);
  EXPECT_FALSE(quotient.isPositive() || quotient.isNegative());
  EXPECT_TRUE(std::isinf(quotient.most()));
}
}  // namespace test
}  // namespace pkm_workspace
