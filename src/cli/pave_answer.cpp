// SPDX-License-Identifier: BSD-3-Clause
#include "pave_answer.h"

#include <algorithm>
#include <ostream>

#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/paving_sentence.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json bracketOf(const PavingReport& report)
{
  const std::string name = Measure(report.paving.box).name;
  return { { name + "_lower", report.size.volume.lower() }, { name + "_upper", report.size.volume.upper() } };
}

std::string sizeOf(const PavingReport& report)
{
  return bracket(report.size.volume.lower(), report.size.volume.upper()) + Measure(report.paving.box).unit;
}

double secondsOf(const std::vector<PavingReport>& reports)
{
  double sum = 0.0;
  for (const PavingReport& report : reports)
    sum += report.seconds();
  return sum;
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

BoxLists listed(const BoxTree& tree, std::int64_t most)
{
  std::size_t last = 0;
  while (last + 1 < tree.levels() && countTo(tree, last + 1) <= most)
    ++last;
  const auto of = [&tree, last](const std::vector<CellState>& states) {
    return [&tree, last, states] { return boxesOf(tree, states, last); };
  };
  return { { "inside", of({ CellState::INSIDE }) },
           { "undecided", of({ CellState::BOUNDARY, CellState::PENDING, CellState::SPLIT }) } };
}

void addComponents(const PavingReport& report, Json& json)
{
  if (!report.components)
    return;
  const Measure measure(report.paving.box);
  json["components"] = Json::array();
  for (const Component& component : report.components->list)
    json["components"].push_back({ { measure.name + "_lower", component.volume.lower() },
                                   { "boxes", component.boxes },
                                   { "box", toJson(component.bounds) },
                                   { "point", toJson(component.point) },
                                   { "cluster", component.cluster } });
  json["clusters"] = report.components->clusters;
  json["zero_component"] = report.components->zero ? Json(*report.components->zero) : Json();
  json["components_message"] = report.components->message;
}

/// The largest ones in a table, and what is proved of all.
std::string printComponents(const PavingReport& report)
{
  if (!report.components)
    return "";
  constexpr std::size_t MOST_ROWS = 10;
  const Measure measure(report.paving.box);
  const std::vector<Component>& list = report.components->list;
  std::vector<Words> rows = { { "component", "cluster", measure.name + " at least", "boxes", "point in it" } };
  for (std::size_t k = 0; k < std::min(MOST_ROWS, list.size()); ++k)
    rows.push_back({ std::to_string(k + 1), std::to_string(list[k].cluster + 1),
                     significantBelow(list[k].volume.lower(), 6) + measure.unit, std::to_string(list[k].boxes),
                     describe(list[k].point) });
  if (list.size() > MOST_ROWS)
    rows.push_back({ "...", "", "", "", std::to_string(list.size() - MOST_ROWS) + " smaller ones" });
  return aligned(rows, Align::LEFT) + "\n" + wrapped(report.components->message);
}

Json pavedJson(const Machine& machine, const Paved& paved)
{
  const std::vector<PavingReport>& reports = paved.reports;
  const PavingReport& asked = reports[paved.asked];
  const Paving& whole = asked.paving;
  Json json = contextOf(whole.premises);
  json.update(bracketOf(asked));
  json["own_aspect"] = bracketOf(reports[reports.size() - 2]);
  json["other_aspect"] = bracketOf(reports.back());
  const Measure measure(whole.box);
  json[measure.name + "_inside"] = whole.volume_inside.lower();
  json[measure.name + "_boundary"] = whole.volume_boundary.upper();
  json[measure.name + "_boxes"] = asked.size.boxes;
  json["dimension"] = measure.dimension;
  json["resolution"] = whole.resolution;
  json["box"] = toJson(whole.box);
  json["boxes"] = whole.boxes;
  json["boxes_here"] = whole.boxes_here;
  json["boxes_inside"] = whole.tree.count(CellState::INSIDE);
  json["boxes_boundary"] = whole.tree.count(CellState::BOUNDARY);
  json["boxes_pending"] = whole.tree.count(CellState::PENDING);
  json["seconds"] = secondsOf(reports);
  json["complete"] = asked.complete();
  json["ended_by"] = asked.ended_by.empty() ? Json() : Json(asked.ended_by);
  addLimits(machine, whole.premises.criterion, asked.reaches, json);
  addComponents(asked, json);
  paved.mesh.addTo(json);
  json["message"] = asked.message(machine);
  return json;
}

std::string print(const Machine& machine, const Paved& paved)
{
  const std::vector<PavingReport>& reports = paved.reports;
  const PavingReport& asked = reports[paved.asked];
  const Paving& whole = asked.paving;
  const Criterion& criterion = whole.premises.criterion;
  const Measure measure(whole.box);
  const auto count = [&whole](CellState state) { return std::to_string(whole.tree.count(state)) + " boxes"; };
  const std::string inside = ", " + significantBelow(whole.volume_inside.lower(), 6) + measure.unit;
  const std::string boundary = ", " + significantAbove(whole.volume_boundary.upper(), 6) + measure.unit;
  const std::string earlier =
      whole.boxes_here == whole.boxes ? "" : " (" + std::to_string(whole.boxes_here) + " of them in this run)";
  std::vector<Words> rows = {
    { measure.name, sizeOf(asked) },
    { "own aspect", sizeOf(reports[reports.size() - 2]) },
    { "other aspect", sizeOf(reports.back()) },
    { "inside", count(CellState::INSIDE) + inside },
    { "boundary", count(CellState::BOUNDARY) + boundary + ", undecided at the resolution" },
    { "pending", count(CellState::PENDING) + ", not looked at" },
    { "box", "from " + describe(whole.box.lower) + " to " + describe(whole.box.upper) },
    { "resolution", exact(whole.resolution) + " m" },
    { "effort", std::to_string(whole.boxes) + " boxes" + earlier + ", " + std::to_string(asked.size.boxes) +
                    " for the " + measure.name + ", " + seconds(secondsOf(reports)) },
  };
  for (const Words& row : paved.mesh.rows())
    rows.push_back(row);
  return "Paving of the points of machine '" + machine.name() + "' that are " + quality(criterion) + "\n\n" +
         aligned(rows, Align::LEFT) + "\n" + wrapped(asked.message(machine)) + printComponents(asked) +
         wrapped(definition(machine, criterion));
}
}  // namespace

Answer answerOf(const Machine& machine, const Paved& paved)
{
  Answer answer{ pavedJson(machine, paved), Text([&] { return print(machine, paved); }) };
  if (paved.most_listed > 0)
    answer.long_members["listed"] = listed(paved.reports[paved.asked].paving.tree, paved.most_listed);
  return answer;
}
}  // namespace cli
}  // namespace pkm_workspace
