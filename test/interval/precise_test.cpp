// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/precise.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

namespace pkm_workspace
{
namespace
{
using Reference = boost::multiprecision::cpp_bin_float_100;
using Form = AffineForm<Precise>;

using test::SEED;
constexpr int CASES = 300;

Reference exactly(const Precise& x)
{
  return Reference(x.number().str(0, std::ios_base::scientific));
}

/// The member of a form at delta = (1, -1, 1), with its error left out.
Reference memberOf(const Form& form)
{
  return exactly(form.center) + exactly(form.gradient[0]) - exactly(form.gradient[1]) + exactly(form.gradient[2]);
}

class PreciseContainment : public testing::Test
{
protected:
  Form form()
  {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto number = [&] { return Precise(uniform(generator_)) / Precise(3.0); };
    return { number() + Precise(3.0), { number(), number(), number() }, Precise(0.0) };
  }

  std::mt19937_64 generator_{ SEED };
};
}  // namespace

TEST_F(PreciseContainment, operationsOnFormsHoldThoseOfTheirMembers)
{
  for (int k = 0; k < CASES; ++k)
  {
    const Form a = form();
    const Form b = form();
    const Reference x = memberOf(a);
    const Reference y = memberOf(b);
    const auto expectHolds = [k](const Form& result, const Reference& value) {
      EXPECT_LE(abs(value - memberOf(result)), exactly(result.radius)) << "case " << k << ", seed " << SEED;
    };
    expectHolds(a + b, x + y);
    expectHolds(a * b, x * y);
    expectHolds(sqrtAbove(a, Precise(0.0)), sqrt(x));
    expectHolds(inverseOf(a), 1 / x);
  }
}

TEST_F(PreciseContainment, doublesEncloseThePreciseForm)
{
  for (int k = 0; k < CASES; ++k)
  {
    const Form a = form();
    const AffineForm<double> d = inDoubles(a);
    const Reference member = Reference(d.center) + d.gradient[0] - d.gradient[1] + d.gradient[2];
    EXPECT_LE(abs(memberOf(a) - member), Reference(d.radius)) << "case " << k << ", seed " << SEED;
    EXPECT_LT(d.radius, 1e-14);
    EXPECT_LE(Reference(a.center.below(0)), exactly(a.center));
    EXPECT_GE(Reference(a.center.above(0)), exactly(a.center));
    EXPECT_LE(a.center.above(0), std::nextafter(a.center.below(0), 10.0));
  }
}

TEST(Precise, hasFiftyDigits)
{
  const Precise third = Precise(1.0) / Precise(3.0);
  const Reference error = abs(exactly(third) * 3 - 1);
  EXPECT_LT(error, Reference(1e-49));
  EXPECT_GT(error, Reference(0));
  EXPECT_LT(rounding::roundoff<Precise>()[0], 1e-48);
}
}  // namespace pkm_workspace
