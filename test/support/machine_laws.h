// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/exact_machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
inline std::ostream& operator<<(std::ostream& stream, const ExactMachine& machine)
{
  return stream << machine.name;
}

/// What holds for every machine: each law is tried on all of exactMachines().
class MachineLaws : public testing::TestWithParam<ExactMachine>
{
protected:
  /// Below this singularity measure floating-point laws are not tried: rounding is amplified by its inverse.
  static constexpr double REGULAR = 0.03;

  const Machine& machine() const { return GetParam().machine; }
  const std::array<ExactLeg, 3>& exactLegs() const { return GetParam().legs; }
  ExactConfiguration exactAt(const Eigen::Vector3d& p) const { return exactConfiguration(exactLegs(), exact(p)); }

  /// Any point of a cube around the zero configuration that reaches past the workspace [m].
  Eigen::Vector3d anyPoint(Random& random) const
  {
    const double reach = 1.3 * machine().scale();
    return machine().zero() +
           Eigen::Vector3d(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
  }

  /// Hands points to @p check(p, configuration, random) that are reached and away from singularities, in either aspect.
  template <class Check>
  void forEachRegularPoint(const Check& check) const
  {
    int found = 0;
    for (int seed = 0; found < cases() && seed < cases(10000) && !HasFailure(); ++seed)
    {
      Random random(static_cast<std::uint64_t>(seed));
      const Eigen::Vector3d p = anyPoint(random);
      const ExactConfiguration there = exactAt(p);
      if (!there.isReached() || serialMeasure(there) < REGULAR || parallelMeasure(there) < REGULAR)
        continue;
      ++found;
      SCOPED_TRACE("seed " + std::to_string(seed) + ", p = " + toText(p));
      check(p, there, random);
    }
    ASSERT_EQ(found, cases()) << "too few points are regular";
  }

  /// Singularity measures of the design, from the oracle.
  double serialMeasure(const ExactConfiguration& there) const
  {
    double least = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
      least = std::min(least, std::abs((there.eta[i] / exactLegs()[i].length).value()));
    return least;
  }
  double parallelMeasure(const ExactConfiguration& there) const
  {
    const auto& legs = exactLegs();
    return std::abs((there.det_a / (legs[0].length * legs[1].length * legs[2].length)).value());
  }
  bool isInAspect(const ExactConfiguration& there) const { return there.det_a.value() * machine().aspect() > 0.0; }

  /// One rounding of the largest coordinate that takes part in the computation for p [m].
  double ulp(const Eigen::Vector3d& p) const
  {
    double extent = p.norm() + machine().scale();
    for (int i = 0; i < 3; ++i)
      extent += mid(slidingStrut(machine().leg(i)).origin).norm();
    return extent * std::numeric_limits<double>::epsilon();
  }

  static std::string toText(const Eigen::Vector3d& p)
  {
    std::ostringstream text;
    text.precision(17);
    text << p.transpose();
    return text.str();
  }
};
}  // namespace test
}  // namespace pkm_workspace
