// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

namespace pkm_workspace
{
namespace urdf_io
{
/// As exact().
std::string numberText(double value);

/// As nearly().
std::string roundedText(double value, int digits);

/// Writes three numbers as URDF has them.
std::string vectorText(const Eigen::Vector3d& v);
}  // namespace urdf_io
}  // namespace pkm_workspace
