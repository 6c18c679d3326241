// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "pkm_workspace/region/region_wish.h"
#include "region/parallel_rails.h"

namespace pkm_workspace
{
namespace test
{
inline const std::vector<Eigen::Vector3d> WEDGE = {
  { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.0, 0.75, 0.0 }, { 0.0, 0.0, 0.375 }, { 0.375, 0.125, 0.25 }
};

/// A shape that is asked for, and after how much of a turn it is the same.
struct TurnedWish
{
  ShapeWish wish;
  double period;
};

inline std::vector<TurnedWish> turnedWishes()
{
  ShapeWish of_footprint{ "box" };
  of_footprint.footprint = std::array<double, 2>{ 0.25, 0.125 };
  ShapeWish of_long_footprint{ "box" };
  of_long_footprint.footprint = std::array<double, 2>{ 0.0625, 0.75 };
  ShapeWish wedge{ "polytope" };
  wedge.vertices = WEDGE;
  return { { { "square" }, M_PI / 2.0 },
           { { "cube" }, M_PI / 2.0 },
           { { "box", Eigen::Vector3d(2.0, 1.0, 0.5) }, M_PI },
           { { "box", Eigen::Vector3d(1.0, 0.0, 0.5) }, M_PI },
           { of_footprint, M_PI },
           { of_long_footprint, M_PI },
           { wedge, 2.0 * M_PI } };
}

inline Machine deltaWithLimits()
{
  Machine::Legs legs = uranesx().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(-0.3, 0.3);
  return Machine("delta with limits", legs, uranesx().zero());
}

inline std::vector<Machine> machinesToTurnIn()
{
  return { orthoglide(), deltaWithLimits(), crooked(4), leaning(withParallelRails(SEED)) };
}

inline RegionQuery turnedQuery(const ShapeWish& wish, double accuracy, PlaceWish place = {})
{
  RegionQuery query = queryFor(nullptr, accuracy);
  query.budget.max_boxes = 200000;
  setShape(wish, query);
  place.turned = true;
  setPlace(place, query);
  return query;
}
/// A wall, a column and a turned box beside the machine's zero configuration: for shapes without thickness no box, for
/// polytopes only the wall, for the search to end soon.
inline std::vector<Zone> zonesBeside(const Machine& machine, const std::string& shape)
{
  Zone column;
  column.kind = Zone::Kind::CYLINDER;
  column.radius = 0.05 * machine.scale();
  column.height = INF;
  column.pose.translation = machine.zero() + machine.scale() * Eigen::Vector3d(0.15, 0.1, 0.0);
  Zone box;
  box.kind = Zone::Kind::BOX;
  box.sides = machine.scale() * Eigen::Vector3d(0.2, 0.1, 0.3);
  box.pose = { { 0.1, 0.2, 0.3, std::sqrt(0.86) },
               machine.zero() + machine.scale() * Eigen::Vector3d(-0.25, 0.05, 0.05) };
  Zone wall;
  wall.use = Zone::Use::KEEP_IN;
  wall.kind = Zone::Kind::HALF_SPACE;
  wall.normal = { 0.3, 1.0, 0.1 };
  wall.pose.translation = machine.zero() - 0.2 * machine.scale() * Eigen::Vector3d::UnitY();
  return shape == "polytope" ? std::vector<Zone>{ wall }
         : shape == "square" ? std::vector<Zone>{ wall, column }
                             : std::vector<Zone>{ wall, column, box };
}
}  // namespace test
}  // namespace pkm_workspace
