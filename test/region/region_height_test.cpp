// SPDX-License-Identifier: BSD-3-Clause
// Parallel rails with joint limits: where along them a region stands.
#include "pkm_workspace/region/region_height.h"

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/machine/rails.h"
#include "region/parallel_rails.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

/// The same machine with its travel elsewhere along the first rail, and wider at both ends [m].
Machine withLimitsMoved(const Machine& machine, double shift, double wider)
{
  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
    leg.limits += Interval(shift * parallelSense(machine.leg(0), leg)) + Interval(-wider, wider);
  return Machine(machine.name() + " with limits moved by " + std::to_string(shift), legs, machine.zero());
}

/// How far its joint ranges leave the region along the first rail [m].
Interval travelOf(const Machine& machine, const LargestRegion& region)
{
  Interval travel = Interval::entire();
  for (int i = 0; i < 3; ++i)
  {
    const JointRange& range = region.joint_ranges[static_cast<std::size_t>(i)];
    const Interval& limits = machine.leg(i).limits;
    EXPECT_TRUE(hull(range.lower, range.upper).isSubsetOf(limits)) << machine.name() << ", leg " << i;
    const Interval sense(parallelSense(machine.leg(0), machine.leg(i)));
    const Interval room = sense * limits;
    const Interval values = sense * hull(range.lower, range.upper);
    travel = intersection(travel, Interval(room.lower() - values.lower(), room.upper() - values.upper()));
  }
  return travel;
}

/// @return whether the region stands at the very height of the zero configuration
bool expectStandsNearZero(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = expectProven(machine, query);
  SCOPED_TRACE(machine.name() + ", " + query.shape->name());
  const int axis = mainAxisOfRails(machine);
  const double way = (machine.zero() - region.center)[axis] * mid(slidingStrut(machine.leg(0)).axis)[axis];
  const Interval travel = travelOf(machine, region);
  if (way != 0.0)
  {
    EXPECT_LE(way > 0.0 ? travel.upper() : -travel.lower(), 1e-6);
  }
  return way == 0.0;
}
std::vector<Machine> machines()
{
  return { withParallelRails(SEED), leaning(withParallelRails(SEED + 1)), lyingAlongX(withParallelRails(SEED + 2)) };
}
}  // namespace

TEST(RegionHeight, isThatOfTheZeroConfigurationWhereTheLimitsLeaveIt)
{
  for (const Machine& machine : machines())
    for (const ShapePtr& shape : shapes())
      EXPECT_TRUE(expectStandsNearZero(withLimitsMoved(machine, 0.0, 5.0), queryFor(shape, 1e-3))) << shape->name();
}

TEST(RegionHeight, isAsNearToItAsTheLimitsLeaveIt)
{
  for (const double shift : { 0.6, -0.6 })
    for (const Machine& machine : machines())
      for (const ShapePtr& shape : shapes())
        EXPECT_FALSE(expectStandsNearZero(withLimitsMoved(machine, shift, 0.0), queryFor(shape, 1e-3)));
}

TEST(RegionHeight, isThatOfTheMiddleOfTheSearchBoxWhereTheLimitsLeaveIt)
{
  const Machine machine = withLimitsMoved(withParallelRails(SEED), 0.0, 0.5);
  RegionQuery query = queryFor(makeSquare(), 1e-3);
  query.search_box = Box{ Vector3d(-1.0, -1.0, -0.03), Vector3d(1.0, 1.0, 0.05) };
  EXPECT_EQ(expectProven(machine, query).center.z(), query.search_box->center().z());
  query.search_box = Box{ Vector3d(-1.0, -1.0, -3.0), Vector3d(1.0, 1.0, 5.0) };  // its middle is beyond the travel
  const Interval travel = travelOf(machine, expectProven(machine, query));
  EXPECT_LE(mid(slidingStrut(machine.leg(0)).axis).z() > 0.0 ? travel.upper() : -travel.lower(), 1e-6);
}
}  // namespace test
}  // namespace pkm_workspace
