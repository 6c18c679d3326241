// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace pkm_workspace
{
/// Files are read, and written, as a whole or not at all: whoever gets an answer about a file knows that all of it was
/// seen. Each of these @throws std::invalid_argument with the file's name, the reason of the system and what helps.

/// Bytes of a text of lines, and of one of its lines.
constexpr std::size_t LARGEST_LINES = std::size_t(1) << 30;
constexpr std::size_t LONGEST_LINE = std::size_t(1) << 16;

/// Fills @p data with up to @p size bytes. @return how many, 0 at the end and only there. May throw.
using ByteSource = std::function<std::size_t(char* data, std::size_t size)>;
/// Takes one line, without its end, and its number from 1 on.
using LineTaker = std::function<void(const std::string& line, std::size_t number)>;

/// Reads a regular file, a pipe or what is typed at a terminal, of at most @p most bytes.
std::string readWholeFile(const std::string& path, std::size_t most);

/// Reads such a file line by line and holds one line at a time. What was taken counts only if this returns.
/// @throws std::invalid_argument also for more than LARGEST_LINES or LONGEST_LINE bytes
void readLines(const std::string& path, const LineTaker& take);
/// The same from any source, which @p name stands for; throws what the source throws, too.
void readLines(const std::string& name, const ByteSource& source, const LineTaker& take);

/// What tells the name of a draft from the file's: 16 of the digits 0 to f.
using DraftNames = std::function<std::string()>;
/// Digits that nobody guesses, whatever process ids return.
std::string unguessable();

/// Writes a file of another name beside it, which then takes its place: what is there stays until all of the new
/// content is on the disk, and then leaves it its permissions; a symbolic link goes on to name it. Removes what
/// earlier runs that were killed had left beside it.
/// @param names of which ten are tried where others are taken
void writeWholeFile(const std::string& path, const std::string& content, const DraftNames& names = unguessable);
/// Whether writeWholeFile() could write there now.
void checkWholeFile(const std::string& path);
}  // namespace pkm_workspace
