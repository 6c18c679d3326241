// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace pkm_workspace
{
/// The first byte that is part of no character of UTF-8 that XML allows; nothing where there is none.
std::optional<int> unprintableByte(const std::string& text);
}  // namespace pkm_workspace
