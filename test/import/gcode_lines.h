// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "pkm_workspace/import/gcode_job.h"

namespace pkm_workspace
{
namespace test
{
/// A job that begins in the origin.
inline GcodeSetup atZero()
{
  GcodeSetup setup;
  setup.start = Eigen::Vector3d::Zero();
  return setup;
}

/// Why the last line is refused; the others are not.
inline std::string refusalOf(const std::vector<std::string>& lines, const GcodeSetup& setup = atZero())
{
  GcodeJob job(setup);
  for (std::size_t k = 0; k + 1 < lines.size(); ++k)
    job.read(lines[k]);
  try
  {
    job.read(lines.back());
  }
  catch (const std::invalid_argument& reason)
  {
    return reason.what();
  }
  return "";
}
}  // namespace test
}  // namespace pkm_workspace
