// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <stdexcept>

#include "pkm_workspace/common/parallel.h"
#include "pkm_workspace/study/best_parameter.h"

namespace pkm_workspace
{
namespace
{
std::vector<Interval> equalParts(const Interval& range, int count)
{
  std::vector<Interval> parts;
  double lower = range.lower();
  for (int k = 1; k <= count; ++k)
  {
    const double upper = ((count - k) * range.lower() + k * range.upper()) / count;
    parts.emplace_back(lower, k == count ? range.upper() : std::clamp(upper, lower, range.upper()));
    lower = parts.back().upper();
  }
  return parts;
}

/// Lowers the upper bounds of a part to what is proved of the whole range.
void lowerBounds(const BestParameter& whole, BestParameter& part)
{
  double bound = whole.region.size;
  for (const StudyPart& candidate : whole.candidates)
    if (!intersection(candidate.parameters, part.range).isEmpty())
      bound = std::max(bound, candidate.size_upper_bound);
  part.region.size_upper_bound = std::min(part.region.size_upper_bound, bound);
  for (StudyPart& candidate : part.candidates)
    candidate.size_upper_bound = std::min(candidate.size_upper_bound, bound);
}
}  // namespace

std::vector<BestParameter> bestOfParts(const StudyQuery& query, int count, const BestParameter& whole)
{
  validated(query);
  if (count < 1)
    throw std::invalid_argument("the range must be divided into 1 part or more");
  StudyQuery part = query;
  part.progress = nullptr;
  Budget& budget = part.region.budget;
  budget = budget.sharedBy(static_cast<std::size_t>(std::min(count, budget.threads)));
  budget = budget.inTurns(std::max(1.0, static_cast<double>(count) / budget.threads));
  if (budget.max_boxes > 0)
    budget.max_boxes = std::max<std::int64_t>(1, budget.max_boxes / count);
  const std::vector<Interval> ranges = equalParts(query.range, count);
  std::vector<BestParameter> parts(ranges.size());
  std::vector<std::exception_ptr> failures(ranges.size());
  ThreadPool(query.region.budget.threads, 0.0).forEach(ranges.size(), [&](std::size_t k) {
    StudyQuery of_part = part;
    of_part.range = ranges[k];
    try
    {
      parts[k] = findBestParameter(of_part);
    }
    catch (...)
    {
      failures[k] = std::current_exception();
    }
  });
  for (const std::exception_ptr& failure : failures)
    if (failure)
      std::rethrow_exception(failure);
  for (BestParameter& part : parts)
    lowerBounds(whole, part);
  return parts;
}
}  // namespace pkm_workspace
