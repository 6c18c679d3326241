// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/paving/paving.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
void measurePaving(benchmark::State& state, int threads)
{
  const Machine machine = orthoglide();
  PavingQuery query;
  query.resolution = 0.01;
  query.box = Box{ -Eigen::Vector3d::Ones(), Eigen::Vector3d::Ones() };
  query.budget.threads = threads;
  double seconds = 0.0, boxes = 0.0;
  for (auto _ : state)
  {
    const Paving paving = pave(machine, query);
    seconds = paving.seconds;
    boxes = static_cast<double>(paving.boxes);
    state.counters["points"] = boxes;
    state.counters["V_a"] = paving.volumeLower();
    state.counters["V_e"] = paving.volume_boundary.upper();
  }
  state.counters["ns a box"] = 1e9 * seconds / boxes;
}
}  // namespace

void addPavingRows()
{
  for (const int threads : { 1, 2 })
    addRow("Orthoglide, paving of [-1, 1]^3", "0.01", threads == 1 ? "one thread" : "two threads", 5,
           [threads](benchmark::State& state) { measurePaving(state, threads); })
        ->UseRealTime();
}
}  // namespace bench
}  // namespace pkm_workspace
