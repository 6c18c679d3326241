// SPDX-License-Identifier: BSD-3-Clause
#include "round_shape.h"

#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
ShapePtr makeSphere()
{
  return std::make_shared<RoundShape>("sphere", "radius [m]", 3, Growing<double>{ 0.0, 1.0 }, Heights());
}

ShapePtr makeDisc()
{
  return std::make_shared<RoundShape>("disc", "radius [m]", 2, Growing<double>{ 0.0, 1.0 }, Heights());
}

ShapePtr makeCylinder(double ratio)
{
  if (!(ratio >= 1e-6 && ratio <= 1e6))
  {
    TextStream text;
    text << "ratio = " << ratio << " (radius over height of a cylinder) must be from 1e-6 to 1e6";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<RoundShape>("cylinder", "height [m]", 2, Growing<double>{ 0.0, ratio }, aboutCenter(0.5));
}

ShapePtr makeCylinder(double radius, double height)
{
  const auto isOrdinary = [](double length) { return length >= 1e-100 && length <= 1e100; };
  if (!isOrdinary(radius) || !isOrdinary(height))
  {
    TextStream text;
    text << "cylinder of radius " << radius << " m and height " << height
         << " m: both must be positive and finite (1e-100 to 1e100)";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<RoundShape>("cylinder", "factor on radius and height", 2, Growing<double>{ 0.0, radius },
                                      aboutCenter(0.5 * height));
}
}  // namespace pkm_workspace
