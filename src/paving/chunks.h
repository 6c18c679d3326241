// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "pkm_workspace/common/parallel.h"

namespace pkm_workspace
{
/// Pieces of work that a thread takes at a time.
constexpr std::size_t TOGETHER = 128;

/// Calls work(first, last) for all parts of [0, count).
template <class Work>
void inChunks(ThreadPool& pool, std::size_t count, const Work& work)
{
  pool.forEach((count + TOGETHER - 1) / TOGETHER,
               [&](std::size_t chunk) { work(chunk * TOGETHER, std::min(count, (chunk + 1) * TOGETHER)); });
}
}  // namespace pkm_workspace
