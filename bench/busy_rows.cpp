// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "pkm_workspace/common/processors.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/largest_region.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
/// More threads than most machines have processors.
constexpr int MANY = 16;

/// Keeps every processor busy for as long as it lives.
class BusyLoops
{
public:
  explicit BusyLoops(int count)
  {
    for (int k = 0; k < count; ++k)
      loops_.emplace_back([this] {
        while (!ends_)
          ;
      });
  }
  ~BusyLoops()
  {
    ends_ = true;
    for (std::thread& loop : loops_)
      loop.join();
  }

private:
  std::atomic<bool> ends_{ false };
  std::vector<std::thread> loops_;
};

/// The slowest turn is a note: where others compute, it is what a user waits for.
void measureBeside(benchmark::State& state, int loops, const std::function<void()>& compute)
{
  using Clock = std::chrono::steady_clock;
  const BusyLoops busy(loops);
  Clock::duration worst(0);
  for (auto _ : state)
  {
    const auto begin = Clock::now();
    compute();
    worst = std::max(worst, Clock::now() - begin);
  }
  state.counters["worst [ms]"] = std::chrono::duration<double, std::milli>(worst).count();
}

void findLargest(const Machine& machine, const ShapePtr& shape, int threads)
{
  RegionQuery query;
  query.shape = shape;
  query.budget.threads = threads;
  findLargestRegion(machine, query);
}

void paveCube(int threads)
{
  PavingQuery query;
  query.resolution = 0.02;
  query.box = Box{ -Eigen::Vector3d::Ones(), Eigen::Vector3d::Ones() };
  query.budget.threads = threads;
  pave(orthoglide(), query);
}

std::string wayOf(int threads)
{
  return threads == 1 ? "one thread"
                      : std::to_string(threads) + " threads" + (threads == processors() ? ", the default" : "");
}

void addRowsOf(const std::string& name, const std::string& accuracy, const std::function<void(int)>& compute)
{
  for (const bool is_busy : { false, true })
    for (const int threads : std::set<int>{ 1, processors(), MANY })
      addRow(
          name + (is_busy ? ", a busy loop on every processor" : ", idle machine"), accuracy, wayOf(threads), 5,
          [=](benchmark::State& state) { measureBeside(state, is_busy ? processors() : 0, [&] { compute(threads); }); })
          ->UseRealTime();
}
}  // namespace

void addBusyRows()
{
  addRowsOf("Orthoglide, cube", "1e-3", [](int threads) { findLargest(orthoglide(), makeCube(), threads); });
  addRowsOf("UraneSX, square", "1e-3", [](int threads) { findLargest(uranesx(), makeSquare(), threads); });
  addRowsOf("Orthoglide, paving of [-1, 1]^3", "0.02", paveCube);
}
}  // namespace bench
}  // namespace pkm_workspace
