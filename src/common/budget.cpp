// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/budget.h"

#include <cmath>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
void Budget::validate(Problems& problems) const
{
  if (!(time_limit >= 0.0) || !std::isfinite(time_limit))
    complain(problems, "time_limit = ", time_limit, " s must be positive and finite, or 0 for none");
  if (max_boxes < 0)
    complain(problems, "max_boxes = ", max_boxes, " must be positive, or 0 for none");
  if (threads < 1 || threads > 1024)
    complain(problems, "threads = ", threads, " must be from 1 to 1024");
  if (max_memory != 0 && max_memory < LEAST_MEMORY)
    complain(problems, "max_memory = ", max_memory, " bytes must be at least ", std::int64_t(LEAST_MEMORY),
             ", or 0 for none");
}

bool Budget::isOver(double seconds) const
{
  return (stop && *stop) || (time_limit > 0.0 && seconds >= time_limit);
}

bool Budget::isFull(std::size_t bytes) const
{
  return max_memory > 0 && bytes > static_cast<std::size_t>(max_memory);
}

Budget Budget::sharedBy(std::size_t computations) const
{
  Budget share = *this;
  if (max_memory > 0)
  {
    share.max_memory = std::max<std::int64_t>(LEAST_MEMORY, max_memory / static_cast<std::int64_t>(computations));
    share.whole_memory = whole_memory > 0 ? whole_memory : max_memory;
  }
  return share;
}

Budget Budget::within(double seconds) const
{
  Budget part = *this;
  if (time_limit > 0.0)
  {
    part.time_limit = seconds;
    part.whole_time = whole_time > 0.0 ? whole_time : time_limit;
  }
  return part;
}

std::string Budget::endedBy(double seconds, std::int64_t boxes, bool out_of_memory) const
{
  TextStream text;
  if (stop && *stop)
    text << "a request to stop";
  else if (max_boxes > 0 && boxes >= max_boxes)
    text << "the limit of " << max_boxes << (max_boxes == 1 ? " box" : " boxes");
  else if (out_of_memory)
    text << (whole_memory > 0 ? "its share of " : "") << "the limit of "
         << (whole_memory > 0 ? whole_memory : max_memory) << " bytes of memory";
  else if (isOver(seconds) && whole_time > 0.0)
    text << nearly(time_limit, 3) << " s, its share of the time limit of " << whole_time << " s";
  else if (isOver(seconds))
    text << "the time limit of " << time_limit << " s";
  return text.str();
}
}  // namespace pkm_workspace
