// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// How a kind of file with [sections] is written.
struct IniDialect
{
  const char* separators;        ///< between key and value: the first of them counts
  bool hash_begins_comment;      ///< also within a line
  bool lower_case_keys;          ///< keys are the same in either case
  bool indented_lines_continue;  ///< the value above
};

/// Reads lines into entries with the key "section key". What is neither a section, an entry nor a comment is a problem.
std::vector<Entry> readIni(const std::vector<SourceLine>& lines, const IniDialect& dialect, Reading& reading);

/// The name in "[name]" where the line is such a header, empty otherwise.
std::string sectionOf(const std::string& line);
}  // namespace firmware
}  // namespace pkm_workspace
