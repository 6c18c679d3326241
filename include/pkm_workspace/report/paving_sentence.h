// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// What the size of a box is called: a flat one has an area.
struct Measure
{
  explicit Measure(const Box& box);

  int dimension;
  std::string name;  ///< "volume"
  std::string unit;  ///< " m^3"
};

/// Says what is proved of the size of the set in the box of a paving, and what ended the paving early.
/// @param measure encloses that size @param ended_by "the time limit of 20 s"; empty where every box was looked at
std::string describe(const Paving& paving, const Interval& measure, const Machine& machine,
                     const std::string& ended_by);
}  // namespace pkm_workspace
