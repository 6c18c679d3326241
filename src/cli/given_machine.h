// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace cli
{
/// A machine in place of a file, that was read before.
struct GivenMachine
{
  std::string urdf;                      ///< the text
  UrdfOptions names;                     ///< with which it was read
  std::optional<UrdfMachine> read = {};  ///< none: it is about to be
};
}  // namespace cli
}  // namespace pkm_workspace
