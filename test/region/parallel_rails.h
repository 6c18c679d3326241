// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/region/growing_prisms.h"
#include "pkm_workspace/region/largest_region.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{

/// Three rails along z, some of them counting downwards, at the corners of a triangle without symmetry; struts that
/// hang from them. Joints may move from -0.45 to -0.15 m and from 0.15 to 0.45 m around the zero configuration, at the
/// origin.
inline Machine withParallelRails(unsigned seed)
{
  Random random(seed);
  Machine::Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double angle = 2.0944 * static_cast<double>(i) + random.uniform(-0.15, 0.15);
    const double radius = random.uniform(0.43, 0.52);
    const double sign = random.sign();
    legs[i].joint = "rail_" + std::to_string(i + 1);
    slidingStrut(legs[i]).axis = { 0.0, 0.0, sign };
    slidingStrut(legs[i]).origin = { radius * std::cos(angle), radius * std::sin(angle), random.uniform(-0.2, 0.2) };
    slidingStrut(legs[i]).platform = { 0.0, 0.0, 0.0 };
    slidingStrut(legs[i]).length = random.uniform(0.9, 1.1);
    slidingStrut(legs[i]).working_mode = sign > 0.0 ? -1 : 1;
  }
  const Machine free("parallel_" + std::to_string(seed), legs, Eigen::Vector3d::Zero());
  const auto zero = *configurationAt(free, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < 3; ++i)
    legs[i].limits = { zero.rho[i].mid() - random.uniform(0.15, 0.45), zero.rho[i].mid() + random.uniform(0.15, 0.45) };
  return Machine(free.name(), legs, Eigen::Vector3d::Zero());
}

/// The same enclosures, a rounding wide along z, of rails that may be apart.
inline Machine withoutSharedDirection(const Machine& machine)
{
  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
  {
    slidingStrut(leg).direction = 0;
    Interval& z = slidingStrut(leg).axis[2];
    if (z.isSingle())
      z = z.lower() > 0.0 ? Interval(std::nextafter(1.0, 0.0), 1.0) : Interval(-1.0, std::nextafter(-1.0, 0.0));
  }
  return Machine(machine.name() + " in general", legs, machine.zero());
}

inline Machine leaning(const Machine& machine)
{
  return machineInFrame(machine, { { 0.15, 0.1, 0.0, std::sqrt(1.0 - 0.0325) }, Eigen::Vector3d(0.3, -1.0, 2.0) });
}

inline Machine lyingAlongX(const Machine& machine)
{
  return machineInFrame(machine, { { 0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5) }, Eigen::Vector3d(0.1, 0.2, 0.3) });
}

inline RegionQuery queryFor(const ShapePtr& shape, double accuracy)
{
  RegionQuery query;
  query.shape = shape;
  query.accuracy = accuracy;
  query.criterion.joint_limits = true;
  query.budget.max_boxes = 20000;
  return query;
}

inline std::vector<ShapePtr> shapes()
{
  return { makeCube(), makeSquare(), makeDisc(), makeSphere(), makeBox({ 0.1, 0.2, 1.0 }) };
}

/// Those that scale about their center, and others.
inline std::vector<ShapePtr> everyShape()
{
  std::vector<ShapePtr> every = shapes();
  for (const ShapePtr& shape :
       { makeCylinderOfRadius(0.1, Stand::ON_BASE), makeCylinderOfHeight(0.05), makeBoxOnBase(0.1, 0.2) })
    every.push_back(shape);
  return every;
}

inline LargestRegion expectProven(const Machine& machine, const RegionQuery& query)
{
  const LargestRegion region = findLargestRegion(machine, query);
  EXPECT_EQ(region.status, LargestRegion::Status::PROVEN)
      << machine.name() << ", " << query.shape->name() << ": " << region.size << " to " << region.size_upper_bound;
  return region;
}
}  // namespace test
}  // namespace pkm_workspace
