// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pkm_workspace
{
void throwProblems(const Problems& problems)
{
  if (problems.empty())
    return;
  std::string text;
  for (const auto& problem : problems)
    text += (text.empty() ? "" : "\n") + problem;
  throw std::invalid_argument(text);
}

namespace
{
void complain(Problems& problems, const std::string& name, double value, const std::string& allowed)
{
  std::ostringstream text;
  text.precision(17);
  text << name << " = " << value << ' ' << allowed;
  problems.push_back(text.str());
}
}  // namespace

void validatePositive(const char* name, double value, const char* unit, Problems& problems)
{
  if (!(value > 0.0) || !std::isfinite(value))
    complain(problems, name, value, std::string(unit) + " must be positive and finite");
}

void validateBox(const char* name, const Box& box, Problems& problems)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::isfinite(box.lower[axis]) && std::isfinite(box.upper[axis]) && box.lower[axis] <= box.upper[axis])
      continue;
    std::ostringstream text;
    text.precision(17);
    text << name << ' ' << "xyz"[axis] << " = [" << box.lower[axis] << ", " << box.upper[axis]
         << "] m must be finite, the lower end first";
    problems.push_back(text.str());
  }
}

void Budget::validate(Problems& problems) const
{
  if (!(time_limit >= 0.0) || !std::isfinite(time_limit))
    complain(problems, "time_limit", time_limit, "s must be positive and finite, or 0 for none");
  if (max_boxes < 0)
    complain(problems, "max_boxes", static_cast<double>(max_boxes), "must be positive, or 0 for none");
  if (threads < 1 || threads > 1024)
    complain(problems, "threads", threads, "must be from 1 to 1024");
}

bool Budget::isOver(double seconds) const
{
  return (stop && *stop) || (time_limit > 0.0 && seconds >= time_limit);
}

void Criterion::validate(Problems& problems) const
{
  const auto refuse = [&problems](const char* name, double value, const std::string& allowed) {
    complain(problems, name, value, "(a transmission factor, without unit) must be " + allowed);
  };
  // the squares of both have to be ordinary numbers
  constexpr double LEAST = 1e-100;
  constexpr double LARGEST = 1e100;
  if (!(psi_min >= LEAST && psi_min <= LARGEST))
    refuse("psi_min", psi_min, "positive and finite (1e-100 to 1e100)");
  if (!(psi_max >= LEAST && psi_max <= LARGEST))
    refuse("psi_max", psi_max, "positive and finite (1e-100 to 1e100)");
  else if (!(psi_min <= psi_max))
    refuse("psi_max", psi_max, "at least psi_min");
}
}  // namespace pkm_workspace
