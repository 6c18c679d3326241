// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>

#include "pkm_workspace/common/budget.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/region/local_search.h"

namespace pkm_workspace
{
/// The largest region that a search has proved so far.
class Incumbent
{
public:
  /// Keeps references. @param known the size that regions have to exceed, proved or not
  /// @param most boxes that all proofs together may take; 0 = no limit
  Incumbent(const Machine& machine, const BoxTest& test, const RegionQuery& query, const RunningBudget& budget,
            double known, std::int64_t most);

  const Candidate& candidate() const { return candidate_; }
  double size() const { return candidate_.size; }
  bool isFound() const { return found_; }        ///< whether it is more than what was known
  std::int64_t boxes() const { return boxes_; }  ///< that proofs took

  /// Whether a region of this size would be looked at.
  bool asksFor(double size) const;
  /// Takes the region if it is larger and proved. @return with a bad point if one stands in the way; where regions may
  /// be turned, as seen from its center and along its axes
  ContainmentResult certify(const Candidate& region);

private:
  void certifyLess(const Candidate& region);
  std::int64_t allowedBoxes(double size) const;
  ContainmentResult check(const Candidate& region, const Budget& budget) const;
  ContainmentResult checkTurned(const Candidate& region, const Budget& budget) const;

  const Machine& machine_;
  const BoxTest& test_;
  const RegionQuery& query_;
  const RunningBudget& budget_;
  std::int64_t most_;
  Candidate candidate_;
  bool found_ = false;
  double given_up_ = std::numeric_limits<double>::infinity();  ///< the least size whose proof took too many boxes
  std::int64_t boxes_ = 0;
};
}  // namespace pkm_workspace
