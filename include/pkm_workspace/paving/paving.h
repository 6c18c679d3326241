// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/paving/box_tree.h"

namespace pkm_workspace
{
struct PavingProgress
{
  double volume_inside = 0.0;    ///< V_a so far [m^3]
  double volume_boundary = 0.0;  ///< V_e so far: undecided and not yet looked at [m^3]
  std::int64_t boxes = 0;
  double seconds = 0.0;
};

/// What to pave. Values with defaults; validate() tells what is wrong.
struct PavingQuery
{
  Criterion criterion;
  double resolution = 0.05;  ///< boxes no wider than this are not bisected further [m]; > 0
  std::optional<Box> box;    ///< what to pave [m]; without it, the bounds of the workspace
  Budget budget;
  std::function<void(const PavingProgress&)> progress;

  void validate(Problems& problems) const;
};

/// The box approximation of the criterion's set (paper, section 2.6).
struct Paving
{
  Box box;                   ///< what was paved [m]
  BoxTree tree;              ///< its boxes: S is those that are INSIDE
  Interval volume_inside;    ///< encloses V_a, the volume of the inner boxes [m^3]
  Interval volume_boundary;  ///< encloses V_e, the volume of boundary and pending boxes [m^3]
  std::int64_t boxes = 0;    ///< boxes looked at
  double seconds = 0.0;
  bool complete = false;  ///< no box is pending

  /// The volume of the set within the box lies between these [m^3].
  double volumeLower() const { return volume_inside.lower(); }
  double volumeUpper() const { return (volume_inside + volume_boundary).upper(); }
};

/// @throws std::invalid_argument for a query that is not valid, with all reasons
Paving pave(const Machine& machine, const PavingQuery& query);
}  // namespace pkm_workspace
