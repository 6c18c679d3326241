// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pkm_workspace
{
/// A file that is read, or written, as a whole or not at all. Each of these
/// @throws std::invalid_argument with the file's name and the reason of the system
std::string readWholeFile(const std::string& path);
/// By a file of another name beside it, which then takes its place.
void writeWholeFile(const std::string& path, const std::string& content);
/// Whether writeWholeFile() could write there now.
void checkWholeFile(const std::string& path);
}  // namespace pkm_workspace
