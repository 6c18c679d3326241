// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/joint_ranges.h"

#include "leg_range.h"

namespace pkm_workspace
{
std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center,
                                      double size)
{
  const PlacedShape region{ shape, center, size };
  const auto of = [&](int i) {
    return visitLeg([&](const auto& leg) { return rangeOver(leg, region); }, machine.enclosed(i));
  };
  return { of(0), of(1), of(2) };
}
}  // namespace pkm_workspace
