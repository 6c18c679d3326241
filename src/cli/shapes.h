// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pkm_workspace/region/shape.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// The names that --shape takes.
Words shapeNames();
/// @throws std::invalid_argument when the shape needs proportions and has none, or the other way round
ShapePtr makeShape(const std::string& name, const std::optional<Eigen::Vector3d>& proportions);
}  // namespace cli
}  // namespace pkm_workspace
