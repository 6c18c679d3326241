// SPDX-License-Identifier: BSD-3-Clause
#include "path_text.h"

#include <stdexcept>

#include "pkm_workspace/whole_file.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// A kind of line, and how many numbers follow its name.
struct Kind
{
  const char* name;
  std::size_t numbers;
};
constexpr Kind KINDS[] = {
  { "start", 3 }, { "line", 3 }, { "arc", 6 }, { "turn", 9 }, { "circle", 6 }, { "helix", 8 }
};

std::size_t findKind(const std::string& name)
{
  Words names;
  for (const Kind& kind : KINDS)
  {
    if (name == kind.name)
      return names.size();
    names.push_back(kind.name);
  }
  throw std::invalid_argument(quoted(name) + " is none of " + joined(names, ", "));
}

std::string placeOf(const std::string& given)
{
  return "line " + quoted(given);
}

std::string placeIn(const std::string& file, std::size_t line)
{
  return file + ":" + std::to_string(line);
}
}  // namespace

const char* const PATH_GRAMMAR =
    "start X Y Z: where the path begins, or goes on after a jump; line X Y Z: straight to that point; arc VX VY VZ X Y "
    "Z: through the point V to X Y Z; turn CX CY CZ AX AY AZ X Y Z: about the axis A through C, counter-clockwise seen "
    "from its tip, to X Y Z; circle CX CY CZ AX AY AZ: all of it; helix CX CY CZ AX AY AZ ANGLE LIFT: by ANGLE in "
    "radians, while climbing LIFT along A";

void PathText::readLine(const std::string& line, std::uint32_t source, const std::string& place, Problems& problems)
{
  const Words words = wordsOf(line);
  if (words.empty())
    return;
  try
  {
    const std::size_t kind = findKind(words[0]);
    if (words.size() != KINDS[kind].numbers + 1)
      throw std::invalid_argument(words[0] + " needs " + std::to_string(KINDS[kind].numbers) + " numbers, got " +
                                  std::to_string(words.size() - 1));
    if (!has_start_ && words[0] != "start")
      throw std::invalid_argument("a path begins with start X Y Z");
    add(words[0], readNumbers({ words.begin() + 1, words.end() }, Quantity()));
    sources_.resize(segments_.size(), { source, static_cast<std::uint8_t>(kind) });
  }
  catch (const std::invalid_argument& reason)
  {
    for (const std::string& text : linesOf(reason.what()))
      problems.push_back(place + ": " + text);
  }
}

void PathText::read(const std::string& line, Problems& problems)
{
  given_.push_back(line);
  readLine(line, static_cast<std::uint32_t>(given_.size() - 1), placeOf(line), problems);
}

void PathText::readFile(const std::string& path, Problems& problems)
{
  constexpr std::size_t MOST_PROBLEMS = 100;
  file_ = path;
  try
  {
    readLines(path, [&](const std::string& line, std::size_t number) {
      const std::string place = placeIn(path, number);
      if (problems.size() >= MOST_PROBLEMS)
        throw std::invalid_argument(place + ": from here on, nothing was read");
      readLine(line, static_cast<std::uint32_t>(number), place, problems);
    });
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(reason.what());
  }
}

std::string PathText::place(std::size_t segment) const
{
  const Source& source = sources_[segment];
  return (file_.empty() ? placeOf(given_[source.place]) : placeIn(file_, source.place)) + " (" +
         KINDS[source.kind].name + ")";
}

void PathText::add(const std::string& kind, const std::vector<double>& numbers)
{
  const auto vector = [&](std::size_t k) { return Eigen::Vector3d(numbers[k], numbers[k + 1], numbers[k + 2]); };
  const Eigen::Vector3d start = end_;
  has_start_ = true;
  if (kind == "helix")
  {
    segments_.push_back(PathSegment::arc(start, vector(0), vector(3), numbers[6], numbers[7]));
    end_ = segments_.back().point(1.0);
  }
  else if (kind == "circle")
    segments_.push_back(PathSegment::circle(start, vector(0), vector(3)));
  else
  {
    end_ = vector(numbers.size() - 3);
    if (kind == "line")
      segments_.push_back(PathSegment::line(start, end_));
    else if (kind == "arc")
      segments_.push_back(PathSegment::arcThrough(start, vector(0), end_));
    else if (kind == "turn")
      segments_.push_back(PathSegment::arcTo(start, vector(0), vector(3), end_));
  }
}
}  // namespace cli
}  // namespace pkm_workspace
