// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/tolerances_sentence.h"

namespace pkm_workspace
{
std::string tolerancesSentence(const Machine& machine)
{
  const Tolerances tolerances = tolerancesOf(machine);
  if (areZero(tolerances))
    return "";
  return " This is about every machine whose numbers differ from the given ones by at most " + inWords(tolerances) +
         ": what is good is good on each of them, what is bad is bad on one of them at least, and ranges hold all of "
         "their values.";
}
}  // namespace pkm_workspace
