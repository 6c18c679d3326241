// SPDX-License-Identifier: BSD-3-Clause
#include "box_shape.h"

#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
ShapePtr makeCube()
{
  return std::make_shared<BoxShape>("cube", "edge [m]", Eigen::Vector3d::Ones());
}

ShapePtr makeSquare()
{
  return std::make_shared<BoxShape>("square", "edge [m]", Eigen::Vector3d(1.0, 1.0, 0.0));
}

ShapePtr makeBox(const Eigen::Vector3d& proportions)
{
  const bool finite = proportions.allFinite() && (proportions.array() >= 0.0).all();
  // halves and products with sizes have to stay ordinary numbers
  const bool ordinary = finite && proportions.maxCoeff() >= 1e-100 && proportions.maxCoeff() <= 1e100 &&
                        (proportions.array() == 0.0 || proportions.array() >= 1e-100).all();
  if (!ordinary)
  {
    TextStream text;
    text << "proportions (" << proportions[0] << ", " << proportions[1] << ", " << proportions[2]
         << ") [m per unit of size] must be finite, 0 or positive "
         << "(1e-100 to 1e100), and at least one of them positive";
    throw std::invalid_argument(text.str());
  }
  return std::make_shared<BoxShape>("box", "factor on the proportions", proportions);
}
}  // namespace pkm_workspace
