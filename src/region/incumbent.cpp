// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/incumbent.h"

#include <algorithm>
#include <limits>

namespace pkm_workspace
{
namespace
{
/// Boxes that one region may take to be proved, and the share of all that are allowed.
constexpr std::int64_t VERIFICATION_BOXES = 20000;
constexpr std::int64_t VERIFICATIONS = 16;
}  // namespace

Incumbent::Incumbent(const BoxTest& test, const RegionQuery& query, const RunningBudget& budget, double known,
                     std::int64_t most)
  : test_(test), query_(query), budget_(budget), most_(most > 0 ? most : std::numeric_limits<std::int64_t>::max())
{
  candidate_.size = known;
}

bool Incumbent::asksFor(double size) const
{
  return size > candidate_.size && boxes_ < most_ && !budget_.isOver();
}

ContainmentResult Incumbent::certify(const Candidate& region)
{
  if (!asksFor(region.size))
    return {};
  Budget budget = budget_.rest();
  budget.max_boxes = std::min(VERIFICATION_BOXES, most_ / VERIFICATIONS + 1);
  const ContainmentResult proof = checkContainment(test_, *query_.shape, region.center, region.size, budget);
  boxes_ += proof.boxes;
  if (proof.verdict == Containment::INSIDE)
  {
    candidate_ = region;
    found_ = true;
  }
  return proof;
}
}  // namespace pkm_workspace
