// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <iterator>

#include "pkm_workspace/machine/catalogue.h"
#include "problem.h"
#include "rows.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The least psi within the largest square is next to 0.5, in a tiny spot.
void measureSquare(benchmark::State& state, double difference_of_radii)
{
  const Machine machine = uranesx(Interval(difference_of_radii), Interval(0.0));
  LargestRegion region;
  for (auto _ : state)
    region = findByOurWay(machine, true, 1e-4);
  if (region.status != LargestRegion::Status::PROVEN)
    state.SkipWithError("not proved");
  state.counters["size"] = region.size;
  state.counters["upper"] = region.size_upper_bound;
  state.counters["centers"] = static_cast<double>(region.boxes);
  state.counters["points"] = static_cast<double>(region.verification_boxes);
}

/// The time of the row is the median of the machines; the slowest one is a note.
void measureCrooked(benchmark::State& state)
{
  std::vector<Machine> machines;
  for (unsigned seed = 1; seed <= 20; ++seed)
    machines.push_back(test::crooked(seed));
  std::vector<std::vector<double>> seconds(machines.size());  // of each machine
  std::vector<double> centers, points;                        // the same in all turns
  bool are_proved = true;
  for (auto _ : state)
  {
    std::vector<double> turn;
    for (std::size_t i = 0; i < machines.size(); ++i)
    {
      const auto begin = std::chrono::steady_clock::now();
      const LargestRegion region = findByOurWay(machines[i], false, 1e-4);
      turn.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      are_proved = are_proved && region.status == LargestRegion::Status::PROVEN;
      seconds[i].push_back(turn.back());
      centers.push_back(static_cast<double>(region.boxes));
      points.push_back(static_cast<double>(region.verification_boxes));
    }
    state.SetIterationTime(median(turn));
  }
  if (!are_proved)
    state.SkipWithError("not proved");
  std::vector<double> of_machine;
  std::transform(seconds.begin(), seconds.end(), std::back_inserter(of_machine), median);
  state.counters["centers"] = median(centers);
  state.counters["points"] = median(points);
  state.counters["worst [ms]"] = 1e3 * *std::max_element(of_machine.begin(), of_machine.end());
}
}  // namespace

void addHardRows()
{
  for (const char* difference : { "0.3848", "0.3850" })
    addRow(std::string("UraneSX with R - r = ") + difference + ", square", "1e-4", OURS, 5,
           [difference](benchmark::State& state) { measureSquare(state, std::stod(difference)); })
        ->UseRealTime();
  addRow("20 crooked machines, cube, median", "1e-4", OURS, 5, measureCrooked)->UseManualTime();
}
}  // namespace bench
}  // namespace pkm_workspace
