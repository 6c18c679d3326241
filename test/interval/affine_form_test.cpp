// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/affine_form.h"

#include <gtest/gtest.h>

#include "support/form_laws.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
class AffineFormContainment : public FormLaws
{
};

TEST_P(AffineFormContainment, sumsAndProductsHoldThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Form a = forms.form();
    const Form b = forms.form(&a);
    const Form sum = evaluate<Form>([&] { return a + b; });
    const Form difference = evaluate<Form>([&] { return a - b; });
    const Form product = evaluate<Form>([&] { return a * b; });
    const Form square = evaluate<Form>([&] { return a * a; });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const Exact x = forms.member(a);
      const Exact y = forms.member(b);
      ASSERT_TRUE(forms.holds(sum, x + y)) << a << " + " << b << " = " << sum;
      ASSERT_TRUE(forms.holds(difference, x - y)) << a << " - " << b << " = " << difference;
      ASSERT_TRUE(forms.holds(product, x * y)) << a << " * " << b << " = " << product;
      ASSERT_TRUE(forms.holds(square, x * x)) << a << " squared = " << square;
    }
  });
}

TEST_P(AffineFormContainment, constantsAreEnclosedWithTheirErrors)
{
  forEachCase([this](Forms& forms) {
    const Form a = forms.form();
    const double bound = forms.number();
    const Interval s = hull(Interval(bound), Interval(forms.random().once(2) ? bound + forms.error() : bound));
    const Form sum = evaluate<Form>([&] { return a + Enclosed<double>(s); });
    const Form product = evaluate<Form>([&] { return Enclosed<double>(s) * a; });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const Exact x = forms.member(a);
      const Exact t = forms.random().once(2) ? s.lower() : s.upper();
      ASSERT_TRUE(forms.holds(sum, x + t)) << a << " + " << s << " = " << sum;
      ASSERT_TRUE(forms.holds(product, t * x)) << a << " * " << s << " = " << product;
    }
  });
}

TEST_P(AffineFormContainment, maximumHoldsTheLargerOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Form a = forms.form();
    const Form b = forms.random().once(2) ? forms.form(&a) : -forms.form(&a);
    const Form largest = evaluate<Form>([&] { return maximum(a, b); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const Exact x = forms.member(a);
      const Exact y = forms.member(b);
      ASSERT_TRUE(forms.holds(largest, (x - y).value() < 0.0 ? y : x))
          << "maximum of " << a << " and " << b << " = " << largest;
    }
  });
}

TEST_P(AffineFormContainment, maximumIsTheFormThatIsLargerAllOver)
{
  const Form low{ -3.0, { 0.5, 0.25, 0.0 }, 0.125 }, high{ 1.0, { 0.0, 0.5, -0.5 }, 0.0 };
  for (const Form& largest :
       { evaluate<Form>([&] { return maximum(low, high); }), evaluate<Form>([&] { return maximum(high, low); }) })
  {
    EXPECT_NEAR(largest.center, high.center, 1e-14);
    EXPECT_NEAR(largest.gradient[2], high.gradient[2], 1e-14);
    EXPECT_LE(largest.radius, 1e-13);
  }
}

TEST_P(AffineFormContainment, boundsHoldTheValuesOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Form a = forms.form();
    const auto bounds = evaluate<rounding::Bounds>([&] { return rounding::Bounds{ a.lower(), a.upper() }; });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
      ASSERT_TRUE(forms.member(a).mayLieIn(bounds.lower, bounds.upper)) << a;
  });
}

TEST_P(AffineFormContainment, squareRootHoldsThoseOfAllMembersAboveTheFloor)
{
  forEachCase([this](Forms& forms) {
    Form a = forms.form();
    if (forms.random().once(2))
      a.center = a.swing() + a.radius;  // touches 0
    const double floor = forms.random().once(2) ? 0.0 : std::abs(forms.number(forms.random().integer(0, 20)));
    const Form root = evaluate<Form>([&] { return sqrtAbove(a, floor); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const Exact x = forms.member(a);
      if (!(x - floor).certainlyNegative())
      {
        ASSERT_TRUE(forms.holds(root, sqrt(x))) << "sqrt " << a << " above " << floor << " = " << root;
      }
    }
  });
}

TEST_P(AffineFormContainment, inverseHoldsThoseOfAllMembersOfPositiveForms)
{
  forEachCase([this](Forms& forms) {
    Form a = forms.form();
    a.center = (1.0 + std::ldexp(1.0, -forms.random().integer(0, 40))) * (a.swing() + a.radius) + 1e-200;
    if (!(a.lower() > 0.0) || !std::isfinite(1.0 / (a.lower() * a.upper() * a.lower())))
      return;
    const Form inverse = evaluate<Form>([&] { return inverseOf(a); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
      ASSERT_TRUE(forms.holds(inverse, Exact(1.0) / forms.member(a))) << "1 / " << a << " = " << inverse;
  });
}

INSTANTIATE_TEST_SUITE_P(All, AffineFormContainment, testing::ValuesIn(MODES), nameOfMode);

constexpr double ULP = std::numeric_limits<double>::epsilon();

TEST(AffineFormTightness, linearOperationsAddRoundingErrorsOnly)
{
  const Form a = { 0.7, { 0.1, -0.2, 0.3 }, 0.0 };
  const Form b = { -0.4, { 0.3, 0.1, -0.1 }, 0.0 };
  EXPECT_LE((a + b).radius, 4.0 * ULP * (a.magnitude() + b.magnitude()) * 1.01);
  EXPECT_LE((Enclosed<double>(Interval(3.0)) * a).radius, 12.0 * ULP * a.magnitude() * 1.01);
  EXPECT_LE(a.upper() - (0.7 + 0.6), 10.0 * ULP * a.magnitude());
}

TEST(AffineFormTightness, productsOverestimateBySecondOrder)
{
  const Form a = { 2.0, { 0.5, 0.25, 0.0 }, 0.0 };
  const Form b = { 3.0, { 0.5, 0.0, 0.125 }, 0.0 };
  const Form product = a * b;
  // 1/2 |0.5 0.5| for delta_0^2, and the mixed terms 0.25 0.5, 0.5 0.125, 0.25 0.125
  EXPECT_NEAR(product.radius, 0.125 + 0.125 + 0.0625 + 0.03125, 20.0 * ULP * a.magnitude() * b.magnitude());
  EXPECT_EQ(product.center, 6.0 + 0.125);
  EXPECT_EQ(product.gradient[0], 2.5);
}

TEST(AffineFormTightness, squareRootErrsByTheQuarterOfTheChordsGap)
{
  const double low = 0.9, high = 1.1;
  const Form f = { (low * low + high * high) / 2.0, { (high * high - low * low) / 2.0, 0.0, 0.0 }, 0.0 };
  EXPECT_NEAR(sqrtAbove(f, 0.0).radius, (high - low) * (high - low) / (8.0 * (low + high)), 100.0 * ULP);
  const Form point = { 4.0, { 0.0, 0.0, 0.0 }, 0.0 };
  EXPECT_LE(sqrtAbove(point, 0.0).radius, 100.0 * ULP);
  EXPECT_LT(std::abs(sqrtAbove(point, 0.0).center - 2.0), 10.0 * ULP);
}

TEST(AffineFormTightness, inverseErrsByHalfOfTheChordsGap)
{
  const Form f = { 1.0, { 0.01, 0.0, 0.0 }, 0.0 };
  const double gap = std::pow(std::sqrt(1.01) - std::sqrt(0.99), 2) / (1.01 * 0.99);
  EXPECT_NEAR(inverseOf(f).radius, 0.5 * gap, 0.02 * gap);
  EXPECT_LE(inverseOf(Form{ 4.0, {}, 0.0 }).radius, 100.0 * ULP);
}

TEST(AffineForm, overflowIsNeverAFiniteBound)
{
  const Form huge = { 1e200, { 1e200, 0.0, 0.0 }, 0.0 };
  const Form product = huge * huge;
  EXPECT_FALSE(product.upper() < std::numeric_limits<double>::infinity());
  EXPECT_FALSE(product.lower() > -std::numeric_limits<double>::infinity());
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
