// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// One command of G-code.
struct GcodeCommand
{
  SourcePlace place;
  std::string code;          ///< "M665"
  std::vector<Entry> words;  ///< keys are letters
  bool is_conditional;       ///< stands indented after an if or a while
  bool is_report;            ///< begins with what Marlin puts before each line that it reports
};

/// The commands of G-code, or of the log of a terminal in which a firmware reports itself. What follows a semicolon is
/// a comment.
std::vector<GcodeCommand> readGcode(const std::vector<SourceLine>& lines);

/// Adds each word of a command as an entry "M665 L"; of commands that no machine is made of, one entry with their code.
/// @param codes those that it is made of
void addCommands(const std::vector<GcodeCommand>& commands, const std::vector<std::string>& codes, Reading& reading);

/// For Reading::leaveKinds(): the code of a command that no machine is made of.
std::string otherCommand(const Entry& entry);
}  // namespace firmware
}  // namespace pkm_workspace
