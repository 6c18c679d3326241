// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "formats.h"

namespace pkm_workspace
{
namespace firmware
{
/// Puts the lines of files that a text includes in the place of the lines that name them. A file that cannot be read is
/// told as left aside, one that is included a second time is a problem.
class Includes
{
public:
  /// @param name of the file that a line includes; empty where it includes none
  Includes(const Source& source, Reading& reading, const std::function<std::string(const std::string& line)>& name)
    : source_(source), reading_(reading), name_(name)
  {}

  std::vector<SourceLine> expand(const std::vector<SourceLine>& lines);

private:
  void include(const SourceLine& line, const std::string& name, std::vector<SourceLine>& all);

  const Source& source_;
  Reading& reading_;
  std::function<std::string(const std::string& line)> name_;
  std::set<std::string> names_;
};
}  // namespace firmware
}  // namespace pkm_workspace
