// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pkm_workspace
{
/// What is told of a file that cannot be read or written.

/// @throws std::invalid_argument "PATH: cannot be DONE: REASON"
[[noreturn]] void failFile(const std::string& path, const char* done, const std::string& reason);
/// The words of the system for an error number, with what helps.
std::string reasonOf(int error);
/// What a file of this mode is, with what helps; empty for a regular file.
std::string otherKind(unsigned mode);
}  // namespace pkm_workspace
