// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
namespace cli
{
/// What the size of a box is called: a flat one has an area.
struct Measure
{
  explicit Measure(const Box& box);

  int dimension;
  std::string name;  ///< "volume"
  std::string unit;  ///< " m^3"
};

/// What pkm pave says.
/// @param pavings of the set that was asked for, of its part in the machine's own aspect unless that is the same, and
/// of its part in the other aspect
/// @param is_section whether the box is the plane across the rails along which nothing changes
Answer answerOf(const Machine& machine, const std::vector<Paving>& pavings, bool is_section);
}  // namespace cli
}  // namespace pkm_workspace
