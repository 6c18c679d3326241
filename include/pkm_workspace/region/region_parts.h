// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/global_conditioning.h"
#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// Asks for the singularities in the region c + K(h), in either aspect and without joint limits.
SingularityQuery singularitiesOver(const ShapePtr& shape, const Eigen::Vector3d& center, double size);

/// The global conditioning index over the region c + K(h); of flat shapes, over their area.
/// @throws std::invalid_argument for a query that is not valid, or a size that is not positive
GlobalConditioning globalConditioning(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center,
                                      double size, const ConditioningQuery& query);
}  // namespace pkm_workspace
