// SPDX-License-Identifier: BSD-3-Clause
// Boxes that turn, against cos and sin in many digits.
#include "pkm_workspace/interval/turning.h"

#include <gtest/gtest.h>

#include "support/forms.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// Centers, angles, and points of a body; and one center, angle and point of them.
struct Turning
{
  Random random;
  Box centers;
  Interval angles;
  double size;
  std::vector<GrowingVector> points;
  std::size_t k;
  std::array<double, 3> delta;
  double angle;

  explicit Turning(int seed) : random(static_cast<std::uint64_t>(seed))
  {
    const double scale = std::ldexp(1.0, random.integer(-12, 12));
    const auto vector = [&](double length) {
      return Eigen::Vector3d(random.uniform(-length, length), random.uniform(-length, length),
                             random.uniform(-length, length));
    };
    const Eigen::Vector3d middle = vector(scale);
    const Eigen::Vector3d half = vector(scale * std::ldexp(1.0, -random.integer(0, 40))).cwiseAbs();
    centers = { middle - half, middle + half };
    if (random.once(3))
      centers.lower.z() = centers.upper.z();
    const double first = random.uniform(-4.0, 7.0);
    angles = Interval(first, first + std::ldexp(random.uniform(0.5, 1.0), -random.integer(0, 40)));
    size = random.once(4) ? 1.0 : random.uniform(0.0, 2.0);
    for (int count = random.integer(1, 5); count > 0; --count)
      points.push_back({ random.once(2) ? vector(scale) : Eigen::Vector3d(0.0, 0.0, 0.0), vector(scale) });
    k = static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1));
    for (double& d : delta)
      d = random.once(3) ? random.uniform(-1.0, 1.0) : random.sign();
    const double share = random.once(2) ? random.uniform(0.0, 1.0) : random.integer(0, 1);
    angle = std::min(angles.upper(), angles.lower() + share * angles.width());
  }

  /// Where the point is.
  ExactVector place() const
  {
    const CenteredBox<double> box(centers);
    const Exact c = cos(Exact(angle)), s = sin(Exact(angle));
    ExactVector offset, place;
    for (int j = 0; j < 3; ++j)
      offset[static_cast<std::size_t>(j)] = Exact(points[k].fixed[j]) + Exact(size) * points[k].per_size[j];
    const ExactVector turned = { c * offset[0] - s * offset[1], s * offset[0] + c * offset[1], offset[2] };
    for (std::size_t j = 0; j < 3; ++j)
      place[j] = Exact(box.center[j]) + Exact(box.half_widths[j]) * delta[j] + turned[j];
    return place;
  }
  /// How a body at that center, turned by the angle, sees the point p from p.
  ExactVector offsetFrom(const Eigen::Vector3d& p, RoundingMode mode) const
  {
    const auto box = under<CenteredBox<double>>(mode, [this] { return CenteredBox<double>(centers); });
    const Exact c = cos(Exact(angle)), s = sin(Exact(angle));
    ExactVector offset;
    for (std::size_t j = 0; j < 3; ++j)
      offset[j] = Exact(box.center[j]) + Exact(box.half_widths[j]) * delta[j] - Exact(p[static_cast<int>(j)]);
    return { c * offset[0] + s * offset[1], c * offset[1] - s * offset[0], offset[2] };
  }
  /// sin(angle - middle) over the largest one, for the middle as it is rounded.
  Exact turn(RoundingMode mode) const
  {
    const double middle = under<double>(mode, [this] { return angles.mid(); });
    return sin(Exact(angle) - middle) / sin(Exact((angles - Interval(middle)).magnitude()));
  }
};

class TurningContainment : public testing::TestWithParam<RoundingMode>
{
};

TEST_P(TurningContainment, boxesAndFormsHoldThePlacesOfPoints)
{
  for (int seed = 0; seed < cases(4000) && !HasFailure(); ++seed)
  {
    const Turning turning(seed);
    const auto box = under<TurningBox>(
        GetParam(), [&] { return TurningBox(turning.centers, turning.angles, turning.size, turning.points); });
    const CenteredBox<double> moved = box.box().moved(turning.size, box.places()[turning.k]);
    const ExactVector place = turning.place();
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double reach = moved.half_widths[j];
      EXPECT_TRUE((place[j] - moved.center[j]).mayLieIn(-reach - moved.slack, reach + moved.slack)) << "seed " << seed;
      const auto form = under<TurningForm>(GetParam(), [&] { return box.formOf(turning.k, coordinate(moved, j)); });
      Exact rest = place[j] - form.form.center - turning.turn(GetParam()) * form.turn.value;
      for (std::size_t i = 0; i < 3; ++i)
        rest = rest - Exact(form.form.gradient[i]) * turning.delta[i];
      const double radius = form.form.radius + form.turn.radius;
      EXPECT_TRUE(rest.mayLieIn(-radius, radius)) << "seed " << seed << ": " << rest << " beyond " << radius;
      EXPECT_TRUE(place[j].mayLieIn(form.lower(), form.upper())) << "seed " << seed;
    }
  }
}

TEST_P(TurningContainment, boxesAndFormsHoldTheOffsetsFromPoints)
{
  for (int seed = 0; seed < cases(4000) && !HasFailure(); ++seed)
  {
    const Turning turning(seed);
    const Eigen::Vector3d point = seed % 2 == 0 ? turning.points[turning.k].per_size : turning.centers.center();
    const auto offset =
        under<TurningOffset>(GetParam(), [&] { return TurningOffset(turning.centers, turning.angles, point); });
    const CenteredBox<double> box(offset.box());
    const ExactVector exact = turning.offsetFrom(point, GetParam());
    for (std::size_t j = 0; j < 3; ++j)
    {
      const int axis = static_cast<int>(j);
      // half widths of centers are rounded up
      const double more = 4e-15 * (turning.centers.maxWidth() + turning.centers.upper.cwiseAbs().maxCoeff());
      EXPECT_TRUE(exact[j].mayLieIn(offset.box().lower[axis] - more, offset.box().upper[axis] + more)) << seed;
      const auto form = under<TurningForm>(GetParam(), [&] { return offset.formOf(coordinate(box, j)); });
      Exact rest = exact[j] - form.form.center - turning.turn(GetParam()) * form.turn.value;
      for (std::size_t i = 0; i < 3; ++i)
        rest = rest - Exact(form.form.gradient[i]) * turning.delta[i];
      const double radius = form.form.radius + form.turn.radius;
      EXPECT_TRUE(rest.mayLieIn(-radius, radius)) << "seed " << seed << ": " << rest << " beyond " << radius;
    }
  }
}

TEST_P(TurningContainment, sumsAndMultiplesHoldThoseOfMembers)
{
  for (int seed = 0; seed < cases(2000); ++seed)
  {
    Forms forms(static_cast<std::uint64_t>(seed));
    const auto draw = [&] { return TurningForm{ forms.form(), { forms.number(), forms.error() } }; };
    const TurningForm a = draw(), b = draw();
    const Enclosed<double> s(forms.number(), forms.error());
    const Exact tau = forms.within(1.0), factor = Exact(s.value) + forms.within(s.radius);
    const auto member = [&](const TurningForm& f) {
      return forms.member(f.form) + tau * f.turn.value + forms.within(f.turn.radius);
    };
    const Exact x = member(a), y = member(b);
    const auto sum = under<TurningForm>(GetParam(), [&] { return a + s * b; });
    const double radius = sum.form.radius + sum.turn.radius;
    const Exact linear = forms.linear(sum.form.center, sum.form.gradient) + tau * sum.turn.value;
    EXPECT_TRUE((x + factor * y - linear).mayLieIn(-radius, radius)) << "seed " << seed;
    EXPECT_TRUE((x + factor * y).mayLieIn(sum.lower(), sum.upper())) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryRoundingMode, TurningContainment, testing::ValuesIn(ROUNDING_MODES));

TEST(Turning, formsAreTightToSecondOrder)
{
  const Box center{ Eigen::Vector3d(0.1, -0.2, 0.3), Eigen::Vector3d(0.1, -0.2, 0.3) };
  const std::vector<GrowingVector> corner = { scaling(Eigen::Vector3d(0.5, 0.25, 0.5)) };
  for (const double half : { 1e-1, 1e-2, 1e-3, 1e-4 })
  {
    const TurningBox box(center, Interval(0.7 - half, 0.7 + half), 1.0, corner);
    const CenteredBox<double> moved = box.box().moved(1.0, box.places()[0]);
    for (std::size_t j = 0; j < 2; ++j)
    {
      const TurningForm form = box.formOf(0, coordinate(moved, j));
      EXPECT_LE(form.form.radius + form.turn.radius, 0.3 * half * half + 1e-14) << half;
      EXPECT_GE(std::abs(form.turn.value), 0.1 * half) << half;
    }
  }
}

TEST(Turning, rotationsHoldThoseOfEveryAngle)
{
  for (int seed = 0; seed < cases(2000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const double first = random.uniform(-7.0, 7.0);
    const Interval angles(first, first + std::ldexp(1.0, -random.integer(0, 60)));
    const IntervalMatrix rotation = rotationsAboutZ(angles);
    const Exact angle = Exact(std::min(angles.upper(), first + random.uniform(0.0, 1.0) * angles.width()));
    const Exact exact[2][2] = { { cos(angle), -sin(angle) }, { sin(angle), cos(angle) } };
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        EXPECT_TRUE(exact[i][j].mayLieIn(rotation[i][j])) << "seed " << seed;
    EXPECT_EQ(rotation[2], (IntervalVector{ 0.0, 0.0, 1.0 }));
    EXPECT_EQ(rotation[0][2], Interval(0.0));
    EXPECT_EQ(rotation[1][2], Interval(0.0));
    const Eigen::Vector3d turned = turnedAboutZ(Eigen::Vector3d(2.0, -1.0, 5.0), first);
    EXPECT_NEAR(turned.x(), 2.0 * std::cos(first) + std::sin(first), 1e-14);
    EXPECT_NEAR(turned.y(), 2.0 * std::sin(first) - std::cos(first), 1e-14);
    EXPECT_EQ(turned.z(), 5.0);
  }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
