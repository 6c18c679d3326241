// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "condition_color.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/paving/set_end.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
/// What a part of a set's surface is painted with: 1 + the condition that ends the set there, or 0.
using SetPaint = std::uint8_t;
constexpr SetPaint NO_END = 0;

constexpr Color SET_INSIDE = { 0.15F, 0.85F, 0.30F, 0.20F };
constexpr Color SET_BOUNDARY = { 1.0F, 0.70F, 0.0F, 0.14F };
/// How much less is seen through colours that are to be told apart than through one all over.
constexpr float DENSER = 2.0F;

inline SetPaint paintOf(const std::optional<SetEnd>& end)
{
  return end ? static_cast<SetPaint>(1 + static_cast<int>(end->kind)) : NO_END;
}

inline Color densely(Color color, float density)
{
  color.a *= density;
  return color;
}

/// @param verdict colour of what nothing ends @param shade that all but its alpha is multiplied by
inline Color colorOf(SetPaint paint, const Color& verdict, float shade)
{
  const Color color = paint == NO_END ? verdict : conditionColor(static_cast<ConditionKind>(paint - 1));
  return { shade * color.r, shade * color.g, shade * color.b, verdict.a };
}

inline Legend legendOf(const std::set<SetPaint>& paints, const Criterion& criterion)
{
  Legend legend;
  for (const SetPaint paint : paints)
    if (const auto kind = static_cast<ConditionKind>(paint - 1); paint != NO_END)
      legend.push_back({ conditionColor(kind), briefly(kind, criterion) });
  return legend;
}
}  // namespace pkm_workspace
