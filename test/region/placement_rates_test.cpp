// SPDX-License-Identifier: BSD-3-Clause
// Scales and joint speeds of placements, held against the definition.
#include "region/placements.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// The path at a scale about its reference.
std::vector<Vector3d> scaled(std::vector<Vector3d> points, const Vector3d& reference, double scale)
{
  for (Vector3d& point : points)
    point = reference + scale * (point - reference);
  return points;
}

/// Whether a joint is too fast on a segment that is moved there, by differences of joint values.
bool isTooFast(const Machine& machine, const ExactSegment& segment, double t, double speed, double limit)
{
  const ExactRates rates(machine, segment, t);
  return *std::max_element(rates.speed.begin(), rates.speed.end()) * speed > limit;
}

}  // namespace

TEST(Placement, LargestScaleHoldsByTheDefinition)
{
  for (const unsigned seed : { 6U, 7U })
  {
    RandomBoxes random(seed);
    const Machine machine = crooked(seed);
    const auto path = pathOf(zigzag(random, { Vector3d::Constant(-0.1), Vector3d::Constant(0.1) }, 20));
    PlacementQuery query = queryOf(path, Criterion());
    query.wants_scale = true;
    const Placement placement = findPlacement(machine, query);
    ASSERT_TRUE(placement.largest);
    const LargestScale& largest = *placement.largest;
    EXPECT_LE(largest.upper_bound - largest.scale, 1.01 * query.scale_accuracy);
    const std::vector<Vector3d> points = pointsOf(*path, random, 6);
    for (const double share : { 0.0, 0.5, 0.9, 1.0 })
    {
      const auto at = scaled(points, path->reference, 1.0 + share * (largest.scale - 1.0));
      EXPECT_EQ(badPoint(machine, query.criterion, at, largest.translation, 0.0, random), std::nullopt) << share;
    }
    const auto beyond = scaled(points, path->reference, largest.upper_bound + 5e-3);
    const Box near{ largest.translation - Vector3d::Constant(0.01), largest.translation + Vector3d::Constant(0.01) };
    for (int k = 0; k < 60; ++k)
    {
      const Vector3d place = k == 0 ? largest.translation : random.pointIn(k % 2 == 0 ? near : placement.translations);
      EXPECT_NE(badPoint(machine, query.criterion, beyond, place, 0.0, random), std::nullopt);
    }
  }
}

TEST(Placement, KeepsJointSpeedsByTheDefinition)
{
  const Machine machine = orthoglide();
  const std::vector<std::pair<Vector3d, Vector3d>> lines = { { { 0.0, 0.0, 0.0 }, { 0.3, 0.0, 0.0 } },
                                                             { { 0.3, 0.0, 0.0 }, { 0.3, 0.2, 0.1 } } };
  std::vector<PathSegment> segments;
  segments.reserve(lines.size());
  for (const auto& [from, to] : lines)
    segments.push_back(PathSegment::line(from, to));
  PlacementQuery query = queryOf(pathOf(segments, 1.1), Criterion());
  query.accuracy = 1e-3;
  query.limits.speed = { 1.2, 1.2, 1.2 };
  const Placement placement = findPlacement(machine, query);
  query.limits = {};
  const double without = findPlacement(machine, query).found.size_upper_bound;
  const LargestRegion& found = placement.found;
  ASSERT_LT(found.size_upper_bound, without - 1e-3) << "speeds do not bind";
  EXPECT_LE(found.size_upper_bound, found.size + query.accuracy);

  RandomBoxes random(8);
  const std::vector<Vector3d> points = pointsOf(*query.workpiece, random, 6);
  const auto isBad = [&](const Vector3d& place, double margin) {
    if (badPoint(machine, query.criterion, points, place, margin, random))
      return true;
    for (const auto& [from, to] : lines)
      for (int k = 0; k < 24; ++k)
      {
        const Vector3d corner((k & 1) != 0 ? margin : -margin, (k & 2) != 0 ? margin : -margin,
                              (k & 4) != 0 ? margin : -margin);
        const Vector3d move = place + (k < 16 ? corner : random.between(0.0, 1.0) * corner);
        const double t = k < 8 ? 1e-6 : k < 16 ? 1.0 - 1e-6 : random.between(0.01, 0.99);
        if (isTooFast(machine, exactLine(from + move, to + move), t, 1.1, 1.2))
          return true;
      }
    return false;
  };
  EXPECT_FALSE(isBad(found.center, found.size));
  for (int k = 0; k < 25; ++k)
    EXPECT_TRUE(isBad(k == 0 ? found.center : random.pointIn(placement.translations), found.size_upper_bound + 2e-3));
}
}  // namespace test
}  // namespace pkm_workspace
