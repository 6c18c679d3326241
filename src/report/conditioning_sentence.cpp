// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/conditioning_sentence.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
std::string describe(const GlobalConditioning& found, const Budget& budget)
{
  const std::string ended_by = budget.endedBy(found.seconds, found.boxes, found.out_of_memory);
  if (!found.complete && found.index.lower() == 0.0 && found.index.upper() == 1.0)
    return "Nothing is proved of the global conditioning index: " +
           (ended_by.empty() ? "the set has no proved volume." : ended_by + " ended the computation.");
  const std::string proof =
      "Proved: the global conditioning index is from " + bracket(found.index.lower(), found.index.upper());
  if (!found.complete)
    return proof + ". The accuracy was not met: " +
           (ended_by.empty() ? "doubles do not tell it more closely." : ended_by + " ended it.");
  return proof + ", to the accuracy asked for." +
         (found.index.upper() == 0.0 ? " The struts reach no point of it, where the index is taken for 0." : "");
}
}  // namespace pkm_workspace
