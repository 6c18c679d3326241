// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pkm_workspace/interval/box.h"

namespace pkm_workspace
{
/// A rectangle across an axis.
struct Patch
{
  int axis;
  bool is_upper;  ///< whether what it is the border of lies below it on that axis
  Box box;        ///< flat across the axis [m]
};

/// The surface of all boxes together, in few rectangles: what lies within is not seen, and costs as much to draw.
/// @param boxes do not overlap, and share faces of equal numbers where they touch
/// @param others what hides a face as well
std::vector<Patch> shellOf(const std::vector<Box>& boxes, const std::vector<Box>& others);
}  // namespace pkm_workspace
