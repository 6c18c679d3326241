// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/decimal.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>

#include "support/random.h"

namespace pkm_workspace
{
namespace
{
constexpr std::uint64_t SEED = 20260101;

/// The sign of (number in the text) - value; exact for the numbers below, which need far less than 2000 bits.
int compare(const std::string& text, double value)
{
  mpfr_t number;
  mpfr_init2(number, 2000);
  EXPECT_EQ(0, mpfr_set_str(number, text.c_str(), 10, MPFR_RNDN)) << text;
  const int sign = mpfr_cmp_d(number, value);
  mpfr_clear(number);
  return sign;
}

TEST(Decimal, roundedDownIsNeverAboveAndRoundedUpNeverBelow)
{
  test::Random random(SEED);
  for (int i = 0; i < test::cases(2000); ++i)
  {
    const double value = random.sign() * std::pow(10.0, random.uniform(-6.0, 6.0));
    const int decimals = random.integer(0, 17);
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", value " + exact(value) + ", decimals " + std::to_string(decimals));
    EXPECT_LE(compare(roundedDown(value, decimals), value), 0);
    EXPECT_GE(compare(roundedUp(value, decimals), value), 0);
    const double step = std::stod(roundedUp(value, decimals)) - std::stod(roundedDown(value, decimals));
    EXPECT_LE(step, std::pow(10.0, -decimals) + 1e-9 * std::abs(value));
  }
}

TEST(Decimal, decimalsThatNoDoubleIsAreRoundedByTheirTrueValue)
{
  EXPECT_EQ("0.5", roundedDown(0.5, 1));
  EXPECT_EQ("0.5", roundedUp(0.5, 1));
  EXPECT_EQ("0.2", roundedDown(0.3, 1));  // the double 0.3 is below 3/10
  EXPECT_EQ("0.3", roundedUp(0.3, 1));
  EXPECT_EQ("0.1", roundedDown(0.1, 1));  // the double 0.1 is above 1/10
  EXPECT_EQ("0.2", roundedUp(0.1, 1));
  EXPECT_EQ("-0.3", roundedDown(-0.3, 1));
  EXPECT_EQ("-0.2", roundedUp(-0.3, 1));
}

TEST(Decimal, exactReadsBackAsTheSameDouble)
{
  test::Random random(SEED);
  for (int i = 0; i < test::cases(2000); ++i)
  {
    const double value = random.sign() * std::pow(10.0, random.uniform(-300.0, 300.0));
    EXPECT_EQ(value, std::stod(exact(value))) << "seed " << SEED;
  }
  EXPECT_EQ("0.1", exact(0.1));
  EXPECT_EQ("-50", exact(-50.0));
}

TEST(Decimal, bracketKeepsItsEndsApart)
{
  EXPECT_EQ("0.64395 to 0.64495", bracket(0.643955, 0.644945));
  EXPECT_EQ("643.9505 to 643.9604", bracket(643.95053, 643.96035));
  EXPECT_EQ("0 to 0", bracket(0.0, 0.0));
  EXPECT_EQ("0 to 12", bracket(0.0, 12.0));
}
}  // namespace
}  // namespace pkm_workspace
