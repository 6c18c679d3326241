// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Workpieces, and the worst of their points where they are moved to, in 100 digits.

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/placement.h"
#include "pkm_workspace/region/polytope.h"
#include "region/exact_rates.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
inline Zone keepIn(const Vector3d& center, const Vector3d& sides)
{
  Zone zone;
  zone.use = Zone::Use::KEEP_IN;
  zone.kind = Zone::Kind::BOX;
  zone.name = "table";
  zone.pose.translation = center;
  zone.sides = sides;
  return zone;
}

inline Zone column(const Vector3d& center, double radius)
{
  Zone zone;
  zone.use = Zone::Use::KEEP_OUT;
  zone.kind = Zone::Kind::CYLINDER;
  zone.name = "column";
  zone.pose.translation = center;
  zone.radius = radius;
  zone.height = INF;
  return zone;
}

inline std::shared_ptr<Workpiece> pathOf(const std::vector<PathSegment>& segments, double tool_speed = 0.0)
{
  auto workpiece = std::make_shared<Workpiece>();
  for (const PathSegment& segment : segments)
    workpiece->moves.add(segment.curve(), Interval(tool_speed));
  workpiece->moves.close();
  workpiece->reference = workpiece->bounds().center();
  return workpiece;
}

inline std::shared_ptr<Workpiece> partOf(const std::vector<Vector3d>& vertices)
{
  auto workpiece = std::make_shared<Workpiece>();
  workpiece->solid = makePolytope(vertices);
  return workpiece;
}

/// A zigzag of lines in space.
inline std::vector<PathSegment> zigzag(RandomBoxes& random, const Box& box, int count)
{
  std::vector<PathSegment> segments;
  Vector3d from = random.pointIn(box);
  for (int k = 0; k < count; ++k)
  {
    const Vector3d to = random.pointIn(box);
    segments.push_back(PathSegment::line(from, to));
    from = to;
  }
  return segments;
}

inline PlacementQuery queryOf(const std::shared_ptr<Workpiece>& workpiece, const Criterion& criterion)
{
  PlacementQuery query;
  query.workpiece = workpiece;
  query.criterion = criterion;
  query.accuracy = 1e-4;
  query.budget.threads = 2;
  return query;
}

/// Points at the ends of the moves and between them, or of a part.
inline std::vector<Vector3d> pointsOf(const Workpiece& workpiece, RandomBoxes& random, int per_move)
{
  std::vector<Vector3d> points;
  for (std::uint32_t k = 0; k < workpiece.moves.size(); ++k)
    for (int sample = 0; sample < per_move; ++sample)
    {
      const double t = sample < 2 ? sample : random.between(0.0, 1.0);
      points.push_back(mid(workpiece.moves.curve({ 0, k }).point(t)));
    }
  if (!workpiece.solid)
    return points;
  const auto corners = pkm_workspace::pointsOf(workpiece.solid->extremePoints(), workpiece.reference, 1.0);
  for (int sample = 0; sample < 200; ++sample)
  {
    Vector3d point = workpiece.reference;
    for (const Vector3d& corner : corners)
      point += (sample < 20 ? 1.0 : random.between(0.0, 1.0)) * random.between(0.0, 1.0) * (corner - point);
    points.push_back(point);
  }
  points.insert(points.end(), corners.begin(), corners.end());
  return points;
}

/// By how much a point is within the criterion, in floating point by the definitions; negative where it is not.
inline double withinBy(const Machine& machine, const Criterion& criterion, const Vector3d& p)
{
  double least = INF;
  for (const Zone& zone : criterion.zones)
    least = std::min(least, static_cast<double>(ZoneOracle(zone, 0.0).clearance({ p.x(), p.y(), p.z() })));
  const auto here = least < 0.0 ? std::nullopt : jacobians(machine, p);
  if (!here || here->a.determinant() * machine.aspect() <= 0.0)
    return -1.0;
  const Vector3d psi = transmissionFactors(*here);
  return std::min({ least, psi[0] / criterion.psi_min - 1.0, 1.0 - psi[2] / criterion.psi_max });
}

/// A bad point among those that the workpiece has at a place, moved by up to the margin: the worst in floating point,
/// decided in 100 digits.
inline std::optional<Vector3d> badPoint(const Machine& machine, const Criterion& criterion,
                                        const std::vector<Vector3d>& points, const Vector3d& place, double margin,
                                        RandomBoxes& random)
{
  std::pair<double, Vector3d> worst{ INF, Vector3d::Zero() };
  for (const Vector3d& point : points)
    for (int corner = 0; corner < (margin > 0.0 ? 12 : 1); ++corner)
    {
      const auto along = [&](int bit) {
        return corner < 8 ? ((corner & bit) != 0 ? margin : -margin) : random.between(-margin, margin);
      };
      const Vector3d moved = place + point + Vector3d(along(1), along(2), along(4));
      const double slack = withinBy(machine, criterion, moved);
      if (slack < worst.first)
        worst = { slack, moved };
    }
  return Oracle(machine, criterion).isGood(worst.second) ? std::nullopt : std::optional(worst.second);
}

inline Criterion within(const Vector3d& center, const Vector3d& sides)
{
  Criterion criterion;
  criterion.zones = { keepIn(center, sides) };
  return criterion;
}
}  // namespace test
}  // namespace pkm_workspace
