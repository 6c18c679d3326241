// SPDX-License-Identifier: BSD-3-Clause
#include "pave_answer.h"

#include <algorithm>

#include "output.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json bracketOf(const Paving& paving)
{
  const std::string name = Measure(paving.box).name;
  return { { name + "_lower", paving.volumeLower() }, { name + "_upper", paving.volumeUpper() } };
}

std::string sizeOf(const Paving& paving)
{
  return bracket(paving.volumeLower(), paving.volumeUpper()) + Measure(paving.box).unit;
}

bool isComplete(const std::vector<Paving>& pavings)
{
  return std::all_of(pavings.begin(), pavings.end(), [](const Paving& paving) { return paving.complete; });
}

double secondsOf(const std::vector<Paving>& pavings)
{
  double sum = 0.0;
  for (const Paving& paving : pavings)
    sum += paving.seconds;
  return sum;
}

Json toJson(const Machine& machine, const std::vector<Paving>& pavings)
{
  const Paving& whole = pavings.front();
  Json json = contextOf(machine, whole.criterion);
  json.update(bracketOf(whole));
  json["own_aspect"] = bracketOf(*(pavings.end() - 2));
  json["other_aspect"] = bracketOf(pavings.back());
  json["dimension"] = Measure(whole.box).dimension;
  json["set"] = name(whole.criterion.set);
  json["resolution"] = whole.resolution;
  json["box"] = cli::toJson(whole.box);
  json["boxes"] = whole.boxes;
  json["boxes_here"] = whole.boxes_here;
  json["boxes_inside"] = whole.tree.count(CellState::INSIDE);
  json["boxes_boundary"] = whole.tree.count(CellState::BOUNDARY);
  json["boxes_pending"] = whole.tree.count(CellState::PENDING);
  json["seconds"] = secondsOf(pavings);
  json["complete"] = isComplete(pavings);
  return json;
}

std::string proofOf(const std::vector<Paving>& pavings, bool is_section)
{
  const Paving& whole = pavings.front();
  const Measure measure(whole.box);
  std::string text = "Proved: the " + name(whole.criterion.set) + " points of the box have " +
                     (measure.dimension == 2 ? "an " : "a ") + measure.name + " of " + sizeOf(whole) + ".";
  if (is_section)
    text +=
        " The rails are parallel: the box is flat, across the axis they run along, and in every plane parallel to "
        "it the area is the same.";
  if (!isComplete(pavings))
    text += " A budget or a signal ended it early: more time, boxes or memory give closer bounds.";
  return text;
}

std::string print(const Machine& machine, const std::vector<Paving>& pavings, bool is_section)
{
  const Paving& whole = pavings.front();
  const auto count = [&whole](CellState state) { return std::to_string(whole.tree.count(state)) + " boxes"; };
  const std::string earlier =
      whole.boxes_here == whole.boxes ? "" : " (" + std::to_string(whole.boxes_here) + " of them in this run)";
  const std::vector<Words> rows = {
    { Measure(whole.box).name, sizeOf(whole) },
    { "own aspect", sizeOf(*(pavings.end() - 2)) },
    { "other aspect", sizeOf(pavings.back()) },
    { "inside", count(CellState::INSIDE) },
    { "boundary", count(CellState::BOUNDARY) + ", undecided at the resolution" },
    { "pending", count(CellState::PENDING) + ", not looked at" },
    { "box", "from " + describe(whole.box.lower) + " to " + describe(whole.box.upper) },
    { "resolution", exact(whole.resolution) + " m" },
    { "effort", std::to_string(whole.boxes) + " boxes" + earlier + ", " + seconds(secondsOf(pavings)) },
  };
  return "Paving of the " + name(whole.criterion.set) + " set of machine '" + machine.name() + "'\n\n" +
         aligned(rows, Align::LEFT) + "\n" + wrapped(proofOf(pavings, is_section)) +
         wrapped(definition(whole.criterion));
}
}  // namespace

Measure::Measure(const Box& box)
{
  constexpr const char* NAMES[] = { "volume", "length", "area", "volume" };
  constexpr const char* UNITS[] = { " m^3", " m", " m^2", " m^3" };
  dimension = static_cast<int>(((box.upper - box.lower).array() > 0.0).count());
  name = NAMES[dimension];
  unit = UNITS[dimension];
}

Answer answerOf(const Machine& machine, const std::vector<Paving>& pavings, bool is_section)
{
  return { toJson(machine, pavings), print(machine, pavings, is_section) };
}
}  // namespace cli
}  // namespace pkm_workspace
