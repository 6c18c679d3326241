// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"
#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The names of all links that hang at a joint which is not fixed.
std::vector<std::string> movedLinks(const Model& model);

/// The collision geometry of the links that do not move.
struct StillCollisions
{
  std::vector<Zone> zones;        ///< to keep out of, in the root frame, named as their links
  std::vector<std::string> open;  ///< what is no box, cylinder or sphere: a phrase for each
};

/// @param moved names of the links that move
StillCollisions stillCollisions(const Model& model, const std::vector<std::string>& moved);
}  // namespace urdf_io
}  // namespace pkm_workspace
