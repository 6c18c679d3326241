// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "pkm_workspace/common/pace.h"
#include "pkm_workspace/dexterity/premises.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/paving/box_tree.h"

namespace pkm_workspace
{
struct PavingProgress
{
  double volume_inside = 0.0;    ///< V_a so far [m^3]
  double volume_boundary = 0.0;  ///< V_e so far: undecided and not yet looked at [m^3]
  std::int64_t boxes = 0;        ///< boxes looked at in this run
  double seconds = 0.0;

  double boxesPerSecond() const { return seconds > 0.0 ? static_cast<double>(boxes) / seconds : 0.0; }
};

/// What to pave. Values with defaults; validate() tells what is wrong.
struct PavingQuery
{
  Criterion criterion;
  double resolution = 0.05;                             ///< boxes no wider than this are not bisected further [m]; > 0
  std::optional<Box> box;                               ///< what to pave [m]; without it, defaultBox()
  Budget budget;                                        ///< of boxes and time, those of this run count
  std::function<void(const PavingProgress&)> progress;  ///< called now and then, if given
  double progress_period = PROGRESS_PERIOD;             ///< [s], >= 0

  void validate(Problems& problems) const;
};

/// The box approximation of the criterion's set (paper, section 2.6). Of a flat box, volumes are areas [m^2].
struct Paving
{
  Premises premises;            ///< what it is about, in the frame of the root link
  double resolution = 0.0;      ///< boxes no wider than this are not bisected [m]
  Box box;                      ///< what was paved [m]
  BoxTree tree;                 ///< its boxes: S is those that are INSIDE
  Interval volume_inside;       ///< encloses V_a, the volume of the inner boxes [m^3]
  Interval volume_boundary;     ///< encloses V_e, the volume of boundary and pending boxes [m^3]
  std::int64_t boxes = 0;       ///< boxes looked at, in earlier runs too
  std::int64_t boxes_here = 0;  ///< of these, boxes looked at in this run
  double seconds = 0.0;         ///< that this run took
  bool complete = false;        ///< no box is pending

  /// Sets volumes, boxes and complete from the tree.
  void sumUp();
  /// The volume of the set within the box lies between these [m^3].
  double volumeLower() const { return volume_inside.lower(); }
  double volumeUpper() const;
};

/// What is paved where no box is asked for [m]: the bounds of the workspace; where nothing changes along the rails, the
/// flat box of its section with the plane through the zero configuration, across the axis that they run along most.
/// @throws std::invalid_argument when the set has no bounds
Box defaultBox(const Machine& machine, const Criterion& criterion);

/// @throws std::invalid_argument for a query that is not valid, with all reasons
Paving pave(const Machine& machine, const PavingQuery& query);

/// Goes on from an earlier paving of the same premises and box, finished or not, at any resolution: looks
/// only at boxes that it left open and at their parts. Without a budget in the way the tree and all that follows from
/// it is, bit for bit, what pave() gives.
/// @throws std::invalid_argument for a query that is not valid or about something else, with all reasons
Paving resume(const Machine& machine, const PavingQuery& query, const Paving& earlier);

/// Appends one sentence for each thing in which the paving is about something else than the query.
void validateEarlier(const Machine& machine, const PavingQuery& query, const Paving& earlier, Problems& problems);
}  // namespace pkm_workspace
