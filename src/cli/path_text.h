// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/region/path.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// The lines that a path is written in, for help texts.
extern const char* const PATH_GRAMMAR;

/// A path as text, one line for each segment; numbers in metres, separated by blanks; # begins a comment.
class PathText
{
public:
  /// Reads one line that was given by itself.
  void read(const std::string& line, Problems& problems);
  /// Reads a whole file: the one or the other.
  void readFile(const std::string& path, Problems& problems);

  const std::vector<PathSegment>& segments() const { return segments_; }
  /// Where a segment was read, and as what: "path.txt:3 (arc)".
  std::string place(std::size_t segment) const;

private:
  /// Few bytes each: a path may have millions of them.
  struct Source
  {
    std::uint32_t place;  ///< index into given_, or number of the line in the file
    std::uint8_t kind;
  };

  void readLine(const std::string& line, std::uint32_t source, const std::string& place, Problems& problems);
  void add(const std::string& kind, const std::vector<double>& numbers);

  std::vector<PathSegment> segments_;
  std::vector<Source> sources_;
  std::string file_;  ///< or empty: lines were given
  Words given_;
  Eigen::Vector3d end_ = Eigen::Vector3d::Zero();
  bool has_start_ = false;
};
}  // namespace cli
}  // namespace pkm_workspace
