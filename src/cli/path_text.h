// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
namespace cli
{
/// The lines that a path is written in, for help texts.
extern const char* const PATH_GRAMMAR;

/// A path as text, one line for each segment; numbers in metres, separated by blanks or commas, # begins a comment.
class PathText
{
public:
  /// Reads one line. @param place of the line, for problems
  void read(const std::string& line, const std::string& place, Problems& problems);
  /// Reads a whole file.
  void readFile(const std::string& path, Problems& problems);

  const std::vector<PathSegment>& segments() const { return segments_; }
  /// Where each segment was read, and as what: "path.txt:3 (arc)".
  const std::vector<std::string>& places() const { return places_; }

private:
  void add(const std::string& kind, const std::vector<double>& numbers);

  std::vector<PathSegment> segments_;
  std::vector<std::string> places_;
  Eigen::Vector3d end_ = Eigen::Vector3d::Zero();
  bool has_start_ = false;
};
}  // namespace cli
}  // namespace pkm_workspace
