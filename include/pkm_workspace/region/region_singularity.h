// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// Asks for the singularities in the region c + h K, in either aspect and without joint limits.
SingularityQuery singularitiesOver(const ShapePtr& shape, const Eigen::Vector3d& center, double size);
}  // namespace pkm_workspace
