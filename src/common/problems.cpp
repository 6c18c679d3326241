// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/problems.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
void throwProblems(const Problems& problems, const std::string& heading)
{
  constexpr std::size_t MOST_PROBLEMS = 20;
  constexpr std::size_t LONGEST_PROBLEM = 4000;
  if (problems.empty())
    return;
  const std::string line = heading.empty() ? "\n" : "\n  ";
  std::string text = heading;
  for (std::size_t k = 0; k < std::min(MOST_PROBLEMS, problems.size()); ++k)
    text += (text.empty() ? "" : line) + shortened(problems[k], LONGEST_PROBLEM);
  if (problems.size() > MOST_PROBLEMS)
    text += line + "and " + std::to_string(problems.size() - MOST_PROBLEMS) + " more";
  throw std::invalid_argument(text);
}

void validatePositive(const char* name, double value, const char* unit, Problems& problems)
{
  if (!(value > 0.0) || !std::isfinite(value))
    complain(problems, name, " = ", value, ' ', unit, " must be positive and finite");
}

void validateShare(const char* name, double value, const char* unit, Problems& problems)
{
  if (!(value >= 1e-15 && value <= 1.0))
    complain(problems, name, " = ", value, ' ', unit, " must be from 1e-15 to 1");
}

void validateBox(const char* name, const Box& box, Problems& problems)
{
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::isfinite(box.lower[axis]) && std::isfinite(box.upper[axis]) && box.lower[axis] <= box.upper[axis]))
      complain(problems, name, ' ', "xyz"[axis], " = [", box.lower[axis], ", ", box.upper[axis],
               "] m must be finite, the lower end first");
}
}  // namespace pkm_workspace
