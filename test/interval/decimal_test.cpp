// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/decimal.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <Eigen/Core>
#include <cmath>
#include <sstream>

#include "pkm_workspace/interval/interval.h"
#include "pkm_workspace/interval/text_stream.h"
#include "support/comma_locale.h"
#include "support/random.h"
#include "support/rounding_mode.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

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

TEST(Decimal, exactIsWhatPeopleWrite)
{
  for (const char* const text :
       { "0.3", "-0.3", "0.1", "1e+22", "1e-05", "123456.789", "0", "5e-324", "2.2e-308", "inf" })
    EXPECT_EQ(text, exact(std::strtod(text, nullptr)));
  EXPECT_EQ("0.30000000000000004", exact(0.1 + 0.2));
  EXPECT_EQ("0", exact(-0.0));
  EXPECT_EQ("0", nearly(-0.0));
}

TEST(Decimal, exactReadsBackWhateverTheRounding)
{
  test::Random random(SEED);
  for (const test::RoundingMode& mode : test::ROUNDING_MODES)
  {
    const test::RoundingScope scope(mode);
    for (int i = 0; i < 500; ++i)
    {
      const double value = random.sign() * random.uniform(0.1, 100.0);
      EXPECT_EQ(value, *parseNumber(exact(value))) << mode << ", seed " << SEED;
    }
    EXPECT_EQ("0.3", exact(0.3)) << mode;
  }
}

TEST(Decimal, parseNumberTakesAllOfAText)
{
  EXPECT_EQ(parseNumber("0.3"), 0.3);
  EXPECT_EQ(parseNumber("-1e-3"), -1e-3);
  for (const std::string& text : { std::string(""), std::string(" 1"), std::string("1 "), std::string("0,5"),
                                   std::string("0.1\0garbage", 11), std::string("1\0", 2), std::string("x") })
    EXPECT_FALSE(parseNumber(text)) << text;
  for (const char* const text : { "1e999", "-1e999", "1e-400", "nan" })
    EXPECT_TRUE(std::isnan(*parseNumber(text))) << text;
}

TEST(Decimal, noTextFollowsTheLocale)
{
  const test::CommaLocale locale;
  TextStream text;
  text << 0.3 << ' ' << 1234567 << ' ' << 1234.5 << ' ' << Interval(0.25, 1e6);
  EXPECT_EQ("0.3 1234567 1234.5 [0.25, 1000000]", text.str());
  text.str("");
  text.width(4);
  text << 0.3 << '|' << Eigen::RowVector3d(0.0, 0.25, 1.0) << '|';
  EXPECT_EQ(" 0.3|   0 0.25    1|", text.str());
  std::ostringstream stream;
  stream << Interval(0.25, 0.5);
  EXPECT_EQ("[0.25, 0.5]", stream.str());
  EXPECT_EQ("1234.5", exact(1234.5));
  EXPECT_EQ("1234.5", nearly(1234.5));
  EXPECT_EQ("1234.500 to 1234.750", bracket(1234.5, 1234.75));
  EXPECT_EQ("0.2", roundedDown(0.3, 1));
  EXPECT_EQ(parseNumber("0.5"), 0.5);
  EXPECT_FALSE(parseNumber("0,5"));
}

TEST(Decimal, bracketShowsThreeDigitsOfItsWidth)
{
  EXPECT_EQ("0.643955 to 0.644945", bracket(0.6439553, 0.6449447));
  EXPECT_EQ("643.95053 to 643.96035", bracket(643.950534, 643.960346));
  EXPECT_EQ("0 to 0", bracket(0.0, 0.0));
  EXPECT_EQ("0.0 to 12.0", bracket(0.0, 12.0));
  EXPECT_EQ("-1 to 100", bracket(-0.5, 100.0));
  EXPECT_EQ("0.299999999 to 0.300000000", bracket(0.3, 0.3));
  EXPECT_EQ("1000000000 to 1000000256", bracket(1e9, 1e9 + 256));
}
}  // namespace
}  // namespace pkm_workspace
