// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/conditioning_sentence.h"

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
std::string describe(const GlobalConditioning& found, const Budget& budget)
{
  const std::string remark = remarkOn(found, budget);
  return "Proved: the global conditioning index is from " + bracket(found.index.lower(), found.index.upper()) +
         (found.complete ? ", to the accuracy asked for." : ".") + (remark.empty() ? "" : " " + remark);
}
}  // namespace pkm_workspace
