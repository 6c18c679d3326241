// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/import/firmware.h"

namespace pkm_workspace
{
namespace firmware
{
struct SourceLine
{
  SourcePlace place;
  std::string text;  ///< without its end; valid UTF-8
};

/// Cuts a file into lines that end with LF, CRLF or CR. A byte order mark is skipped, bytes that are not UTF-8 become
/// U+FFFD: they stand in comments. UTF-16, zero bytes and more than is read are problems.
std::vector<SourceLine> sourceLines(const std::string& file, const std::string& content, Problems& problems);

/// Without blanks and tabs at both ends.
std::string trimmed(const std::string& text);
std::string lowered(std::string text);
bool startsWith(const std::string& text, const std::string& beginning);
/// Parts between separators, trimmed.
std::vector<std::string> split(const std::string& text, char separator);
/// In quotes, the middle left out where it is long.
std::string quoted(const std::string& text);
}  // namespace firmware
}  // namespace pkm_workspace
