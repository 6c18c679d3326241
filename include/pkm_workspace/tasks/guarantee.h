// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pkm_workspace/region/guarantee.h"
#include "pkm_workspace/tasks/placed_solid.h"

namespace pkm_workspace
{
/// What can be relied on everywhere in a region.
struct GuaranteeTask
{
  PlacedSolid region;
  GuaranteeQuery query;                 ///< its budget is shared by all quantities, one after the other
  std::vector<std::string> quantities;  ///< names of bounds; empty: all of which enough is known
  /// Told each answer when it is there.
  std::function<void(const Guarantee&)> tell = nullptr;

  /// The names that there are.
  static std::vector<std::string> names();
  /// The bounds that are meant. @param left_out gets a sentence for each that is not named and not known enough of
  /// @param problems gets what is missing of those that are named, and names that there are not
  std::vector<const CriterionBound*> bounds(const Machine& machine, std::vector<std::string>& left_out,
                                            Problems& problems) const;
};

struct GuaranteeReport
{
  std::vector<Guarantee> found;
  std::vector<std::string> messages;  ///< one for each: what is proved, and what binds where
  std::vector<std::string> left_out;  ///< as GuaranteeTask::bounds() tells
};

/// @throws std::invalid_argument for a task that is not valid, with all reasons
GuaranteeReport guaranteed(const Machine& machine, const GuaranteeTask& task);
}  // namespace pkm_workspace
