// SPDX-License-Identifier: BSD-3-Clause
#include "path_text.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

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

const Kind& findKind(const std::string& name)
{
  Words names;
  for (const Kind& kind : KINDS)
  {
    if (name == kind.name)
      return kind;
    names.push_back(kind.name);
  }
  throw std::invalid_argument("'" + name + "' is none of " + joined(names, ", "));
}

Words wordsOf(std::string line)
{
  line.resize(std::min(line.size(), line.find('#')));
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}
}  // namespace

const char* const PATH_GRAMMAR =
    "start X Y Z: where the path begins, or goes on after a jump; line X Y Z: straight to that point; arc VX VY VZ X Y "
    "Z: through the point V to X Y Z; turn CX CY CZ AX AY AZ X Y Z: about the axis A through C, counter-clockwise seen "
    "from its tip, to X Y Z; circle CX CY CZ AX AY AZ: all of it; helix CX CY CZ AX AY AZ ANGLE LIFT: by ANGLE in "
    "radians, while climbing LIFT along A";

void PathText::read(const std::string& line, const std::string& place, Problems& problems)
{
  const Words words = wordsOf(line);
  if (words.empty())
    return;
  try
  {
    const Kind& kind = findKind(words[0]);
    if (words.size() != kind.numbers + 1)
      throw std::invalid_argument(words[0] + " needs " + std::to_string(kind.numbers) + " numbers, got " +
                                  std::to_string(words.size() - 1));
    if (!has_start_ && words[0] != "start")
      throw std::invalid_argument("a path begins with start X Y Z");
    add(words[0], readNumbers({ words.begin() + 1, words.end() }, Quantity()));
    places_.resize(segments_.size(), place + " (" + words[0] + ")");
  }
  catch (const std::invalid_argument& reason)
  {
    std::istringstream reasons(reason.what());
    for (std::string text; std::getline(reasons, text);)
      problems.push_back(place + ": " + text);
  }
}

void PathText::readFile(const std::string& path, Problems& problems)
{
  std::ifstream file(path);
  if (!file)
    problems.push_back("the file '" + path + "' cannot be read");
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);)
    read(line, path + ":" + std::to_string(++number), problems);
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
