// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Throws all that is wrong with a URDF; does nothing where nothing is. @throws std::invalid_argument
inline void throwRefusal(const Problems& problems)
{
  throwProblems(problems, "the URDF is refused:");
}
}  // namespace urdf_io
}  // namespace pkm_workspace
