// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
// Bodies of which some measures are given and one is the size. Each @throws std::invalid_argument unless what is given
// is positive and finite [m].

/// Where the center of a region lies in it.
enum class Stand
{
  ON_BASE,      ///< the region reaches upward from it
  ABOUT_CENTER  ///< in its middle
};

/// Along z, as high as it can be. Size: height [m].
ShapePtr makeCylinderOfRadius(double radius, Stand stand);
/// Along z, as wide as it can be, about its center. Size: radius [m].
ShapePtr makeCylinderOfHeight(double height);
/// As high as it can be, with these sides along x and y, about its center. Size: height [m].
ShapePtr makeBoxOfFootprint(double x, double y);
/// The same above its base, whose middle is the region's center.
ShapePtr makeBoxOnBase(double x, double y);
}  // namespace pkm_workspace
