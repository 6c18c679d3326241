// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/largest_region.h"
#include "rows.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr double ACCURACY = 1e-3;

void measure(benchmark::State& state, const Machine& machine, const ShapePtr& shape)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = ACCURACY;
  query.criterion.joint_limits = true;
  query.budget.threads = 1;
  LargestRegion region;
  for (auto _ : state)
    region = findLargestRegion(machine, query);
  if (region.status != LargestRegion::Status::PROVEN)
    state.SkipWithError("not proved");
  state.counters["size"] = region.size;
  state.counters["upper"] = region.size_upper_bound;
  state.counters["centers"] = static_cast<double>(region.boxes);
  state.counters["points"] = static_cast<double>(region.verification_boxes);
}

/// The delta with the limits of its URDF.
Machine limitedDelta()
{
  Machine::Legs legs = delta().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.6, 1.5);
  return { "Delta", legs, delta().zero() };
}
}  // namespace

void addLegRows()
{
  const std::pair<const char*, Machine> machines[] = { { "Delta", limitedDelta() },
                                                       { "Tripod", tripod() },
                                                       { "One leg of each kind", test::mixed() } };
  const std::pair<const char*, ShapePtr> shapes[] = { { "cube", makeCube() },
                                                      { "sphere", makeSphere() },
                                                      { "cylinder", makeCylinder(0.5) } };
  for (const auto& [name, machine] : machines)
    for (const auto& [body, shape] : shapes)
      addRow(std::string(name) + ", " + body, "1e-3", OURS, 5,
             [machine = machine, shape = shape](benchmark::State& state) { measure(state, machine, shape); })
          ->UseRealTime();
}
}  // namespace bench
}  // namespace pkm_workspace
