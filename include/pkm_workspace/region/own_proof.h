// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
/// What a family answers itself whose bodies are not convex, such as a path with what it may be off. The search for the
/// largest one draws no conclusion from bad points between its points then, nor from its being connected.
class OwnProof
{
public:
  virtual ~OwnProof() = default;

  /// How far from their places the points of extremePoints(), and bad places, may be [m].
  virtual double slack(double size) const = 0;
  /// Whether every point of c + K(h) is good. With a bad point, where in the family it is. Not thread-safe: it may
  /// learn for refutes().
  virtual ContainmentResult prove(const BoxTest& test, const Eigen::Vector3d& center, double size,
                                  const Budget& budget) const = 0;
  /// Whether what the criterion does not ask for is proved to be violated for every center of the box.
  virtual bool refutes(const BoxTest& test, const Box& centers, double size) const = 0;
};
}  // namespace pkm_workspace
