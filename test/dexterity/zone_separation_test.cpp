// SPDX-License-Identifier: BSD-3-Clause
// Planes between boxes and zones to keep out of, held against the definition (test/support/zones.h).
#include "pkm_workspace/dexterity/zone_separation.h"

#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/zones.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

double clearanceAt(const ZoneOracle& oracle, const Vector3d& p)
{
  return static_cast<double>(oracle.clearance({ p.x(), p.y(), p.z() }));
}

/// The least clearance that random steps, ever shorter, find within the box; from the definition.
double leastClearance(const ZoneOracle& oracle, const Box& box, RandomBoxes& boxes)
{
  Vector3d best = box.center();
  double least = clearanceAt(oracle, best);
  for (double step = 1.0; step > 1e-6; step *= 0.8)
    for (int sample = 0; sample < 12; ++sample)
    {
      const Vector3d offset = step * (boxes.pointIn(box) - box.center());
      const Vector3d point = (best + offset).cwiseMax(box.lower).cwiseMin(box.upper);
      const double clearance = clearanceAt(oracle, point);
      if (clearance < least)
      {
        least = clearance;
        best = point;
      }
    }
  return least;
}
}  // namespace

// A box is moved towards a zone until one look does not prove any more that it is clear: it has to be clear, and where
// a plane can be found it all but touches.
TEST(ZoneSeparation, boxesAreClearUntilTheyTouch)
{
  const Machine machine = orthoglide();
  Random random(SEED);
  RandomBoxes boxes(SEED);
  int touching = 0, tried = 0;
  for (int k = 0; k < cases(150) && !testing::Test::HasFailure(); ++k)
  {
    Criterion criterion;
    criterion.set = Criterion::Set::REACHABLE;
    criterion.zones = { randomZone(random, { Vector3d::Constant(-0.15), Vector3d::Constant(0.15) },
                                   Zone::Use::KEEP_OUT) };
    criterion.tool_radius = random.once(2) ? 0.02 : 0.0;
    const BoxTest test(machine, criterion);
    const ZoneOracle oracle(criterion.zones.front(), criterion.tool_radius);
    const Vector3d half(random.uniform(0.001, 0.03), random.uniform(0.001, 0.03), random.uniform(0.001, 0.03));
    const auto boxAt = [&half](const Vector3d& center) { return Box{ center - half, center + half }; };
    Vector3d clear = boxes.pointIn({ Vector3d::Constant(-0.3), Vector3d::Constant(0.3) });
    Vector3d meets = *pointWithin(zonesToKeepOut(criterion.zones, criterion.tool_radius).front(), clear);
    if (test.classify(boxAt(clear)) != BoxVerdict::INSIDE)
      continue;
    while ((meets - clear).norm() > 1e-9)
    {
      const Vector3d middle = 0.5 * (clear + meets);
      (test.classify(boxAt(middle)) == BoxVerdict::INSIDE ? clear : meets) = middle;
    }
    const double least = leastClearance(oracle, boxAt(clear), boxes);
    EXPECT_GE(least, 0.0) << "case " << k << ": " << describe(criterion);
    ++tried;
    touching += least < 1e-6;
  }
  EXPECT_GT(tried, cases(80));
  EXPECT_GT(touching, 7 * tried / 10);
}
}  // namespace test
}  // namespace pkm_workspace
