// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/guarantee.h"

#include <algorithm>

#include "pkm_workspace/report/guarantee_sentence.h"

namespace pkm_workspace
{
std::vector<std::string> GuaranteeTask::names()
{
  std::vector<std::string> names;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.is_optional)
      names.push_back(bound.name);
  return names;
}

std::vector<const CriterionBound*> GuaranteeTask::bounds(const Machine& machine, std::vector<std::string>& left_out,
                                                         Problems& problems) const
{
  const std::vector<std::string> known = names();
  for (const std::string& name : quantities)
    if (std::find(known.begin(), known.end(), name) == known.end())
    {
      std::string all;
      for (const std::string& other : known)
        all += (all.empty() ? "" : ", ") + other;
      complain(problems, "quantity '", name, "' is none; these are: ", all);
    }
  std::vector<const CriterionBound*> chosen;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    const bool is_named = std::find(quantities.begin(), quantities.end(), bound.name) != quantities.end();
    Problems missing;
    if (!bound.is_optional || (!quantities.empty() && !is_named))
      continue;
    if (canBeGuaranteed(machine, query.criterion, bound, missing))
      chosen.push_back(&bound);
    else if (is_named)
      problems.insert(problems.end(), missing.begin(), missing.end());
    else
      left_out.push_back("left out: " + missing.front());
  }
  return chosen;
}

GuaranteeReport guaranteed(const Machine& machine, const GuaranteeTask& task)
{
  GuaranteeReport report;
  Problems problems;
  task.query.validate(problems);
  const std::vector<const CriterionBound*> bounds = task.bounds(machine, report.left_out, problems);
  throwProblems(problems);
  GuaranteeQuery query = task.query;
  query.budget = task.query.budget.inTurns(static_cast<double>(bounds.size()));
  for (const CriterionBound* const bound : bounds)
  {
    const auto& [solid, center] = task.region;
    report.found.push_back(guaranteed(machine, query, *bound, *solid.shape, center, solid.size));
    report.messages.push_back(describe(report.found.back(), machine, query.budget));
    if (task.tell)
      task.tell(report.found.back());
  }
  return report;
}
}  // namespace pkm_workspace
