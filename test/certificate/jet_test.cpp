// SPDX-License-Identifier: BSD-3-Clause
// Functions over boxes of the checker of certificates, against their members in 100 digits.
#include "jet.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <sstream>

#include "support/random.h"

namespace pkm_workspace
{
namespace checking
{
namespace
{
using test::Random;
using Number = boost::multiprecision::cpp_bin_float_100;
using Delta = std::array<double, 3>;

Number exactly(const Ball::Middle& x)
{
  std::ostringstream text;
  text << std::setprecision(60) << x;
  return Number(text.str());
}

/// A member of a jet at one delta.
struct Member
{
  Jet jet;
  Number value;
};

Member drawn(Random& random, const Delta& delta, double size)
{
  Member member;
  const double value = random.uniform(-1.0, 1.0);
  member.jet = Jet(Ball(value));
  member.value = value;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const double slope = random.uniform(-size, size);
    member.jet.slope[j] = Ball(slope);
    member.value += Number(slope) * delta[j];
  }
  return member;
}

/// Whether value + slope . delta has it.
testing::AssertionResult holds(const Member& member, const Delta& delta)
{
  Ball enclosure = member.jet.value;
  for (std::size_t j = 0; j < 3; ++j)
    enclosure = enclosure + member.jet.slope[j] * Ball(delta[j]);
  const Number slack("1e-36");  // of printing, 60 digits of some forty; of sums
  const bool is_held =
      exactly(enclosure.lower()) - slack <= member.value && member.value <= exactly(enclosure.upper()) + slack;
  return (is_held ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "[" << enclosure.lower() << ", " << enclosure.upper() << "] and " << member.value;
}
}  // namespace

TEST(Jet, holdsWhatItsMembersBecome)
{
  for (int seed = 0; seed < test::cases(2000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const double size = std::pow(2.0, random.integer(-20, 0));
    Delta delta;
    for (double& d : delta)
      d = random.once(2) ? random.uniform(-1.0, 1.0) : random.sign();
    const Member f = drawn(random, delta, size), g = drawn(random, delta, size);
    const Member product{ f.jet * g.jet, f.value * g.value };
    ASSERT_TRUE(holds(product, delta)) << "product, seed " << seed;
    const Member difference{ product.jet - f.jet, product.value - f.value };
    ASSERT_TRUE(holds(difference, delta)) << "difference, seed " << seed;
    const Jet square = g.jet * g.jet + Jet(Ball(0.125));
    const Number value = g.value * g.value + Number(0.125);
    if (square.range().isPositive())
    {
      ASSERT_TRUE(holds({ difference.jet / square, difference.value / value }, delta)) << "quotient, seed " << seed;
    }
    const double least = random.once(3) ? 0.0 : random.uniform(0.0, 0.25);
    if (value >= least)
    {
      ASSERT_TRUE(holds({ rootAbove(square, least), sqrt(value) }, delta)) << "root, seed " << seed;
    }
    const Jet near_one = Jet(Ball(1.0)) + Ball(0.2) * f.jet;  // no product: its slopes are numbers
    ASSERT_TRUE(holds({ rootAbove(near_one, 0.01), sqrt(1 + Number(0.2) * f.value) }, delta)) << "root, seed " << seed;
    EXPECT_LE(exactly(product.jet.range().lower()), product.value);
    EXPECT_GE(exactly(product.jet.range().upper()), product.value);
  }
}
}  // namespace checking
}  // namespace pkm_workspace
