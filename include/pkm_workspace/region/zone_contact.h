// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pkm_workspace/dexterity/zone_forms.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// Where a region that grows about the center meets the zone first, nearly so; floating point. [m]
Eigen::Vector3d firstContact(const PlainZone<double>& zone, const Shape& shape, const Eigen::Vector3d& center);

/// A point of the region c + K(h) that is nearly as near to the zone as any; floating point. [m]
Eigen::Vector3d nearestToZone(const PlainZone<double>& zone, const Shape& shape, const Eigen::Vector3d& center,
                              double size);
}  // namespace pkm_workspace
