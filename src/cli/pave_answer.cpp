// SPDX-License-Identifier: BSD-3-Clause
#include "pave_answer.h"

#include <algorithm>
#include <ostream>

#include "output.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json bracketOf(const Paved& paved, std::size_t index)
{
  const std::string name = Measure(paved.pavings[index].box).name;
  return { { name + "_lower", paved.sizes[index].lower() }, { name + "_upper", paved.sizes[index].upper() } };
}

std::string sizeOf(const Paved& paved, std::size_t index)
{
  const Interval& size = paved.sizes[index];
  return bracket(size.lower(), size.upper()) + Measure(paved.pavings[index].box).unit;
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

Json listed(const Box& box)
{
  Json ends = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : { box.lower[axis], box.upper[axis] })
      ends.push_back(end);
  return ends;
}

/// Boxes of the levels down to one, those that are divided there taken as undecided.
std::int64_t countTo(const BoxTree& tree, std::size_t last)
{
  std::int64_t count = tree.count(CellState::SPLIT, last);
  for (std::size_t level = 0; level <= last; ++level)
    for (const CellState state : { CellState::INSIDE, CellState::BOUNDARY, CellState::PENDING })
      count += tree.count(state, level);
  return count;
}

/// The boxes of these states down to a level; those that are divided, of that level only.
std::vector<Box> boxesOf(const BoxTree& tree, const std::vector<CellState>& states, std::size_t last)
{
  std::vector<Box> all;
  for (const CellState state : states)
  {
    const auto boxes = tree.boxes(state);
    for (std::size_t level = state == CellState::SPLIT ? last : 0; level <= last && level < boxes.size(); ++level)
      all.insert(all.end(), boxes[level].begin(), boxes[level].end());
  }
  return all;
}

void writeBoxes(const BoxTree& tree, std::int64_t most, std::ostream& out)
{
  std::size_t last = 0;
  while (last + 1 < tree.levels() && countTo(tree, last + 1) <= most)
    ++last;
  const auto write = [&](const char* name, const std::vector<CellState>& states) {
    const std::vector<Box> boxes = boxesOf(tree, states, last);
    out << "\n    \"" << name << "\": ";
    writeList(
        boxes.size(), [&boxes](std::size_t k) { return listed(boxes[k]); }, 4, out);
  };
  out << '{';
  write("inside", { CellState::INSIDE });
  out << ',';
  write("undecided", { CellState::BOUNDARY, CellState::PENDING, CellState::SPLIT });
  out << "\n  }";
}

Json toJson(const Machine& machine, const Paved& paved)
{
  const std::vector<Paving>& pavings = paved.pavings;
  const Paving& whole = pavings[paved.asked];
  Json json = contextOf(whole.premises);
  json.update(bracketOf(paved, paved.asked));
  json["own_aspect"] = bracketOf(paved, pavings.size() - 2);
  json["other_aspect"] = bracketOf(paved, pavings.size() - 1);
  json["dimension"] = Measure(whole.box).dimension;
  json["resolution"] = whole.resolution;
  json["box"] = cli::toJson(whole.box);
  json["boxes"] = whole.boxes;
  json["boxes_here"] = whole.boxes_here;
  json["boxes_inside"] = whole.tree.count(CellState::INSIDE);
  json["boxes_boundary"] = whole.tree.count(CellState::BOUNDARY);
  json["boxes_pending"] = whole.tree.count(CellState::PENDING);
  json["seconds"] = secondsOf(pavings);
  json["complete"] = isComplete(pavings);
  json["ended_by"] = paved.ended_by.empty() ? Json() : Json(paved.ended_by);
  addLimits(machine, whole.premises.criterion, paved.reaches, json);
  return json;
}

std::string proofOf(const Paved& paved)
{
  const std::vector<Paving>& pavings = paved.pavings;
  const Paving& whole = pavings[paved.asked];
  const Measure measure(whole.box);
  std::string text = "Proved: the points of the box that are " + quality(whole.premises.criterion) + " have " +
                     (measure.dimension == 2 ? "an " : "a ") + measure.name + " of " + sizeOf(paved, paved.asked) + ".";
  if (paved.is_section)
    text +=
        " The rails are parallel: the box is flat, across the axis they run along, and in every plane parallel to "
        "it the area is the same.";
  if (!isComplete(pavings))
    text += " Ended early by " + paved.ended_by + ": more time, boxes or memory give closer bounds.";
  return text;
}

std::string print(const Machine& machine, const Paved& paved)
{
  const std::vector<Paving>& pavings = paved.pavings;
  const Paving& whole = pavings[paved.asked];
  const Criterion& criterion = whole.premises.criterion;
  const auto count = [&whole](CellState state) { return std::to_string(whole.tree.count(state)) + " boxes"; };
  const std::string earlier =
      whole.boxes_here == whole.boxes ? "" : " (" + std::to_string(whole.boxes_here) + " of them in this run)";
  const std::vector<Words> rows = {
    { Measure(whole.box).name, sizeOf(paved, paved.asked) },
    { "own aspect", sizeOf(paved, pavings.size() - 2) },
    { "other aspect", sizeOf(paved, pavings.size() - 1) },
    { "inside", count(CellState::INSIDE) },
    { "boundary", count(CellState::BOUNDARY) + ", undecided at the resolution" },
    { "pending", count(CellState::PENDING) + ", not looked at" },
    { "box", "from " + describe(whole.box.lower) + " to " + describe(whole.box.upper) },
    { "resolution", exact(whole.resolution) + " m" },
    { "effort", std::to_string(whole.boxes) + " boxes" + earlier + ", " + seconds(secondsOf(pavings)) },
  };
  return "Paving of the points of machine '" + machine.name() + "' that are " + quality(criterion) + "\n\n" +
         aligned(rows, Align::LEFT) + "\n" + wrapped(proofOf(paved)) + wrapped(definition(machine, criterion)) +
         wrapped(remarkOnLimits(machine, criterion, paved.reaches));
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

Answer answerOf(const Machine& machine, const Paved& paved)
{
  Answer answer{ toJson(machine, paved), print(machine, paved) };
  if (paved.most_listed > 0)
    answer.long_members["listed"] = [&paved](std::ostream& out) {
      writeBoxes(paved.pavings[paved.asked].tree, paved.most_listed, out);
    };
  return answer;
}
}  // namespace cli
}  // namespace pkm_workspace
