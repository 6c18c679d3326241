// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pkm_workspace/region/solid.h"

namespace pkm_workspace
{
/// A body at its place: the region that a question is about.
struct PlacedSolid
{
  Solid solid;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m]
};
}  // namespace pkm_workspace
