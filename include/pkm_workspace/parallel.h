// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace pkm_workspace
{
/// Calls work(index) for every index below @p count, on up to @p threads threads, this one included; returns when all
/// are done. Which thread gets which index is open: results belong into slots of their own, so that they do not depend
/// on it.
/// @pre work does not throw
template <class Work>
void parallelFor(int threads, std::size_t count, const Work& work)
{
  std::atomic<std::size_t> next(0);
  const auto serve = [&] {
    for (std::size_t index = next++; index < count; index = next++)
      work(index);
  };
  std::vector<std::thread> helpers;
  for (int helper = 1; helper < threads && static_cast<std::size_t>(helper) < count; ++helper)
    helpers.emplace_back(serve);
  serve();
  for (std::thread& helper : helpers)
    helper.join();
}
}  // namespace pkm_workspace
