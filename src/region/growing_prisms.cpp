// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/growing_prisms.h"

#include <stdexcept>

#include "box_shape.h"
#include "pkm_workspace/interval/decimal.h"
#include "round_shape.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

void requireLength(const std::string& name, double length)
{
  if (!(length >= 1e-100 && length <= 1e100))
    throw std::invalid_argument(name + " = " + exact(length) + " m must be positive and finite (1e-100 to 1e100)");
}
}  // namespace

ShapePtr makeCylinderOfRadius(double radius, Stand stand)
{
  requireLength("radius", radius);
  const bool is_on_base = stand == Stand::ON_BASE;
  const Heights above{ { 0.0, 0.0 }, { 0.0, 1.0 } };
  return std::make_shared<RoundShape>("cylinder of radius " + exact(radius) + " m" + (is_on_base ? " on its base" : ""),
                                      "height [m]", 2, Growing<double>{ radius, 0.0 },
                                      is_on_base ? above : aboutCenter(0.5));
}

ShapePtr makeCylinderOfHeight(double height)
{
  requireLength("height", height);
  const Heights given{ { -0.5 * height, 0.0 }, { 0.5 * height, 0.0 } };
  return std::make_shared<RoundShape>("cylinder of height " + exact(height) + " m", "radius [m]", 2,
                                      Growing<double>{ 0.0, 1.0 }, given);
}

ShapePtr makeBoxOfFootprint(double x, double y)
{
  requireLength("side along x", x);
  requireLength("side along y", y);
  const GrowingVector half{ Vector3d(0.5 * x, 0.5 * y, 0.0), 0.5 * Vector3d::UnitZ() };
  return std::make_shared<BoxShape>("box on a base of " + exact(x) + " m x " + exact(y) + " m", "height [m]",
                                    -1.0 * half, half);
}

ShapePtr makeBoxOnBase(double x, double y)
{
  return makeBoxOfFootprint(x, y)->standing();
}
}  // namespace pkm_workspace
