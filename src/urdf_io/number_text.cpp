// SPDX-License-Identifier: BSD-3-Clause
#include "number_text.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace urdf_io
{
std::string roundedText(double value, int digits)
{
  return nearly(value, digits);
}

std::string numberText(double value)
{
  return exact(value);
}

std::string vectorText(const Eigen::Vector3d& v)
{
  return exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z());
}
}  // namespace urdf_io
}  // namespace pkm_workspace
