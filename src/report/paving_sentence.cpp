// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/paving_sentence.h"

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/set_reach.h"

namespace pkm_workspace
{
Measure::Measure(const Box& box)
{
  constexpr const char* NAMES[] = { "volume", "length", "area", "volume" };
  constexpr const char* UNITS[] = { " m^3", " m", " m^2", " m^3" };
  dimension = static_cast<int>(((box.upper - box.lower).array() > 0.0).count());
  name = NAMES[dimension];
  unit = UNITS[dimension];
}

std::string describe(const Paving& paving, const Interval& measure, const Machine& machine, const std::string& ended_by)
{
  const Measure of(paving.box);
  std::string text = "Proved: the points of the box that are " + quality(machine, paving.premises.criterion) +
                     " have " + (of.dimension == 2 ? "an " : "a ") + of.name + " of " +
                     bracket(measure.lower(), measure.upper()) + of.unit + ".";
  if (isSectionOfAll(machine, paving))
    text +=
        " The rails are parallel: the box is flat, across the axis they run along, and in every plane parallel to "
        "it the area is the same.";
  if (!ended_by.empty())
    text += " Ended early by " + ended_by + ": more time, boxes or memory give closer bounds.";
  return text;
}
}  // namespace pkm_workspace
