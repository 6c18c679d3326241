// SPDX-License-Identifier: BSD-3-Clause
#include "path_problem.h"
#include "pkm_workspace/region/placement.h"
#include "pkm_workspace/region/polytope.h"
#include "problem.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr std::size_t MOVES = 10000;

/// The curve of the path rows, in lines.
std::shared_ptr<Workpiece> path()
{
  auto workpiece = std::make_shared<Workpiece>();
  for (std::size_t i = 0; i < MOVES; ++i)
    workpiece->moves.add(
        Curve::line(curve(static_cast<double>(i) / MOVES), curve((static_cast<double>(i) + 1.0) / MOVES)),
        Interval(0.0));
  workpiece->moves.close();
  return workpiece;
}

/// A tetrahedron.
std::shared_ptr<Workpiece> part()
{
  auto workpiece = std::make_shared<Workpiece>();
  workpiece->solid = makePolytope({ { 0.2, 0.0, -0.1 }, { -0.2, 0.1, -0.1 }, { -0.1, -0.2, -0.1 }, { 0.0, 0.0, 0.3 } });
  return workpiece;
}

void addPlacement(const std::string& name, const std::shared_ptr<Workpiece>& workpiece, const std::string& accuracy,
                  double wanted)
{
  addRow("Orthoglide, " + name + " placed", accuracy, OURS, 3, [workpiece, wanted](benchmark::State& state) {
    PlacementQuery query;
    query.workpiece = workpiece;
    query.accuracy = wanted;
    query.budget.threads = 1;
    Placement placement;
    for (auto _ : state)
      placement = findPlacement(orthoglideCube().machine, query);
    state.counters["size"] = placement.found.size;
    state.counters["upper"] = placement.found.size_upper_bound;
    state.counters["centers"] = static_cast<double>(placement.found.boxes);
  });
}
}  // namespace

void addPlacementRows()
{
  for (const auto& [accuracy, wanted] : { std::make_pair("1e-2", 1e-2), std::make_pair("1e-4", 1e-4) })
  {
    addPlacement("a path of 10^4 lines", path(), accuracy, wanted);
    addPlacement("a tetrahedron", part(), accuracy, wanted);
  }
}
}  // namespace bench
}  // namespace pkm_workspace
