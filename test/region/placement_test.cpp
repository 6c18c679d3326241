// SPDX-License-Identifier: BSD-3-Clause
// Placements, held against the definition: points of the workpiece, moved by what the margin allows, in 100 digits.
#include "region/placements.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// What is found is good, and nowhere it is with a margin above the bound.
void expectRight(const Machine& machine, const PlacementQuery& query, const Placement& placement, unsigned seed)
{
  SCOPED_TRACE(machine.name() + ", seed " + std::to_string(seed));
  RandomBoxes random(seed);
  const std::vector<Vector3d> points = pointsOf(*query.workpiece, random, 6);
  const LargestRegion& found = placement.found;
  ASSERT_GT(found.size, 0.0) << found.message;
  EXPECT_LE(found.size_upper_bound, found.size + query.accuracy) << found.message;
  EXPECT_TRUE(placement.translations.contains(found.center));
  EXPECT_EQ(badPoint(machine, query.criterion, points, found.center, found.size, random), std::nullopt);
  const double more = found.size_upper_bound + 2e-3 * machine.scale();
  const Box near{ found.center - Vector3d::Constant(0.01), found.center + Vector3d::Constant(0.01) };
  for (int k = 0; k < 60; ++k)
  {
    const Vector3d place = k == 0 ? found.center : random.pointIn(k % 2 == 0 ? near : placement.translations);
    EXPECT_NE(badPoint(machine, query.criterion, points, place, more, random), std::nullopt) << place.transpose();
  }
}

}  // namespace

// The path is 0.2 x 0.1 x 0, the box it has to keep in 0.3 x 0.5 x 0.4: what is left along x is the margin.
TEST(Placement, LeavesAsMuchOnBothSidesOfABox)
{
  const auto path = pathOf({ PathSegment::line({ 5.0, 2.0, 1.0 }, { 5.2, 2.1, 1.0 }) });
  PlacementQuery query = queryOf(path, within({ 0.02, -0.03, 0.01 }, { 0.3, 0.5, 0.4 }));
  query.wants_scale = true;
  const Placement placement = findPlacement(orthoglide(), query);
  EXPECT_LE(placement.found.size, 0.05);
  EXPECT_GE(placement.found.size, 0.05 - query.accuracy);
  EXPECT_GE(placement.found.size_upper_bound, 0.05);
  EXPECT_LE(placement.found.size_upper_bound, 0.05 + query.accuracy);
  EXPECT_NEAR(placement.found.center.x(), 0.02 - 5.1, query.accuracy);
  ASSERT_TRUE(placement.largest);
  EXPECT_EQ(placement.largest->least, 1.0);
  EXPECT_LE(placement.largest->scale, 1.5);
  EXPECT_GE(placement.largest->upper_bound, 1.5);
  EXPECT_LE(placement.largest->upper_bound - placement.largest->scale, 1.01 * query.scale_accuracy);
}

// A circle of radius 0.15 around a column of radius 0.05: the corner of the margin's cube that points to the column
// comes to 0.15 - sqrt(2) margin. The hull of the circle holds the column.
TEST(Placement, GoesAroundAColumn)
{
  const Vector3d center(0.01, 0.02, 0.0);
  const auto ring = pathOf({ PathSegment::circle({ 0.15, 0.0, 0.0 }, Vector3d::Zero(), Vector3d::UnitZ()) });
  Criterion criterion = within(center, { 0.5, 0.5, 0.4 });
  criterion.zones.push_back(column(center, 0.05));
  PlacementQuery query = queryOf(ring, criterion);
  query.accuracy = 3e-3;
  const double margin = (0.15 - 0.05) / std::sqrt(2.0);
  const Placement placement = findPlacement(orthoglide(), query);
  EXPECT_LE(placement.found.size, margin);
  EXPECT_GE(placement.found.size, margin - query.accuracy);
  EXPECT_GE(placement.found.size_upper_bound, margin);
  EXPECT_LE(placement.found.size_upper_bound, margin + query.accuracy);
}

TEST(Placement, IsProvedToBeNoneOfAPartThatIsLargerThanItsBox)
{
  const auto plate = partOf({ { 0.15, 0.0, 0.01 }, { -0.1, 0.15, 0.0 }, { -0.1, -0.15, 0.0 }, { 0.0, 0.0, -0.02 } });
  const Placement none = findPlacement(orthoglide(), queryOf(plate, within({ 0.0, 0.0, 0.0 }, { 0.24, 0.5, 0.4 })));
  EXPECT_EQ(none.found.status, LargestRegion::Status::NONE);
  EXPECT_EQ(none.found.size_upper_bound, 0.0);
}

TEST(Placement, HoldsOfRandomPathsByTheDefinition)
{
  for (const unsigned seed : { 1U, 2U, 3U, 4U })
  {
    const Machine machine = seed == 1 ? orthoglide() : crooked(seed);
    RandomBoxes random(seed);
    const double size = 0.25 * machine.scale();
    const Box box{ Vector3d::Constant(-0.5 * size), Vector3d(0.5 * size, size, 0.1 * size) };
    std::vector<PathSegment> segments = zigzag(random, box, 12);
    segments.push_back(
        PathSegment::arc({ 0.4 * size, 0.0, 0.0 }, Vector3d::Zero(), { 0.1, 0.2, 1.0 }, 4.0, 0.1 * size));
    PlacementQuery query = queryOf(pathOf(segments), Criterion());
    query.accuracy = 1e-3;
    expectRight(machine, query, findPlacement(machine, query), 100 + seed);
  }
}

TEST(Placement, HoldsOfPartsByTheDefinition)
{
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    const Machine machine = seed == 1 ? orthoglide() : crooked(seed);
    RandomBoxes random(seed);
    std::vector<Vector3d> vertices;
    for (int k = 0; k < 12; ++k)
      vertices.push_back(random.pointIn({ Vector3d::Constant(-0.2), Vector3d::Constant(0.2) }));
    PlacementQuery query = queryOf(partOf(vertices), Criterion());
    query.accuracy = 1e-3;
    expectRight(machine, query, findPlacement(machine, query), 200 + seed);
  }
}

TEST(Placement, IsProvedToBeNoneWhereTheDefinitionHasNone)
{
  const auto path = pathOf({ PathSegment::line({ 0.0, 0.0, 0.0 }, { 0.8, 0.8, 0.8 }) });
  PlacementQuery query = queryOf(path, Criterion());
  query.wants_scale = true;
  const Placement placement = findPlacement(orthoglide(), query);
  EXPECT_EQ(placement.found.status, LargestRegion::Status::NONE);
  EXPECT_EQ(placement.found.size_upper_bound, 0.0);
  ASSERT_TRUE(placement.largest);
  EXPECT_EQ(placement.largest->least, 0.0);
  RandomBoxes random(5);
  const Criterion criterion;
  const std::vector<Vector3d> points = pointsOf(*path, random, 40);
  for (int k = 0; k < 100; ++k)
    EXPECT_NE(badPoint(orthoglide(), criterion, points, random.pointIn(placement.translations), 0.0, random),
              std::nullopt);
}

TEST(Placement, DependsOnNoThreadAndTakesFewBoxes)
{
  RandomBoxes random(9);
  PlacementQuery query =
      queryOf(pathOf(zigzag(random, { Vector3d::Zero(), Vector3d::Constant(0.3) }, 500)), Criterion());
  query.budget.threads = 1;
  const Placement one = findPlacement(orthoglide(), query);
  query.workpiece = std::make_shared<Workpiece>(*query.workpiece);
  query.budget.threads = 3;
  const Placement three = findPlacement(orthoglide(), query);
  EXPECT_EQ(one.found.center, three.found.center);
  EXPECT_EQ(one.found.size, three.found.size);
  EXPECT_EQ(one.found.size_upper_bound, three.found.size_upper_bound);
  EXPECT_EQ(one.found.boxes, three.found.boxes);
  EXPECT_EQ(one.found.verification_boxes, three.found.verification_boxes);
  EXPECT_LE(one.found.boxes, 1000);
  EXPECT_LE(one.found.verification_boxes, 40000);
}

TEST(Placement, StaysABracketWhereABudgetEndsIt)
{
  RandomBoxes random(10);
  PlacementQuery query =
      queryOf(pathOf(zigzag(random, { Vector3d::Zero(), Vector3d::Constant(0.3) }, 30)), Criterion());
  const Placement whole = findPlacement(orthoglide(), query);
  for (const std::int64_t boxes : { 1, 30, 200 })
  {
    query.budget.max_boxes = boxes;
    const Placement part = findPlacement(orthoglide(), query);
    EXPECT_LE(part.found.size, whole.found.size_upper_bound);
    EXPECT_GE(part.found.size_upper_bound, whole.found.size);
  }
}

TEST(PathTree, BoxesHoldThePointsOfTheirParts)
{
  RandomBoxes random(11);
  std::vector<PathSegment> segments = zigzag(random, { Vector3d::Constant(-1.0), Vector3d::Constant(1.0) }, 150);
  for (int k = 0; k < 50; ++k)
    segments.push_back(PathSegment::arc(random.pointIn({ Vector3d::Constant(0.5), Vector3d::Constant(1.0) }),
                                        Vector3d::Zero(), { 0.3, -0.2, 1.0 }, random.between(-9.0, 9.0), 0.2));
  const auto path = pathOf(segments);
  const PathTree& tree = path->moves;
  std::size_t moves = 0;
  const std::function<void(const PathTree::Part&, const Box&, int)> look = [&](const PathTree::Part& part,
                                                                               const Box& around, int depth) {
    const Box box = tree.box(part);
    EXPECT_TRUE((part.level == 0 && depth > 0) || (around.contains(box.lower) && around.contains(box.upper)));
    if (part.level == 0)
    {
      moves += depth == 0 ? 1 : 0;
      const double t = random.between(part.first, part.last);
      EXPECT_TRUE(box.contains(segments[part.index].point(t)));
      if (depth == 3)
        return;
    }
    tree.divide(part, [&](const PathTree::Part& smaller) { look(smaller, box, part.level == 0 ? depth + 1 : 0); });
  };
  look(tree.all(), tree.box(tree.all()), 0);
  EXPECT_EQ(moves, segments.size());
}

TEST(PathTree, BoundsAreThoseOfThePoints)
{
  RandomBoxes random(12);
  for (int k = 0; k < 40; ++k)
  {
    const Vector3d start = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
    const Vector3d axis = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
    const double angle = k == 0 ? 7.0 : random.between(-9.0, 9.0);
    const PathSegment helix = k == 0
                                  ? PathSegment::arc({ 0.2, 0.0, 0.0 }, Vector3d::Zero(), { 0.0, 1.0, 0.0 }, angle, 0.1)
                                  : PathSegment::arc(start, Vector3d::Zero(), axis, angle, random.between(-0.2, 0.2));
    const Box bounds = pathOf({ helix })->bounds();
    Box seen{ helix.point(0.0), helix.point(0.0) };
    for (int step = 0; step <= 20000; ++step)
    {
      const Vector3d point = helix.point(step / 20000.0);
      seen = { seen.lower.cwiseMin(point), seen.upper.cwiseMax(point) };
    }
    EXPECT_TRUE(bounds.contains(seen.lower) && bounds.contains(seen.upper)) << k;
    EXPECT_LE((seen.lower - bounds.lower).maxCoeff(), 1e-6) << k;
    EXPECT_LE((bounds.upper - seen.upper).maxCoeff(), 1e-6) << k;
    if (k == 0)
    {
      EXPECT_NEAR(pathOf({ helix })->lowest(), -0.2, 1e-12);
    }
  }
}
}  // namespace test
}  // namespace pkm_workspace
