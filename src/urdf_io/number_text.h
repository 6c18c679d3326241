// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

namespace pkm_workspace
{
namespace urdf_io
{
/// Writes a number with the fewest digits, 15 to 17, that read back as the same double; in any locale.
std::string numberText(double value);

/// Writes a number with at most @p digits digits; in any locale.
std::string roundedText(double value, int digits);

/// Writes three numbers as URDF has them.
std::string vectorText(const Eigen::Vector3d& v);
}  // namespace urdf_io
}  // namespace pkm_workspace
