// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "pkm_workspace/machine/machine.h"
#include "support/exact_vector.h"

namespace pkm_workspace
{
namespace test
{
/// The numbers of a leg that the machine's enclosures stand for, to 90 digits.
struct ExactLeg
{
  ExactVector origin, axis, platform;
  Exact length;
  int working_mode;
};

/// A machine, and the oracle's own description of it.
struct ExactMachine
{
  std::string name;
  Machine machine;
  std::array<ExactLeg, 3> legs;
};

/// Section 1 of the design in exact arithmetic: the machine at one tool point.
struct ExactConfiguration
{
  ExactVector radicand, rho, eta;
  std::array<ExactVector, 3> strut;
  Exact det_a;

  /// False only when the point is proved to be out of reach; nothing but the radicands is valid then.
  bool isReached() const;
};

ExactConfiguration exactConfiguration(const std::array<ExactLeg, 3>& legs, const ExactVector& p);
ExactVector exact(const Eigen::Vector3d& v);

/// The two machines of the paper in several sizes and aspects, and crooked ones with unequal struts.
const std::vector<ExactMachine>& exactMachines();
/// Rails up to 9 degrees off the axes or a cone's, unequal struts, platform points apart. @param seed of the random
/// numbers
ExactMachine crookedMachine(const std::string& name, int seed, double scale = 1.0,
                            const Eigen::Vector3d& place = Eigen::Vector3d::Zero());
}  // namespace test
}  // namespace pkm_workspace
