// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/determinant.h"

#include <gtest/gtest.h>

#include "support/form_laws.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A number known up to some ulps, or exactly.
Interval constant(Forms& forms)
{
  const double x = forms.number();
  return forms.random().once(2) ? Interval(x) : hull(Interval(x), Interval(x + forms.error() * 0x1p-20));
}

IntervalVector constants(Forms& forms)
{
  return { constant(forms), constant(forms), constant(forms) };
}

ExactVector endsOf(const IntervalVector& v, Forms& forms)
{
  const auto end = [&](const Interval& x) { return Exact(forms.random().once(2) ? x.lower() : x.upper()); };
  return { end(v[0]), end(v[1]), end(v[2]) };
}

Box randomBox(Forms& forms)
{
  const auto side = [&] {
    return hull(Interval(forms.number()), Interval(forms.number(forms.random().integer(0, 60))));
  };
  return boundingBox({ side(), side(), side() });
}

class AffineVectorContainment : public FormLaws
{
};

TEST_P(AffineVectorContainment, dotHoldsThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const Vector u = forms.vector();
    const Vector v = forms.vector();
    const Form product = evaluate<Form>([&] { return dot(u, v); });
    const Form square = evaluate<Form>([&] { return dot(u, u); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const ExactVector x = forms.member(u);
      ASSERT_TRUE(forms.holds(product, dot(x, forms.member(v)))) << toText(u) << toText(v) << product;
      ASSERT_TRUE(forms.holds(square, dot(x, x))) << toText(u) << square;
    }
  });
}

TEST_P(AffineVectorContainment, squaredNormHoldsThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    Vector v = forms.vector();
    v.along = 0.0;
    const Form square = evaluate<Form>([&] { return squaredNorm(v); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const ExactVector x = forms.member(v);
      ASSERT_TRUE(forms.holds(square, dot(x, x))) << toText(v) << square;
    }
  });
}

TEST_P(AffineVectorContainment, dotWithAConstantHoldsThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const IntervalVector u = constants(forms);
    const Vector v = forms.vector();
    const Form product = evaluate<Form>([&] { return dot(EnclosedVector<double>(u), v); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
      ASSERT_TRUE(forms.holds(product, dot(endsOf(u, forms), forms.member(v)))) << toText(v) << product;
  });
}

TEST_P(AffineVectorContainment, dotHoldsTheRoundingOfPerpendicularErrors)
{
  forEachCase([this](Forms& forms) {
    Vector u = {};
    u.axis = { forms.random().uniform(-1.0, 1.0), forms.random().uniform(-1.0, 1.0),
               forms.random().uniform(-1.0, 1.0) };
    u.along = forms.error();
    const Vector v = forms.errorAcross(u);
    const Form product = evaluate<Form>([&] { return dot(u, v); });
    ASSERT_TRUE(forms.holds(product, dot(forms.member(u), forms.member(v)))) << toText(u) << toText(v) << product;
  });
}

TEST_P(AffineVectorContainment, determinantAndComponentsHoldThoseOfAllMembers)
{
  forEachCase([this](Forms& forms) {
    const std::array<Vector, 3> rows = { forms.vector(), forms.vector(), forms.vector() };
    const Form got = evaluate<Form>([&] { return determinant(rows[0], rows[1], rows[2]); });
    const Form first = evaluate<Form>([&] { return component(rows[0], 1); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const std::array<ExactVector, 3> x = { forms.member(rows[0]), forms.member(rows[1]), forms.member(rows[2]) };
      ASSERT_TRUE(forms.holds(got, determinant(x[0], x[1], x[2]))) << got;
      ASSERT_TRUE(forms.holds(first, x[0][1])) << toText(rows[0]) << first;
    }
  });
}

TEST_P(AffineVectorContainment, mapOfABoxHoldsThatOfEveryPoint)
{
  forEachCase([this](Forms& forms) {
    const IntervalMatrix m = { constants(forms), constants(forms), constants(forms) };
    const IntervalVector c = constants(forms);
    const Box box = randomBox(forms);
    auto centered = evaluate<CenteredBox<double>>([&] { return CenteredBox<double>(box); });
    centered.slack = forms.random().once(2) ? forms.error() : 0.0;
    const Vector image = evaluate<Vector>([&] {
      Vector result;
      mapOffset(EnclosedMatrix<double>(m), EnclosedVector<double>(c), centered, result);
      return result;
    });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      ExactVector offset = endsOf(c, forms);
      for (std::size_t k = 0; k < 3; ++k)
        offset[k] = Exact(centered.center[k]) + Exact(centered.half_widths[k]) * forms.delta()[k] +
                    forms.within(centered.slack) - offset[k];
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(forms.holds({ image.center[k], image.linear[k], image.radius }, dot(endsOf(m[k], forms), offset)))
            << toText(image);
    }
  });
}

TEST_P(AffineVectorContainment, addingAFormAlongAVectorKeepsItsErrorThere)
{
  forEachCase([this](Forms& forms) {
    Vector v = forms.vector();
    v.along = 0.0;
    const Form f = forms.form();
    const IntervalVector a = constants(forms);
    const Vector sum = evaluate<Vector>([&] {
      Vector result = v;
      addAlong(result, f, EnclosedVector<double>(a));
      return result;
    });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const ExactVector x = forms.member(v);
      const ExactVector axis = endsOf(a, forms);
      const Exact error = forms.within(f.radius);
      const Exact factor = forms.linear(f.center, f.gradient) + error;
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(
            forms.holds({ sum.center[k], sum.linear[k], sum.radius }, x[k] + factor * axis[k] - error * sum.axis[k]))
            << toText(v) << f << "\n"
            << toText(sum);
      ASSERT_EQ(sum.along, f.radius);
    }
  });
}

TEST_P(AffineVectorContainment, centeredBoxReachesEveryFace)
{
  forEachCase([this](Forms& forms) {
    const Box box = randomBox(forms);
    const auto centered = evaluate<CenteredBox<double>>([&] { return CenteredBox<double>(box); });
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto k = static_cast<std::size_t>(axis);
      const Exact half = Exact(centered.half_widths[k]);
      ASSERT_FALSE((Exact(box.upper[axis]) - centered.center[k] - half).certainlyPositive());
      ASSERT_FALSE((Exact(centered.center[k]) - box.lower[axis] - half).certainlyPositive());
    }
  });
}

TEST_P(AffineVectorContainment, coordinateHoldsThatOfEveryPoint)
{
  forEachCase([this](Forms& forms) {
    CenteredBox<double> box(randomBox(forms));
    box.slack = forms.error();
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Form got = evaluate<Form>([&] { return coordinate(box, k); });
      const Exact point = Exact(box.center[k]) + Exact(box.half_widths[k]) * forms.delta()[k] + forms.within(box.slack);
      ASSERT_TRUE(forms.holds(got, point)) << got;
    }
  });
}

TEST_P(AffineVectorContainment, movedBoxHoldsEveryMovedPoint)
{
  forEachCase([this](Forms& forms) {
    const Box box = randomBox(forms);
    const double size = std::abs(forms.number());
    const Eigen::Vector3d per_size(forms.random().uniform(-1.0, 1.0), forms.random().sign(), 0.0);
    GrowingVector offset = scaling(per_size);
    if (forms.random().once(2))
      offset.fixed = { std::abs(forms.number()) * forms.random().uniform(-1.0, 1.0), 0.0, forms.number() };
    const auto start = evaluate<CenteredBox<double>>([&] { return CenteredBox<double>(box); });
    CenteredBox<double> moved = start;
    for (int steps = 1; steps <= 16; ++steps)
    {
      moved = evaluate<CenteredBox<double>>([&] { return moved.moved(size, offset); });
      for (std::size_t k = 0; k < 3; ++k)
      {
        const int axis = static_cast<int>(k);
        const Exact way = Exact(steps) * (Exact(offset.fixed[axis]) + Exact(size) * offset.per_size[axis]);
        ASSERT_TRUE((Exact(start.center[k]) + way - moved.center[k]).mayLieIn(-moved.slack, moved.slack)) << steps;
      }
    }
    ASSERT_EQ(moved.half_widths, start.half_widths);
  });
}

TEST_P(AffineVectorContainment, movedBoxHoldsWhatIsLeftOfTwoMovesThatCancel)
{
  forEachCase([this](Forms& forms) {
    const double size = forms.random().uniform(0.1, 1.0);
    const double per_size = forms.random().uniform(0.1, 1.0);
    const auto moved = evaluate<CenteredBox<double>>([&] {
      const GrowingVector offset{ { -size * per_size, 0.0, 0.0 }, { per_size, 0.0, 0.0 } };
      return CenteredBox<double>(Box()).moved(size, offset);
    });
    const double fixed = evaluate<double>([&] { return -size * per_size; });
    ASSERT_TRUE((Exact(fixed) + Exact(size) * per_size - moved.center[0]).mayLieIn(-moved.slack, moved.slack));
  });
}

INSTANTIATE_TEST_SUITE_P(All, AffineVectorContainment, testing::ValuesIn(MODES), nameOfMode);

constexpr double ULP_OF_ONE = std::numeric_limits<double>::epsilon();

TEST(AffineVectorTightness, squaresOverestimateBySecondOrder)
{
  Vector v;
  v.center = { 1.0, 2.0, 0.0 };
  v.linear = { { { 0.5, 0.0, 0.0 }, { 0.0, 0.25, 0.0 }, { 0.0, 0.0, 0.125 } } };
  for (const Form& square : { dot(v, v), squaredNorm(v) })
  {
    EXPECT_NEAR(square.radius, (0.25 + 0.0625 + 0.015625) / 2.0, 40.0 * ULP_OF_ONE * v.magnitude() * v.magnitude());
    EXPECT_EQ(square.center, 5.0 + (0.25 + 0.0625 + 0.015625) / 2.0);
    EXPECT_EQ(square.gradient, (std::array<double, 3>{ 1.0, 1.0, 0.0 }));
  }
}

TEST(AffineVectorTightness, anErrorAlongAnAxisDoesNotReachWhatIsPerpendicular)
{
  Vector v;
  v.center = { 1.0, 0.0, 0.0 };
  v.linear = {};
  Vector u = v;
  u.center = { 0.0, 2.0, 0.0 };
  u.along = 0.5;
  u.axis = { 0.0, 0.0, 1.0 };
  EXPECT_LE(dot(u, v).radius, 80.0 * ULP_OF_ONE * u.magnitude() * v.magnitude()) << "the error of u is across v";
  EXPECT_NEAR(dot(u, u).radius, 0.25, 80.0 * ULP_OF_ONE * u.magnitude() * u.magnitude());
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
