// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

#include "pkm_workspace/dexterity/region_check.h"

namespace pkm_workspace
{
/// Bounds of 1 / kappa = psi_1 / psi_3 over a box, from 0 (singular) to 1 (isotropic).
struct ConditioningBounds
{
  Interval mean;   ///< encloses the mean over the box, to second order in its size
  Interval range;  ///< encloses the values at all of its points
};

/// Encloses the local conditioning index 1 / kappa of J over a box; where a strut does not reach it is taken for 0.
ConditioningBounds conditioningOver(const MachineModel<double>& model, const Box& box);

/// What ends the computation. Values with defaults; validate() tells what is wrong.
struct ConditioningQuery
{
  double accuracy = 1e-2;  ///< wanted width of the enclosure, without unit; > 0
  Budget budget;

  void validate(Problems& problems) const;
};

/// The global conditioning index: the mean of 1 / kappa over a set (Gosselin and Angeles 1991).
struct GlobalConditioning
{
  Interval index;     ///< encloses it; [0, 1] where the set is not proved to have a volume, [0, 0] out of reach
  Interval measure;   ///< encloses the volume of the set [m^3]; of flat sets the area [m^2], of lines the length [m]
  int dimension = 3;  ///< of the set: 3, or how many sides of its box have a width
  std::int64_t boxes = 0;      ///< boxes looked at
  bool complete = false;       ///< the accuracy was met
  bool out_of_memory = false;  ///< the memory ended it
  double seconds = 0.0;
};

/// Encloses the global conditioning index over the part of a box that belongs to a set. Divides boxes where most is
/// still uncertain, until the accuracy is met or the budget ends.
/// @param set tells of boxes whether all of their points belong to it, none, or neither is known
/// @throws std::invalid_argument for a query that is not valid, with all reasons
GlobalConditioning globalConditioning(const Machine& machine, const BoxClassifier& set, const Box& box,
                                      const ConditioningQuery& query);
}  // namespace pkm_workspace
