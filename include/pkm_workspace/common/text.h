// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pkm_workspace
{
/// Leaves the middle of a text away where it has more than @p most bytes, and says how much: what is told of an input
/// does not grow with it. Characters of UTF-8 stay whole.
std::string shortened(const std::string& text, std::size_t most);

/// Whether a file's name ends in this after something else, in letters of any case: ".stl".
bool hasEnding(const std::string& path, const std::string& ending);

/// A phrase with a capital letter and a full stop.
std::string sentence(std::string phrase);

/// The lines of a text.
std::vector<std::string> linesOf(const std::string& text);

/// The words with the separator between them.
std::string joined(const std::vector<std::string>& words, const std::string& separator);
}  // namespace pkm_workspace
