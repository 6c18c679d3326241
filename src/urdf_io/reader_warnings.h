// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "closure.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Names what the URDF says and the machine does not hold (limits of passive joints, soft limits, axes that fit only
/// nearly, unknown elements), and what is hardly meant: rails that cannot move, lengths in millimetres. One sentence
/// for each kind.
std::vector<std::string> warningsAbout(const Model& model, const std::array<Rail, 3>& rails, const Closure& closure);
}  // namespace urdf_io
}  // namespace pkm_workspace
