// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

namespace pkm_workspace
{
namespace bench
{
/// Our own way: the first row of each case and accuracy, to which the table compares the others.
constexpr const char* OURS = "this search";

/// A row of the table: its body has the loop and sets the counters.
///
/// The table (bench/table.py) knows the counters "centers" and "points", boxes of either that were looked at; "size"
/// and "upper", a bracket that has to agree with those of the other rows of its case; all others are notes.
inline benchmark::internal::Benchmark* addRow(const std::string& name, const std::string& accuracy,
                                              const std::string& way, int repetitions,
                                              const std::function<void(benchmark::State&)>& body)
{
  const std::string key = name + "|" + accuracy + "|" + way;
  return benchmark::RegisterBenchmark(key.c_str(), body)
      ->Repetitions(repetitions)
      ->MinTime(0.05)
      ->Unit(benchmark::kMillisecond);
}

/// The largest cube of the Orthoglide and the largest square of the UraneSX, by all ways at all accuracies.
void addLargestRows();
/// The largest squares and cubes that only our own way is fit for.
void addHardRows();
/// The largest regions of machines of other legs than sliding struts.
void addLegRows();
/// The largest squares and cubes with one more condition, and with all of them.
void addConditionRows();
/// One cube of the Orthoglide verified by all ways.
void addVerificationRows();
/// The paving of the Orthoglide's set, on one thread and on two.
void addPavingRows();
/// What more threads cost and gain where nothing else computes, and beside busy loops.
void addBusyRows();
/// Paths of many segments with what the machine does along them, and single points.
void addPathRows();
/// Where a path and a part fit with the largest margin.
void addPlacementRows();
}  // namespace bench
}  // namespace pkm_workspace
