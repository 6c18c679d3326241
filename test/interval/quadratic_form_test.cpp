// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/quadratic_form.h"

#include <gtest/gtest.h>

#include "support/form_laws.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Quadratic = QuadraticForm<double>;
using Bent = QuadraticVector<double>;

std::array<double, 6> coefficients(Forms& forms)
{
  std::array<double, 6> second;
  const int shrink = forms.random().integer(0, 20);
  for (double& coefficient : second)
    coefficient = forms.number(shrink);
  return second;
}

Quadratic quadratic(Forms& forms)
{
  Quadratic q = forms.form();
  q.second = coefficients(forms);
  return q;
}

Bent bent(Forms& forms)
{
  Bent v;
  v.linear = forms.vector();
  for (auto& second : v.second)
    second = coefficients(forms);
  return v;
}

Exact secondOrder(const std::array<double, 6>& s, const Forms& forms)
{
  const auto& d = forms.delta();
  Exact sum = Exact(0.0);
  for (std::size_t j = 0; j < 3; ++j)
    sum = sum + Exact(s[j]) * Exact(d[j]) * d[j] + Exact(s[3 + j]) * Exact(d[(j + 1) % 3]) * d[(j + 2) % 3];
  return sum;
}

Exact member(const Quadratic& q, Forms& forms)
{
  return forms.member(q.linear) + secondOrder(q.second, forms);
}

ExactVector member(const Bent& v, Forms& forms)
{
  ExactVector result = forms.member(v.linear);
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = result[k] + secondOrder(v.second[k], forms);
  return result;
}

bool holds(const Quadratic& q, const Exact& value, const Forms& forms)
{
  return forms.holds(q.linear, value - secondOrder(q.second, forms));
}

class QuadraticFormContainment : public FormLaws
{
};

TEST_P(QuadraticFormContainment, operationsHoldThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Quadratic a = quadratic(forms), b = quadratic(forms);
    const Form f = forms.form(), g = forms.form();
    const Enclosed<double> s(forms.number(), forms.error());
    const auto get = [this](const auto& operation) { return evaluate<Quadratic>(operation); };
    const Quadratic sum = get([&] { return a + b; }), difference = get([&] { return a - b; });
    const Quadratic plus = get([&] { return a + f; }), less = get([&] { return a - f; });
    const Quadratic times = get([&] { return a * f; }), square = get([&] { return squared(a); });
    const Quadratic multiple = get([&] { return s * a; }), plain = get([&] { return product(f, g); });
    const Form form = evaluate<Form>([&] { return flat(a); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const Exact x = member(a, forms), y = member(b, forms), z = forms.member(f);
      ASSERT_TRUE(holds(sum, x + y, forms));
      ASSERT_TRUE(holds(difference, x - y, forms));
      ASSERT_TRUE(holds(plus, x + z, forms));
      ASSERT_TRUE(holds(less, x - z, forms));
      ASSERT_TRUE(holds(times, x * z, forms));
      ASSERT_TRUE(holds(square, x * x, forms));
      ASSERT_TRUE(holds(multiple, (Exact(s.value) + forms.within(s.radius)) * x, forms));
      ASSERT_TRUE(holds(plain, z * forms.member(g), forms));
      ASSERT_TRUE(forms.holds(form, x));
    }
  });
}

TEST_P(QuadraticFormContainment, vectorsHoldThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Bent u = bent(forms), v = bent(forms);
    const Quadratic a = quadratic(forms);
    const std::array<double, 3> axis = { forms.number(), forms.number(), forms.number() };
    const double error = forms.error();
    IntervalVector enclosed;
    for (std::size_t k = 0; k < 3; ++k)
      enclosed[k] = hull(Interval(axis[k]), Interval(axis[k]) + Interval(error));
    const Quadratic dotted = evaluate<Quadratic>([&] { return product(u, v); });
    const Quadratic plain = evaluate<Quadratic>([&] { return product(u.linear, v.linear); });
    const Vector vector = evaluate<Vector>([&] { return flat(u); });
    const Bent sum = evaluate<Bent>([&] {
      Bent result = u;
      addAlong(result, a, EnclosedVector<double>(enclosed));
      affine::spreadError(result.linear);
      return result;
    });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const ExactVector x = member(u, forms), y = member(v, forms);
      ASSERT_TRUE(holds(dotted, dot(x, y), forms));
      ASSERT_TRUE(holds(plain, dot(forms.member(u.linear), forms.member(v.linear)), forms));
      const Exact factor = member(a, forms);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Form got = evaluate<Form>([&] { return component(vector, k); });
        ASSERT_TRUE(forms.holds(got, x[k])) << got;
        ASSERT_TRUE(holds({ { sum.linear.center[k], sum.linear.linear[k], sum.linear.radius } },
                          x[k] + factor * axis[k] - secondOrder(sum.second[k], forms), forms));
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, QuadraticFormContainment, testing::ValuesIn(MODES), nameOfMode);

TEST(QuadraticFormTightness, whatCancelsInTheSecondOrderCostsNothing)
{
  const Form f = { 1.0, { 0.5, 0.25, 0.0 }, 0.0 }, g = { 1.0, { -0.5, 0.25, 0.0 }, 0.0 };
  const Quadratic sum = product(f, g) + product(f, f) - product(f, g) - product(f, f);
  EXPECT_LE(flat(sum).radius, 1e-13);
  EXPECT_NEAR(flat(product(f, g)).radius, 0.5 * (0.25 + 0.0625), 1e-13) << "the pairs of deltas cancel";
  EXPECT_NEAR(flat(squared(Quadratic(f))).radius, flat(product(f, f)).radius, 1e-13);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
