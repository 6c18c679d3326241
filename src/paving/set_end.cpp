// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/set_end.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

constexpr int MOST_STEPS = 4;
/// The end is known to a millionth of a step then: no second condition fails on so short a way, but by chance.
constexpr int END_HALVINGS = 20;

bool isGood(const PointEvaluator& evaluate, const Vector3d& point)
{
  return evaluate.test().margin(point) >= 0.0;
}

SetEnd between(const PointEvaluator& evaluate, Vector3d good, Vector3d bad)
{
  for (int k = 0; k < END_HALVINGS; ++k)
  {
    const Vector3d middle = 0.5 * (good + bad);
    (isGood(evaluate, middle) ? good : bad) = middle;
  }
  return { evaluate(bad).binding().kind, good, bad };
}
}  // namespace

std::optional<SetEnd> endOfSet(const PointEvaluator& evaluate, const Vector3d& from, const Vector3d& step)
{
  const bool starts_good = isGood(evaluate, from);
  const Vector3d way = starts_good ? step : Vector3d(-step);
  for (int k = 1; k <= MOST_STEPS; ++k)
  {
    const Vector3d next = from + k * way;
    if (isGood(evaluate, next) != starts_good)
      return starts_good ? between(evaluate, next - way, next) : between(evaluate, next, next - way);
  }
  return std::nullopt;
}
}  // namespace pkm_workspace
