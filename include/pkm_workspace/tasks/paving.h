// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/paving/components.h"
#include "pkm_workspace/paving/set_volume.h"
#include "pkm_workspace/region/beyond_limits.h"

namespace pkm_workspace
{
/// How a set hangs together.
struct ComponentsReport
{
  std::vector<Component> list;
  std::size_t clusters = 0;         ///< no path joins any two of them
  std::optional<std::size_t> zero;  ///< the component that holds the zero configuration
  std::string message;              ///< what is proved
};

/// A paving, and what is told beside it.
struct PavingReport
{
  Paving paving;
  SetVolume size;                              ///< of the set in the box, more closely than the boxes have it
  std::optional<JointReaches> reaches;         ///< over that set, where joint limits are left aside
  std::optional<ComponentsReport> components;  ///< where they are asked for
  std::string ended_by;                        ///< "the time limit of 20 s"; empty where all that was asked is known

  bool complete() const { return ended_by.empty(); }
  double seconds() const { return paving.seconds + size.seconds; }

  /// What is proved, and what that means for limits that are left aside.
  std::string message(const Machine& machine) const;
};

/// @param is_whole whether the set has no point out of the paving's box, or is the same all along the rails
/// @param budget of time: once it is over, all is left open
/// @throws std::invalid_argument for more boxes than Components takes
ComponentsReport reportComponents(const Machine& machine, const Paving& paving, bool is_whole, const Budget& budget);

/// What a query is paved at that asks for no resolution: a share of the longest strut [m].
/// @throws std::invalid_argument when the set has no bounds
double defaultResolution(const Machine& machine, const PavingQuery& query);

/// Paves, or goes on from an earlier paving.
/// @param wanted of the volume; its budget and progress are those of the query
/// @throws std::invalid_argument as pave(), resume() and setVolume()
PavingReport reportPaving(const Machine& machine, const PavingQuery& query, const Paving* earlier,
                          VolumeQuery wanted = {});
}  // namespace pkm_workspace
