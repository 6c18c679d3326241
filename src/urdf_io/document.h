// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "notice.h"
#include "pkm_workspace/common/problems.h"
#include "placement.h"
#include "tolerance_elements.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The longest text that is read [bytes]; the URDFs of large robots have a tenth of it.
constexpr std::size_t LARGEST_TEXT = 4 * 1024 * 1024;

/// What is taken from the text of a URDF itself, before urdfdom reads it.
struct Document
{
  std::string elements;                   ///< the elements and attributes of the robot, nothing else: what urdfdom gets
  std::vector<std::string> joints;        ///< names in the order of the file
  std::map<std::string, Origin> origins;  ///< of each joint; urdfdom turns angles into quaternions, and rounds
  std::vector<ToleranceElement> tolerances;
  std::vector<Notice> warnings;  ///< elements and attributes of joints that nobody reads
};

/// Parses the text and checks what urdfdom accepts in silence (docs/urdf.md).
/// @throws std::invalid_argument listing every problem, when urdfdom could not bear the text
Document readDocument(const std::string& xml, Problems& problems);
}  // namespace urdf_io
}  // namespace pkm_workspace
