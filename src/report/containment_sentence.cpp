// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/containment_sentence.h"

namespace pkm_workspace
{
std::string whyUndecided(const ContainmentResult& result, const Budget& budget)
{
  return result.is_within_rounding ? "the border of the set is within rounding of the region"
                                   : budget.endedBy(result.seconds, result.boxes) + " ended the proof";
}
}  // namespace pkm_workspace
