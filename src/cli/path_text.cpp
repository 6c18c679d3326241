// SPDX-License-Identifier: BSD-3-Clause
#include "path_text.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
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
enum  // as KINDS
{
  START,
  LINE,
  ARC,
  TURN,
  CIRCLE,
  HELIX
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
    const std::vector<double> read = readNumbers({ words.begin() + 1, words.end() }, Quantity());
    Numbers numbers{};
    std::copy(read.begin(), read.end(), numbers.begin());
    has_start_ = true;
    if (!pen_.draw(kind, numbers))
      start_ = numbers;
    else
    {
      sources_.push_back({ source, static_cast<std::uint8_t>(kind), start_.has_value() });
      if (start_)
        keep(START, *start_);
      start_.reset();
      keep(kind, numbers);
    }
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

void PathText::keep(std::size_t kind, const Numbers& numbers)
{
  numbers_.insert(numbers_.end(), numbers.begin(), numbers.begin() + KINDS[kind].numbers);
}

void PathText::handOver(const std::function<void(const PathSegment&)>& take)
{
  const auto next = [this](std::size_t kind) {
    Numbers numbers{};
    std::copy_n(numbers_.begin(), KINDS[kind].numbers, numbers.begin());
    numbers_.erase(numbers_.begin(), numbers_.begin() + static_cast<std::ptrdiff_t>(KINDS[kind].numbers));
    return numbers;
  };
  Pen pen;
  for (const Source& source : sources_)
  {
    if (source.is_after_start)
      pen.draw(START, next(START));
    take(*pen.draw(source.kind, next(source.kind)));
  }
}

std::optional<PathSegment> PathText::Pen::draw(std::size_t kind, const Numbers& numbers)
{
  const auto vector = [&](std::size_t k) { return Eigen::Vector3d(numbers[k], numbers[k + 1], numbers[k + 2]); };
  const Eigen::Vector3d start = end_;
  if (kind == HELIX)
  {
    const PathSegment helix = PathSegment::arc(start, vector(0), vector(3), numbers[6], numbers[7]);
    end_ = helix.point(1.0);
    return helix;
  }
  if (kind == CIRCLE)
    return PathSegment::circle(start, vector(0), vector(3));
  end_ = vector(KINDS[kind].numbers - 3);
  if (kind == LINE)
    return PathSegment::line(start, end_);
  if (kind == ARC)
    return PathSegment::arcThrough(start, vector(0), end_);
  if (kind == TURN)
    return PathSegment::arcTo(start, vector(0), vector(3), end_);
  return std::nullopt;
}
}  // namespace cli
}  // namespace pkm_workspace
