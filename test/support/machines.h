// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <string>
#include <vector>

#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
/// An Orthoglide with rails some degrees off, unequal struts and platform points apart; exact doubles but for the axes.
/// @param scale mean strut length [m] @param place where the tool point of the zero configuration is [m]
inline Machine crooked(unsigned seed, double scale = 1.0, const Eigen::Vector3d& place = Eigen::Vector3d::Zero())
{
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * uniform(generator), size * uniform(generator), size * uniform(generator));
  };
  Machine::Legs legs = orthoglide(scale).legs();
  for (Leg& leg : legs)
  {
    const IntervalVector direction = enclose(Eigen::Vector3d(mid(slidingStrut(leg).axis) + vector(0.09)));
    const Interval length = norm(direction);
    slidingStrut(leg).axis = { direction[0] / length, direction[1] / length, direction[2] / length };
    slidingStrut(leg).length = scale * (1.0 + 0.15 * uniform(generator));
    slidingStrut(leg).platform = enclose(vector(0.1 * scale));
    slidingStrut(leg).origin = slidingStrut(leg).origin + enclose(place);
  }
  return Machine("crooked_" + std::to_string(seed), legs, place);
}

/// Three rails that lean 30 degrees outward from the axis z.
inline Machine cone()
{
  Machine::Legs legs = uranesx(Interval(0.7), Interval(0.1)).legs();
  for (Leg& leg : legs)
  {
    const Eigen::Vector3d outward = mid(slidingStrut(leg).origin).normalized();
    const IntervalVector direction = enclose(Eigen::Vector3d(0.5 * outward + 0.87 * Eigen::Vector3d::UnitZ()));
    const Interval length = norm(direction);
    slidingStrut(leg).axis = { direction[0] / length, direction[1] / length, direction[2] / length };
  }
  return Machine("cone", legs, Eigen::Vector3d(0.0, 0.0, -0.8));
}

/// One leg of each kind, with other limits.
inline Machine mixed()
{
  Machine::Legs legs = mixedLegs().legs();
  legs[0].limits = Interval::entire();
  legs[1].limits = Interval(-0.5, 0.5);
  return Machine("mixed", legs, Eigen::Vector3d::Zero());
}

/// The same with all directions and lengths off, the crank's zero and what it counts for elsewhere; exact doubles but
/// for the directions.
inline Machine crookedMix(unsigned seed)
{
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * uniform(generator), size * uniform(generator), size * uniform(generator));
  };
  const auto unit = [](const Eigen::Vector3d& v) {
    const IntervalVector direction = enclose(v);
    const Interval length = norm(direction);
    return IntervalVector{ direction[0] / length, direction[1] / length, direction[2] / length };
  };
  Machine::Legs legs = mixed().legs();
  legs[0] = crooked(seed).leg(0);
  auto& strut = std::get<TelescopicStrut>(legs[1].kind);
  strut.foot = strut.foot + enclose(vector(0.1));
  strut.platform = enclose(vector(0.1));
  strut.length = 1.0 + 0.1 * uniform(generator);
  auto& crank = std::get<Crank>(legs[2].kind);
  const Eigen::Vector3d axis = Eigen::Vector3d(0.0, -1.0, 0.0) + vector(0.2);
  const Eigen::Vector3d along = axis.cross(Eigen::Vector3d(0.0, 0.1, -1.0) + vector(0.2));
  crank.along = unit(along);
  crank.across = unit(axis.cross(along));
  crank.pivot = crank.pivot + enclose(vector(0.05));
  crank.platform = enclose(vector(0.05));
  crank.radius = 0.5 + 0.05 * uniform(generator);
  crank.length = 1.0 + 0.05 * uniform(generator);
  crank.reference = 0.2 * uniform(generator);
  crank.drive_scale = 0.6;
  return Machine("crooked_mix_" + std::to_string(seed), legs, Eigen::Vector3d(vector(0.02)));
}

/// Machines with other legs than sliding struts.
inline std::vector<Machine> otherLegs()
{
  Machine::Legs turned = delta().legs();
  for (Leg& leg : turned)
  {
    leg.limits = Interval(-0.9, 2.3);  // more than a half turn
    std::get<Crank>(leg.kind).reference = 0.7;
  }
  return { delta(), tripod(), mixed(), crookedMix(4), Machine("delta with wide limits", turned, delta().zero()) };
}

/// One of every kind with sliding struts.
inline std::vector<Machine> slidingKinds()
{
  return { orthoglide(), uranesx(),          orthoglide(0.31058),
           crooked(1),   crooked(2, 1000.0), crooked(3, 1.0, Eigen::Vector3d(1000.0, -20.0, 3.0)),
           cone() };
}

/// One of every kind that the laws have to hold for.
inline std::vector<Machine> everyKind()
{
  std::vector<Machine> machines = slidingKinds();
  for (const Machine& machine : otherLegs())
    machines.push_back(machine);
  return machines;
}

/// Adds joint limits that cut through the workspace.
inline Machine limited(const Machine& machine)
{
  Machine::Legs legs = machine.legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.2 * machine.scale(), 0.15 * machine.scale());
  return Machine(machine.name() + " with limits", legs, machine.zero());
}

/// The space that random boxes come from: a little more than the reachable points.
inline Box spaceOf(const Machine& machine)
{
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(1.2 * machine.scale());
  return { machine.zero() - reach, machine.zero() + reach };
}
}  // namespace test
}  // namespace pkm_workspace
