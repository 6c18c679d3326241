// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pkm_workspace
{
namespace urdf_io
{
/// Something to warn of. Those of one kind become one sentence.
struct Notice
{
  std::string one;    ///< the sentence when it is the only one of its kind
  std::string kind;   ///< the sentence for several, up to its list: "the limits of passive joints are not used"
  std::string value;  ///< what differs, with its unit; may be empty
  std::string about;  ///< the name that it is about; may be empty
};

/// "'a', 'b'". @param none what to say where there is no name
std::string listOf(const std::vector<std::string>& names, const std::string& none = "");

/// A sentence for each kind, in the order in which they come first: "KIND: VALUE ('a', 'b'), VALUE ('c')".
std::vector<std::string> sentencesOf(const std::vector<Notice>& notices);
}  // namespace urdf_io
}  // namespace pkm_workspace
