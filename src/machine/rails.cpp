// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/rails.h"

#include <cstdlib>

namespace pkm_workspace
{
namespace
{
IntervalVector timesSense(int sense, const IntervalVector& v)
{
  return sense > 0 ? v : IntervalVector{ -v[0], -v[1], -v[2] };
}

bool isSingle(const IntervalVector& v)
{
  return v[0].isSingle() && v[1].isSingle() && v[2].isSingle();
}

/// 1 for the same numbers, -1 for the opposite ones, otherwise 0.
int senseOfNumbers(const IntervalVector& a, const IntervalVector& b)
{
  return a == b ? 1 : a == timesSense(-1, b) ? -1 : 0;
}

int senseOfDirections(const SlidingStrut& a, const SlidingStrut& b)
{
  return a.direction == 0 || std::abs(a.direction) != std::abs(b.direction) ? 0 : a.direction == b.direction ? 1 : -1;
}

/// Calls the function for every two rails, the later one first.
template <class Legs, class Function>
void forEachPair(Legs& legs, const Function& function)
{
  for (std::size_t i = 1; i < legs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      auto* const a = std::get_if<SlidingStrut>(&legs[i].kind);
      auto* const b = std::get_if<SlidingStrut>(&legs[j].kind);
      if (a != nullptr && b != nullptr)
        function(i, *a, j, *b);
    }
}
}  // namespace

int parallelSense(const Leg& a, const Leg& b)
{
  const auto* const first = std::get_if<SlidingStrut>(&a.kind);
  const auto* const second = std::get_if<SlidingStrut>(&b.kind);
  if (first == nullptr || second == nullptr)
    return 0;
  if (first->tolerance.direction > 0.0 || second->tolerance.direction > 0.0)
    return 0;
  const bool exact = isSingle(first->axis) && isSingle(second->axis);
  return exact ? senseOfNumbers(first->axis, second->axis) : senseOfDirections(*first, *second);
}

std::array<int, 3> sharedDirections(const std::function<int(std::size_t, std::size_t)>& sense)
{
  std::array<int, 3> numbers = { 0, 0, 0 };
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i && numbers[i] == 0; ++j)
      if (const int found = sense(i, j))
      {
        numbers[j] = numbers[j] == 0 ? static_cast<int>(j) + 1 : numbers[j];
        numbers[i] = found * numbers[j];
      }
  return numbers;
}

std::array<int, 3> sharedDirections(const std::array<Leg, 3>& legs)
{
  return sharedDirections([&legs](std::size_t i, std::size_t j) { return parallelSense(legs[i], legs[j]); });
}

void setDirections(std::array<Leg, 3>& legs, const std::array<int, 3>& numbers)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (auto* const strut = std::get_if<SlidingStrut>(&legs[i].kind))
      strut->direction = numbers[i];
}

std::string directionsText(const std::array<Leg, 3>& legs)
{
  std::string text;
  forEachPair(legs, [&](std::size_t i, const SlidingStrut& a, std::size_t j, const SlidingStrut& b) {
    if (parallelSense(legs[i], legs[j]) != senseOfNumbers(a.axis, b.axis))
      text += " not parallel " + std::to_string(i) + ' ' + std::to_string(j);
  });
  return text;
}

void uniteAxes(std::array<Leg, 3>& legs, Problems& problems)
{
  forEachPair(legs, [&](std::size_t i, SlidingStrut& a, std::size_t j, SlidingStrut& b) {
    const int sense = senseOfDirections(a, b);
    if (sense == 0)
      return;
    const IntervalVector other = timesSense(sense, a.axis);
    if (intersects(b.axis, other))
      b.axis = { intersection(b.axis[0], other[0]), intersection(b.axis[1], other[1]),
                 intersection(b.axis[2], other[2]) };
    else
      complain(problems, "legs '", legs[j].joint, "' and '", legs[i].joint,
               "' are said to share a direction, but their axes are apart");
  });
  forEachPair(legs, [](std::size_t, SlidingStrut& a, std::size_t, SlidingStrut& b) {
    if (const int sense = senseOfDirections(a, b))
      a.axis = timesSense(sense, b.axis);
  });
}
}  // namespace pkm_workspace
