// SPDX-License-Identifier: BSD-3-Clause
// Paths whose pieces lie next to each other, so that proofs let some of them stand for others: none may be lost.
#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/path_body.h"
#include "support/cases.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

constexpr double MARGIN = 0.1;
/// By which points that stand for others are proved to be good farther away [m].
constexpr double RIM = MARGIN * 0x1p-20;

struct Segment
{
  Vector3d first, last;
};

/// The largest distance along an axis from the zone to a point; its least over the segment, which is convex.
double marginBeside(const Segment& segment, const Box& zone)
{
  const auto at = [&](double t) {
    const Vector3d q = segment.first + t * (segment.last - segment.first);
    return std::max((zone.lower - q).maxCoeff(), (q - zone.upper).maxCoeff());
  };
  double low = 0.0, high = 1.0;
  while (high - low > 1e-16)
  {
    const double left = low + 0.4 * (high - low), right = low + 0.6 * (high - low);
    (at(left) <= at(right) ? high : low) = at(left) <= at(right) ? right : left;
  }
  return std::min({ at(0.0), at(low), at(1.0) });
}
}  // namespace

TEST(PlacementCover, piecesThatStandForOthersLoseNone)
{
  Random random(SEED);
  for (int k = 0; k < cases(600) && !testing::Test::HasFailure(); ++k)
  {
    const auto rim = [&](double low, double high) { return RIM * random.uniform(low, high); };
    const double length = random.uniform(0.1, 0.6);
    const double aside = random.once(2) ? -0.95 * RIM : -rim(0.5, 1.9);
    const Vector3d start(random.once(2) ? aside * random.uniform(0.0, 1.0) : 0.0, 0.0, 0.0);
    const Vector3d nearest(rim(0.7, 0.97), -rim(0.0, 0.3), rim(-0.2, 0.2));
    const Vector3d middle(aside, random.uniform(0.0, length), 0.0), end(aside, length, 0.0);
    std::vector<Segment> segments = { { start, end }, { nearest, nearest + RIM * Vector3d(0.0, -0.2, 0.2) } };
    if (random.once(3))
      segments = { { start, start + 1e-9 * (middle - start) }, { middle, end }, segments.back() };
    const double side = std::pow(10.0, random.uniform(-4.0, -1.5));
    const Vector3d center(MARGIN + 0.5 * side, MARGIN * random.uniform(0.0, 0.99), MARGIN * random.uniform(-0.9, 0.9));
    const Box zone{ center - Vector3d::Constant(0.5 * side), center + Vector3d::Constant(0.5 * side) };
    const auto workpiece = std::make_shared<Workpiece>();
    double exact = INF;
    for (const Segment& segment : segments)
    {
      exact = std::min(exact, marginBeside(segment, zone));
      workpiece->moves.add(Curve::line(segment.first, segment.last), Interval(0.0));
    }
    workpiece->moves.close();
    Criterion criterion;
    criterion.set = Criterion::Set::REACHABLE;
    criterion.zones.emplace_back();
    criterion.zones.back().pose.translation = center;
    criterion.zones.back().sides = Vector3d::Constant(side);
    Budget budget;
    budget.max_boxes = 20000;
    const PathBody body(workpiece, PathBody::Grows::MARGIN);
    const auto proofOf = [&](double margin) {
      return body.prove(BoxTest(orthoglide(), criterion), Vector3d::Zero(), margin, budget).verdict;
    };
    EXPECT_NE(proofOf(exact + rim(0.02, 0.9)), Containment::INSIDE) << "case " << k << ", seed " << SEED;
    EXPECT_EQ(proofOf(exact - 4.0 * RIM), Containment::INSIDE) << "case " << k << ", seed " << SEED;
  }
}
}  // namespace test
}  // namespace pkm_workspace
