// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/curve.h"

#include <gtest/gtest.h>

#include "support/forms.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A helix about an axis of the frame, or any ellipse, or a line.
struct ExactCurve
{
  std::array<double, 3> origin{}, drift{}, u{}, w{};
  double angle = 0.0;

  explicit ExactCurve(Random& random)
  {
    const std::size_t axis = static_cast<std::size_t>(random.integer(0, 2));
    const bool is_regular = random.once(2);
    angle = random.once(4) ? 0.0 : random.uniform(-1.0, 1.0) * std::ldexp(1.0, random.integer(-20, 6));
    for (std::size_t k = 0; k < 3; ++k)
    {
      origin[k] = random.uniform(-2.0, 2.0);
      drift[k] = is_regular && angle != 0.0 ? 0.0 : random.uniform(-1.0, 1.0);
      u[k] = is_regular || angle == 0.0 ? 0.0 : random.uniform(-1.0, 1.0);
      w[k] = is_regular || angle == 0.0 ? 0.0 : random.uniform(-1.0, 1.0);
    }
    if (!is_regular || angle == 0.0)
      return;
    drift[axis] = random.once(2) ? 0.0 : random.uniform(-1.0, 1.0);
    u[(axis + 1) % 3] = w[(axis + 2) % 3] = random.uniform(0.1, 2.0);
  }

  bool isRegular() const { return angle == 0.0 || u[0] * w[0] + u[1] * w[1] + u[2] * w[2] + drift[0] * u[0] == 0.0; }
  Curve curve() const { return Curve(enclosed(origin), enclosed(drift), enclosed(u), enclosed(w), angle); }
  ExactVector point(const Exact& t) const
  {
    const Exact c = cos(t * angle), s = sin(t * angle);
    ExactVector p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = Exact(origin[k]) + t * drift[k] + c * u[k] + s * w[k];
    return p;
  }
  /// For regular curves: of length 1.
  ExactVector tangent(const Exact& t) const
  {
    const Exact c = cos(t * angle), s = sin(t * angle);
    ExactVector v;
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = Exact(drift[k]) + Exact(angle) * (c * w[k] - s * u[k]);
    return (Exact(1.0) / sqrt(dot(v, v))) * v;
  }
  /// For regular curves: the second derivative by the length of the way.
  ExactVector curvature(const Exact& t) const
  {
    const Exact c = cos(t * angle), s = sin(t * angle);
    ExactVector v, a;
    for (std::size_t k = 0; k < 3; ++k)
    {
      v[k] = Exact(drift[k]) + Exact(angle) * (c * w[k] - s * u[k]);
      a[k] = Exact(-angle) * Exact(angle) * (c * u[k] + s * w[k]);
    }
    return (Exact(1.0) / dot(v, v)) * a;
  }

private:
  static IntervalVector enclosed(const std::array<double, 3>& v) { return { v[0], v[1], v[2] }; }
};

/// Whether the box holds v with that delta_0 and whatever the other two are.
bool holds(const SkewBox<double>& box, const Exact& delta, const ExactVector& v)
{
  bool result = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double rest = std::abs(box.edges[k][1]) + std::abs(box.edges[k][2]) + box.slack;
    result = result && (v[k] - (Exact(box.center[k]) + delta * box.edges[k][0])).mayLieIn(-rest, rest);
  }
  return result;
}

class CurveContainment : public testing::TestWithParam<RoundingMode>
{
};

TEST_P(CurveContainment, sineAndCosineHoldThoseOfEveryAngle)
{
  for (int seed = 0; seed < cases(2000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const double lower = random.uniform(-1.0, 1.0) * std::ldexp(1.0, random.integer(-40, 8));
    const double width = random.once(2) ? 0.0 : std::ldexp(random.uniform(0.0, 1.0), random.integer(-50, -2));
    const Interval angle(lower, std::max(lower, lower + width));
    const auto found = under<SineCosine>(GetParam(), [&] { return SineCosine(angle); });
    for (const double x : { angle.lower(), angle.mid(), angle.upper() })
    {
      EXPECT_TRUE((sin(Exact(x)) - found.sine.value).mayLieIn(-found.sine.radius, found.sine.radius)) << seed;
      EXPECT_TRUE((cos(Exact(x)) - found.cosine.value).mayLieIn(-found.cosine.radius, found.cosine.radius)) << seed;
    }
    const double rounding = 2e-15 + 4e-16 * std::abs(lower);
    EXPECT_LE(found.sine.radius, 0.501 * angle.width() + rounding) << "seed " << seed;
  }
}

TEST_P(CurveContainment, piecesHoldTheirPointsTangentsAndCurvatures)
{
  for (int seed = 0; seed < cases(2000) && !HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const ExactCurve exact(random);
    const double width = std::ldexp(1.0, -random.integer(0, 30));
    const double first = width * std::floor(random.uniform(0.0, 1.0 / width));
    const CurvePiece piece = under<CurvePiece>(GetParam(), [&] { return exact.curve().piece(first, first + width); });
    const SkewBox<double> curvatures =
        under<SkewBox<double>>(GetParam(), [&] { return exact.curve().curvatures(first, first + width); });
    for (const double delta : { -1.0, 0.0, 1.0, random.uniform(-1.0, 1.0) })
    {
      const Exact t = Exact(first + 0.5 * width) + Exact(0.5 * width) * delta;
      ASSERT_TRUE(holds(piece.points, delta, exact.point(t))) << "seed " << seed << ", delta " << delta;
      ASSERT_TRUE(!exact.isRegular() || holds(piece.tangents, delta, exact.tangent(t)))
          << "seed " << seed << ", delta " << delta;
      ASSERT_TRUE(!exact.isRegular() || holds(curvatures, delta, exact.curvature(t)))
          << "seed " << seed << ", delta " << delta;
    }
  }
}

TEST_P(CurveContainment, pointsAreEnclosedTightly)
{
  for (int seed = 0; seed < cases(500) && !HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const ExactCurve exact(random);
    const double t = random.uniform(0.0, 1.0);
    const IntervalVector point = under<IntervalVector>(GetParam(), [&] { return exact.curve().point(t); });
    const ExactVector expected = exact.point(t);
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_TRUE(expected[k].mayLieIn(point[k])) << "seed " << seed;
      ASSERT_LE(point[k].width(), 1e-13) << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, CurveContainment, testing::ValuesIn(MODES),
                         [](const auto& info) { return std::string(info.param.name); });

// The box is thicker than the line by the second order of the angle only.
TEST(Curve, piecesAreThin)
{
  const Curve circle({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, 1.0);
  for (const double width : { 0.1, 0.01, 0.001 })
  {
    const SkewBox<double> box = circle.piece(0.0, width).points;
    EXPECT_LE(std::hypot(box.edges[0][1], box.edges[1][1]), width * width / 15.0);
    EXPECT_LE(std::hypot(box.edges[0][2], box.edges[1][2]), width * width * width / 100.0);
    EXPECT_NEAR(std::hypot(box.edges[0][0], box.edges[1][0]), 0.5 * width, width * width);
  }
  EXPECT_NEAR(circle.length().mid(), 1.0, 1e-15);
}

TEST(Curve, aCircleBendsInwards)
{
  const Curve circle({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.0, 0.5, 0.0 }, 1.0);
  const SkewBox<double> box = circle.curvatures(0.0, 0.0);
  EXPECT_NEAR(box.center[0], -2.0, 1e-14);
  EXPECT_LE(box.slack, 1e-13);
}

TEST(Curve, aPointHasNoTangent)
{
  const Curve rest = Curve::line({ 0.1, 0.2, 0.3 }, { 0.1, 0.2, 0.3 });
  const CurvePiece piece = rest.piece(0.0, 1.0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_EQ(piece.tangents.center[k], 0.0);
    EXPECT_EQ(piece.points.edges[k][0], 0.0);
  }
  EXPECT_EQ(piece.points.center[1], 0.2);
}

TEST(Curve, aLengthThatUnderflowsLeavesEveryDirection)
{
  const CurvePiece piece = Curve::line({ 0.0, 0.0, 0.0 }, { 1e-170, 0.0, 0.0 }).piece(0.0, 1.0);
  EXPECT_GE(piece.tangents.slack + std::abs(piece.tangents.center[0]), 1.0);
}

TEST(Curve, anglesBeyondAllTurnsHaveEverySine)
{
  for (const double angle : { 1e18, -1e30, 1e300 })
  {
    const SineCosine of(Interval{ angle });
    EXPECT_LE(of.sine.value - of.sine.radius, std::sin(angle));
    EXPECT_GE(of.sine.value + of.sine.radius, std::sin(angle));
    EXPECT_LE(of.cosine.radius, 1.0);
  }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
