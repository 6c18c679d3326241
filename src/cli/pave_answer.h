// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/beyond_limits.h"

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

/// What there is to say of pavings.
struct Paved
{
  /// Of the set in both aspects where that was asked for, then in the machine's own aspect and in the other one.
  std::vector<Paving> pavings;
  std::vector<Interval> sizes;          ///< enclose their volumes, or areas
  std::size_t asked = 0;                ///< which of them was asked for
  std::string ended_by;                 ///< what ended one of them early, if anything: "the time limit of 20 s"
  bool is_section = false;              ///< the box is the plane across the rails along which nothing changes
  std::optional<JointReaches> reaches;  ///< of the one asked for, where joint limits are left aside
  std::int64_t most_listed = 0;         ///< boxes that are listed in the JSON object
};

/// What pkm pave says; what is long refers to @p paved.
Answer answerOf(const Machine& machine, const Paved& paved);
}  // namespace cli
}  // namespace pkm_workspace
