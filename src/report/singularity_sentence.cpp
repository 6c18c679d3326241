// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/singularity_sentence.h"

namespace pkm_workspace
{
namespace
{
using Status = SingularityAnswer::Status;

/// Appends a kind to "serial singularities of 'rail_x', 'rail_y', parallel singularities".
/// @param joint of the leg; empty for parallel ones, which come last
void append(const std::string& joint, std::string& kinds)
{
  const std::string before = kinds.empty() ? "" : ", ";
  if (joint.empty())
    kinds += before + "parallel singularities";
  else
    kinds += (kinds.empty() ? "serial singularities of '" : ", '") + joint + "'";
}

std::string whyUndecided(const SingularityAnswer& answer, double seconds, const Budget& budget)
{
  const std::string ended_by = budget.endedBy(seconds, answer.boxes, answer.out_of_memory);
  return ended_by.empty() ? "doubles cannot divide boxes further" : ended_by + " ended the search";
}
}  // namespace

std::string describe(const Singularities& found, const Machine& machine, const Budget& budget)
{
  std::string there, open, reason;
  const auto sort = [&](const SingularityAnswer& answer, const std::string& joint) {
    if (answer.status == Status::PROVED)
      append(joint, there);
    if (answer.status != Status::UNDECIDED)
      return;
    append(joint, open);
    if (reason.empty())
      reason = whyUndecided(answer, found.seconds, budget);
  };
  for (int i = 0; i < 3; ++i)
    sort(found.serial[static_cast<std::size_t>(i)], machine.leg(i).joint);
  sort(found.parallel, "");
  if (there.empty() && open.empty())
    return "Proved: no point that counts is singular.";
  return (open.empty() ? "" : "Undecided: " + open + ", where " + reason + ". ") + "Proved: there are " +
         (there.empty() ? "" : there + ", and ") + "no others.";
}
}  // namespace pkm_workspace
