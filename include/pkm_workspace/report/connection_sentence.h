// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/paving/components.h"
#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Which part of a set is spoken of: "the set", or "the part of the set in the box".
std::string partOfSet(bool is_whole);

/// Says into how many components a set is proved to fall, and which of them holds the zero configuration.
/// @param zero what is known of its tool point @param at the component that it is proved to be in
std::string describe(const Components& components, bool is_whole, BoxVerdict zero, std::optional<std::size_t> at);

/// That a path of so many lines joins two points.
std::string connectedSentence(std::size_t lines, const Machine& machine, const Criterion& criterion);
/// That none does.
std::string apartSentence(bool is_whole, const Machine& machine, const Criterion& criterion);
/// That it is not known, and what may settle it. @param ended_by empty where the resolution was the end
std::string openSentence(double resolution, const std::string& ended_by);
}  // namespace pkm_workspace
