// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "command.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/tolerate_sentence.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json subjectOf(const Premises& premises)
{
  Json json = { { "machine", premises.machine },
                { "geometry_hash", premises.geometry_hash },
                { "version", premises.version } };
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    if (const std::vector<double> numbers = numbersOf(kind, premises.tolerances); numbers != std::vector<double>{ 0.0 })
      json["tolerances"][kind.name] = numbers;
  return json;
}
}  // namespace

void writeOutput(const std::string& path, const std::string& text)
{
  try
  {
    writeWholeFile(path, text);
  }
  catch (const std::invalid_argument& reason)
  {
    throw Failure(std::string("--output ") + reason.what());
  }
}

std::string wroteMachine(const Machine& machine, const std::string& path)
{
  return "Wrote machine '" + machine.name() + "' to " + path + "\nAsk:  pkm largest --urdf " + path +
         " --psi auto\nLook: roslaunch pkm_workspace machine.launch psi:=auto urdf:=$(realpath " + path + ")\n";
}

Json contextOf(const Machine& machine)
{
  return subjectOf(premisesOf(machine, Criterion()));
}

Json contextOf(const Premises& premises)
{
  Json json = subjectOf(premises);
  json.update(toJson(premises.criterion));
  for (const Eigen::Vector3d& axis : premises.ball_axes)
    json["ball_axes"].push_back(toJson(axis));
  return json;
}

Json contextOf(const Machine& machine, const Criterion& criterion)
{
  return contextOf(premisesOf(machine, criterion));
}

Json toJson(const Eigen::Vector3d& v)
{
  return { v.x(), v.y(), v.z() };
}

Json toJson(const Box& box)
{
  return { { "lower", toJson(box.lower) }, { "upper", toJson(box.upper) } };
}

Json finite(double value)
{
  return std::isfinite(value) ? Json(value) : Json();
}

Json toJson(const Interval& interval)
{
  return interval.isEmpty() ? Json() : Json::array({ finite(interval.lower()), finite(interval.upper()) });
}

Json toJson(const std::array<Interval, 3>& intervals)
{
  return Json::array({ toJson(intervals[0]), toJson(intervals[1]), toJson(intervals[2]) });
}

Json toJson(const Machine& machine, const Limit& limit)
{
  const auto middle = [](const Interval& x) { return x.isBounded() ? Json(x.mid()) : Json(); };
  return { { "limit", pkm_workspace::name(limit.kind) },
           { "joint", limit.leg < 0 ? Json() : Json(machine.leg(limit.leg).joint) },
           { "value", middle(limit.value) },
           { "bound", limit.bound },
           { "margin", middle(limit.margin) } };
}

Json toJson(BoxVerdict verdict)
{
  return verdict == BoxVerdict::UNDECIDED ? Json() : Json(verdict == BoxVerdict::INSIDE);
}

std::string name(LargestRegion::Status status)
{
  switch (status)
  {
    case LargestRegion::Status::PROVEN:
      return "proven";
    case LargestRegion::Status::STOPPED:
      return "stopped";
    case LargestRegion::Status::NONE:
      return "none";
  }
  throw std::logic_error("a status without a name");
}

Json toJson(const Machine& machine, const std::array<JointRange, 3>& ranges)
{
  Json json = Json::array();
  for (std::size_t i = 0; i < 3; ++i)
    json.push_back({ { "joint", machine.leg(static_cast<int>(i)).joint },
                     { "unit", unitOf(machine.legs()[i]) },
                     { "lower", ranges[i].lower.lower() },
                     { "upper", ranges[i].upper.upper() },
                     { "stroke", ranges[i].stroke.upper() },
                     { "across", ranges[i].across.upper() },
                     { "enclosures",
                       { { "lower", toJson(ranges[i].lower) },
                         { "upper", toJson(ranges[i].upper) },
                         { "stroke", toJson(ranges[i].stroke) },
                         { "across", toJson(ranges[i].across) } } } });
  return json;
}

Json toJson(const Machine& machine, const std::vector<BeyondLimit>& beyond)
{
  Json json = Json::array();
  for (const BeyondLimit& one : beyond)
    json.push_back({ { "joint", machine.leg(one.leg).joint },
                     { "limit", one.is_upper ? "upper" : "lower" },
                     { "by", toJson(one.by) } });
  return json;
}

void addLimits(const Machine& machine, const Criterion& criterion, const std::optional<JointReaches>& reaches,
               Json& json)
{
  if (!within(machine, criterion).joint_limits)
    json["beyond_limits"] = toJson(machine, beyondLimits(machine, reaches));
}

void addVertices(const Shape& shape, double size, Json& json)
{
  if (!shape.isPolytope())
    return;
  json["size"] = size;
  for (const GrowingVector& vertex : shape.extremePoints())
    json["vertices"].push_back(toJson(vertex.per_size));
}

bool isSolid(const Shape& shape)
{
  return (shape.halfExtents().at(1.0).array() > 0.0).all();
}

std::string name(Containment verdict)
{
  return verdict == Containment::INSIDE ? "inside" : verdict == Containment::OUTSIDE ? "outside" : "undecided";
}

std::string seconds(double value)
{
  return nearly(value, 3) + " s";
}

std::string describe(const Eigen::Vector3d& v)
{
  return "(" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + ") m";
}

void writeList(std::size_t count, const std::function<Json(std::size_t)>& entry, int indent, std::ostream& out)
{
  std::size_t k = 0;
  writeList([&] { return k < count; }, [&] { return entry(k++); }, indent, out);
}

void writeList(const std::function<bool()>& goes_on, const std::function<Json()>& next, int indent, std::ostream& out)
{
  const std::string begin = "\n" + std::string(static_cast<std::size_t>(indent), ' ');
  bool is_empty = true;
  out << '[';
  for (; goes_on(); is_empty = false)
    out << (is_empty ? "" : ",") << begin << "  " << next().dump();
  out << (is_empty ? "" : begin) << ']';
}

std::string wrapped(const std::string& text)
{
  constexpr std::size_t COLUMNS = 100;
  if (text.empty())
    return "";
  std::string lines;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size() + 1)
  {
    const bool next_line = column + word.size() > COLUMNS;
    lines += (column == 0 ? "" : next_line ? "\n" : " ") + word;
    column = next_line ? 0 : column;
  }
  return lines + "\n";
}

std::string aligned(const std::vector<Words>& rows, Align align)
{
  std::vector<std::size_t> widths;
  for (const Words& row : rows)
  {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Words& row : rows)
  {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const std::string blanks(widths[i] - row[i].size(), ' ');
      line += " " + (i > 0 && align == Align::RIGHT ? " " + blanks + row[i] : row[i] + blanks + " ");
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Json differencesJson(const Machine& built, const Machine& meant)
{
  Json json = Json::array();
  const std::vector<std::string> words = differencesInWords(built, meant);
  for (const LegDifference& leg : differences(built, meant))
    json.push_back({ { "joint", leg.joint },
                     { "slider", toJson(leg.slider) },
                     { "platform", toJson(leg.platform) },
                     { "length", leg.length },
                     { "direction", leg.angle },
                     { "axis", toJson(leg.axis) },
                     { "zero", leg.zero },
                     { "text", words[json.size()] } });
  return json;
}
}  // namespace cli
}  // namespace pkm_workspace
