// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/determinant.h"
#include "support/form_laws.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Number = Enclosed<double>;

Number randomNumber(Forms& forms)
{
  return { forms.number(), forms.random().once(4) ? 0.0 : forms.error() };
}

/// Half of the partners nearly cancel @p other.
Number partnerOf(const Number& other, Forms& forms)
{
  Number partner = randomNumber(forms);
  if (forms.random().once(2))
    partner.value = std::nextafter(-other.value, forms.random().sign() * 1e300);
  return partner;
}

Exact memberOf(const Number& x, Forms& forms)
{
  return Exact(x.value) + forms.within(x.radius);
}

bool holds(const Number& x, const Exact& value)
{
  return (value - x.value).mayLieIn(-x.radius, x.radius);
}

class EnclosedContainment : public FormLaws
{
};

TEST_P(EnclosedContainment, sumsAndProductsHoldThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Number a = randomNumber(forms);
    const Number b = partnerOf(a, forms);
    const auto sum = evaluate<Number>([&] { return a + b; });
    const auto difference = evaluate<Number>([&] { return a + -b; });
    const auto product = evaluate<Number>([&] { return a * b; });
    for (int i = 0; i < MEMBERS; ++i)
    {
      const Exact x = memberOf(a, forms);
      const Exact y = memberOf(b, forms);
      ASSERT_TRUE(holds(sum, x + y)) << a << " + " << b << " = " << sum;
      ASSERT_TRUE(holds(difference, x - y)) << a << " - " << b << " = " << difference;
      ASSERT_TRUE(holds(product, x * y)) << a << " * " << b << " = " << product;
      ASSERT_TRUE(holds(-a, -x)) << a;
    }
  });
}

TEST_P(EnclosedContainment, boundsHoldAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Number a = randomNumber(forms);
    const auto bounds = evaluate<rounding::Bounds>([&] { return rounding::Bounds{ a.lower(), a.upper() }; });
    for (int i = 0; i < MEMBERS; ++i)
      ASSERT_TRUE(memberOf(a, forms).mayLieIn(bounds.lower, bounds.upper)) << a;
  });
}

TEST_P(EnclosedContainment, determinantAtTheCenterHoldsThoseOfAllMembersThere)
{
  forEachCase([this](Forms& forms) {
    std::array<Vector, 3> rows = { forms.vector(), forms.vector(), forms.vector() };
    if (forms.random().once(2))
      rows[2].center = rows[1].center;  // cancels
    const auto got = evaluate<Number>([&] { return determinantAtCenter(rows[0], rows[1], rows[2]); });
    const std::string text = test::toText(rows[0]) + test::toText(rows[1]) + test::toText(rows[2]);
    for (auto& row : rows)
      row.linear = {};
    for (int i = 0; i < MEMBERS; ++i)
    {
      const Exact value = determinant(forms.member(rows[0]), forms.member(rows[1]), forms.member(rows[2]));
      ASSERT_TRUE(holds(got, value)) << text << got;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, EnclosedContainment, testing::ValuesIn(MODES), nameOfMode);

constexpr double LAST_BIT = std::numeric_limits<double>::epsilon();

TEST(EnclosedTightness, operationsAddRoundingErrorsOnly)
{
  const Number a(0.7, 0.25);
  const Number b(-0.4, 0.125);
  EXPECT_NEAR((a + b).radius, 0.25 + 0.125, 60.0 * LAST_BIT);
  EXPECT_NEAR((a * b).radius, 0.7 * 0.125 + 0.4 * 0.25 + 0.25 * 0.125, 60.0 * LAST_BIT);
  EXPECT_EQ((-a).radius, a.radius);
  EXPECT_NEAR(a.lower(), 0.45, 60.0 * LAST_BIT);
  EXPECT_NEAR(a.upper(), 0.95, 60.0 * LAST_BIT);
}

TEST(EnclosedTightness, determinantAtTheCenterLeavesTheGradientsOut)
{
  std::array<Vector, 3> rows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    rows[k].center = { 0.1, -0.2, 0.3 };
    rows[k].center[k] = 2.0;
    rows[k].linear = { { { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 } } };
  }
  EXPECT_LE(determinantAtCenter(rows[0], rows[1], rows[2]).radius, 1000.0 * LAST_BIT);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
