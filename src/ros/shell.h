// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
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
  std::uint8_t paint = 0;
};
/// What part of a surface is painted with; rectangles are of one paint.
using Paint = std::function<std::uint8_t(const Patch& part)>;

/// The surface of all boxes together, in few rectangles: what lies within is not seen, and costs as much to draw.
/// @param boxes do not overlap, and share faces of equal numbers where they touch
/// @param others what hides a face as well
/// @param absent what hides nothing: parts that are painted end at its planes, too
/// @param paint asked for each part of the surface that no plane of a box cuts
std::vector<Patch> shellOf(const std::vector<Box>& boxes, const std::vector<Box>& others,
                           const std::vector<Box>& absent, const Paint& paint);
}  // namespace pkm_workspace
