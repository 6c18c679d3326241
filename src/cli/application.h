// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// What is said where there is no memory.
extern const char* const OUT_OF_MEMORY;

/// The command pkm: answers on @p out, says what is wrong on @p err.
/// @param arguments of the command line, without the name of the program
/// @return the exit code: 0 answered, 1 something else failed, 2 bad input
int run(const Words& arguments, std::ostream& out, std::ostream& err);
}  // namespace cli
}  // namespace pkm_workspace
