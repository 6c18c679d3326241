// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/best_parameter.h"

namespace pkm_workspace
{
void StudyQuery::validate(Problems& problems) const
{
  if (!family.at)
    problems.push_back("a family of machines is missing");
  if (range.isEmpty() || !range.isBounded())
    problems.push_back("the range of the parameter must be two finite numbers, the least one first");
  if (region.ratio)
    problems.push_back("a study compares regions of one shape: a cylinder needs one ratio");
  region.validate(problems);
  if (problems.empty())
    validateAccuracy(family.at(Interval(range.lower())), region, problems);
}
}  // namespace pkm_workspace
