// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/region/path.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// The lines that a path is written in, for help texts.
extern const char* const PATH_GRAMMAR;

/// A path as text, one line for each segment; numbers in metres, separated by blanks; # begins a comment. Keeps the
/// numbers of each line, not its segment, which is many times as large.
class PathText
{
public:
  /// Reads one line that was given by itself.
  void read(const std::string& line, Problems& problems);
  /// Reads a whole file: the one or the other.
  void readFile(const std::string& path, Problems& problems);

  /// How many segments were read.
  std::size_t size() const { return sources_.size(); }
  /// Hands over all segments in their order. For one call: each is forgotten then, but for its place.
  void handOver(const std::function<void(const PathSegment&)>& take);
  /// Where a segment was read, and as what: "path.txt:3 (arc)".
  std::string place(std::size_t segment) const;

private:
  using Numbers = std::array<double, 9>;  ///< at most

  /// Makes each segment where the one before it ended.
  class Pen
  {
  public:
    /// Nothing of a start. @throws std::invalid_argument for numbers that make no segment
    std::optional<PathSegment> draw(std::size_t kind, const Numbers& numbers);

  private:
    Eigen::Vector3d end_ = Eigen::Vector3d::Zero();
  };

  /// Few bytes each: a path may have millions of them.
  struct Source
  {
    std::uint32_t place;  ///< index into given_, or number of the line in the file
    std::uint8_t kind;
    bool is_after_start;  ///< whose numbers come before its own
  };

  void readLine(const std::string& line, std::uint32_t source, const std::string& place, Problems& problems);
  void keep(std::size_t kind, const Numbers& numbers);

  std::deque<double> numbers_;  ///< of all segments that are not handed over
  std::deque<Source> sources_;
  std::string file_;  ///< or empty: lines were given
  Words given_;
  Pen pen_;
  std::optional<Numbers> start_;  ///< that no segment has followed
  bool has_start_ = false;
};
}  // namespace cli
}  // namespace pkm_workspace
