// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>

#include "pkm_workspace/interval/box.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// Random points and boxes from a fixed seed.
class RandomBoxes
{
public:
  explicit RandomBoxes(unsigned seed) : generator_(seed) {}

  double between(double lower, double upper)
  {
    return std::uniform_real_distribution<double>(lower, upper)(generator_);
  }

  Eigen::Vector3d pointIn(const Box& box)
  {
    Eigen::Vector3d point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = std::min(box.upper[axis], std::max(box.lower[axis], between(box.lower[axis], box.upper[axis])));
    return point;
  }

  /// A box around a point of @p space, its sides up to @p width wide, mostly much smaller.
  Box boxIn(const Box& space, double width)
  {
    const Eigen::Vector3d center = pointIn(space);
    const double size = 0.5 * width * std::pow(10.0, between(-4.0, 0.0));
    const Eigen::Vector3d half(size * between(0.0, 1.0), size * between(0.0, 1.0), size * between(0.0, 1.0));
    return { center - half, center + half };
  }

private:
  std::mt19937_64 generator_;
};
}  // namespace test
}  // namespace pkm_workspace
