// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pkm_workspace
{
struct Color
{
  float r, g, b, a;
};

/// What a colour of a picture stands for.
struct LegendRow
{
  Color color;
  std::string text;
};
using Legend = std::vector<LegendRow>;
}  // namespace pkm_workspace
