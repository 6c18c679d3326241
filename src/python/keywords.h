// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "options.h"

namespace pkm_workspace
{
namespace python
{
/// "psi-min" of "psi_min"; "from" of "from_", which Python keeps for itself.
std::string optionOf(std::string keyword);
/// A text of the command with its options as keywords: "psi_min" of "--psi-min".
std::string withKeywords(const std::string& text);

/// What keyword arguments give to the options of a command. None counts as not given, as False of a flag; numbers,
/// texts, paths, numpy arrays and nested sequences become the words that a user would type.
/// @throws std::invalid_argument with everything that is no value of an option
std::vector<cli::Options::Given> givenBy(const pybind11::dict& keywords, const cli::Options& options);
}  // namespace python
}  // namespace pkm_workspace
