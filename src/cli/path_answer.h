// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "output.h"
#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
namespace cli
{
/// A SegmentCheck in few bytes, but for its rates: a path may have millions of them.
class KeptCheck
{
public:
  explicit KeptCheck(const SegmentCheck& check);

  SegmentCheck check() const;

private:
  struct Open
  {
    Containment verdict;
    double good_until;
    std::optional<double> bad_at;
  };
  std::variant<PathMotion, Open> found_;
};

Json motionJson(const PathMotion& motion);
Json segmentJson(const SegmentCheck& check, const std::string& place);
/// The accelerations, and the feed with the joint and the limit that bind; null for what has no bound.
Json ratesJson(const PathRates& rates, const Machine& machine);
/// Three limits, null where there is none.
Json limitsJson(const std::array<double, 3>& limits);

// Rows of a table. The factors are those of the machine, the rest is told leg by leg.
void addMotion(const PathMotion& motion, const Machine& machine, std::vector<Words>& rows);
void addRates(const PathRates& rates, const Machine& machine, std::vector<Words>& rows);
/// The largest feed of each segment, or of the slowest ones where there are many; nothing of a single one.
std::string feedTable(const std::deque<PathRates>& rates, const std::function<std::string(std::size_t)>& place,
                      const Machine& machine);
}  // namespace cli
}  // namespace pkm_workspace
