// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/zone_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pkm_workspace/interval/turning.h"

namespace pkm_workspace
{
namespace
{
/// How the zone's own axes are turned.
IntervalMatrix turnOf(const Zone& zone)
{
  const IntervalMatrix turn = rotationOf(zone.frame) * rotationOf(zone.pose);
  return zone.view ? zone.view->rotation * turn : turn;
}

IntervalVector centerOf(const Zone& zone)
{
  const IntervalVector center = transformed(zone.frame, enclose(zone.pose.translation));
  return zone.view ? zone.view->rotation * center + zone.view->translation : center;
}

/// Half of what the zone measures along its own axes [m].
IntervalVector halfSides(const Zone& zone)
{
  const Interval radius(zone.radius);
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      return { Interval(0.5) * Interval(zone.sides[0]), Interval(0.5) * Interval(zone.sides[1]),
               Interval(0.5) * Interval(zone.sides[2]) };
    case ZoneKind::CYLINDER:
      return { radius, radius, std::isfinite(zone.height) ? Interval(0.5) * Interval(zone.height) : Interval(0.0) };
    case ZoneKind::SPHERE:
      return { radius, radius, radius };
    case ZoneKind::HALF_SPACE:
      break;
  }
  return {};
}

/// How far above a surface a point is put for its side to be sure, in roundings of the largest length.
constexpr double ABOVE = 1024.0;

/// The coordinate nearest to u that is beneath the surface of |u| <= half by the depth.
double clamped(double u, double half, double depth)
{
  return std::clamp(u, -std::max(half - depth, 0.0), std::max(half - depth, 0.0));
}

/// Moves the first @p count coordinates to where their norm is at most the radius.
void clampNorm(Eigen::Vector3d& u, int count, double radius)
{
  const double norm = u.head(count).norm();
  if (norm > radius)
    u.head(count) *= std::max(radius, 0.0) / norm;
}

/// The place of the zone's own axes nearest to u that is beneath its surfaces by the depth; floating point.
Eigen::Vector3d nearestWithin(const PlainZone<double>& zone, Eigen::Vector3d u, double depth)
{
  const std::array<double, 3>& half = zone.half;
  switch (zone.kind)
  {
    case ZoneKind::BOX:
      for (int k = 0; k < 3; ++k)
        u[k] = clamped(u[k], half[k], depth);
      break;
    case ZoneKind::CYLINDER:
      clampNorm(u, 2, half[0] - depth);
      if (zone.has_ends)
        u[2] = clamped(u[2], half[2], depth);
      break;
    case ZoneKind::SPHERE:
      clampNorm(u, 3, half[0] - depth);
      break;
    case ZoneKind::HALF_SPACE:
      u[0] = std::max(u[0], depth - half[0]);
      break;
  }
  return u;
}

Eigen::Vector3d vectorOf(const std::array<double, 3>& v)
{
  return Eigen::Vector3d(v.data());
}

/// What a function of places in the zone's own axes makes of p.
template <class Function>
Eigen::Vector3d inOwnAxes(const PlainZone<double>& zone, const Eigen::Vector3d& p, const Function& function)
{
  Eigen::Matrix3d turn;
  for (int row = 0; row < 3; ++row)
    turn.row(row) = vectorOf(zone.turn[static_cast<std::size_t>(row)]).transpose();
  const Eigen::Vector3d u = turn * (p - vectorOf(zone.center));
  return p + turn.transpose() * (function(u) - u);
}

/// The point nearest to p that is so many roundings beneath the surface; floating point.
Eigen::Vector3d nearestBeneath(const PlainZone<double>& zone, const Eigen::Vector3d& p, double roundings)
{
  const double size =
      p.cwiseAbs().maxCoeff() + vectorOf(zone.center).cwiseAbs().maxCoeff() + vectorOf(zone.half).maxCoeff();
  const double depth = roundings * std::numeric_limits<double>::epsilon() * size;
  return inOwnAxes(zone, p, [&](const Eigen::Vector3d& u) { return nearestWithin(zone, u, depth); });
}

/// Of a half-space to keep to, its side along one axis; all of space where its normal is along none.
Box boundsOfHalfSpace(const EnclosedZone& zone)
{
  const double outward = zone.use == Zone::Use::KEEP_IN ? 1.0 : -1.0;
  Box bounds{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto axis = static_cast<int>(k);
    if (zone.turn[0][k] == Interval(outward))
      bounds.lower[axis] = (zone.center[k] - Interval(outward) * zone.half[0]).lower();
    else if (zone.turn[0][k] == Interval(-outward))
      bounds.upper[axis] = (zone.center[k] + Interval(outward) * zone.half[0]).upper();
  }
  return bounds;
}
}  // namespace

EnclosedZone enclosed(const Zone& zone, double tool_radius)
{
  EnclosedZone result{ zone.use, zone.kind, zone.kind != ZoneKind::CYLINDER || std::isfinite(zone.height), {}, {},
                       {},       {} };
  const IntervalMatrix turn = turnOf(zone);
  result.turn = transpose(turn);
  result.center = centerOf(zone);
  if (zone.kind == ZoneKind::HALF_SPACE)
  {
    const IntervalVector normal = enclose(zone.normal);
    result.turn = { turn * ((Interval(1.0) / norm(normal)) * normal), IntervalVector{}, IntervalVector{} };
  }
  const Interval growth = zone.use == Zone::Use::KEEP_IN ? -Interval(tool_radius) : Interval(tool_radius);
  result.half = halfSides(zone);
  for (Interval& half : result.half)
    half += growth;
  if (zone.kind == ZoneKind::CYLINDER || zone.kind == ZoneKind::SPHERE)
  {
    result.squared_radius = sqr(result.half[0]);
    result.per_diameter = Interval(1.0) / (Interval(2.0) * result.half[0]);
  }
  return result;
}

Interval clearance(const EnclosedZone& zone, const IntervalVector& p)
{
  IntervalVector u;
  mapOffset(zone.turn, zone.center, p, u);
  const auto least = [](const Interval& a, const Interval& b) {
    return Interval(std::min(a.lower(), b.lower()), std::min(a.upper(), b.upper()));
  };
  const auto largest = [](const Interval& a, const Interval& b) {
    return Interval(std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
  };
  return clearanceOf(zone, u, least, largest);
}

bool runsAlong(const EnclosedZone& zone, const IntervalVector& e)
{
  const auto isAcross = [&](const IntervalVector& axis) { return dot(axis, e) == Interval(0.0); };
  return zone.kind == ZoneKind::HALF_SPACE ? isAcross(zone.turn[0])
                                           : !zone.has_ends && isAcross(zone.turn[0]) && isAcross(zone.turn[1]);
}

Box boundsOf(const EnclosedZone& zone)
{
  if (zone.kind == ZoneKind::HALF_SPACE)
    return boundsOfHalfSpace(zone);
  Box bounds{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };
  if (zone.use == Zone::Use::KEEP_OUT)
    return bounds;
  const IntervalMatrix axes = transpose(zone.turn);  // rows: one axis of space along those of the zone
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!zone.has_ends && axes[k][2] != Interval(0.0))
      continue;
    const Interval reach =
        zone.kind == ZoneKind::BOX
            ? abs(axes[k][0]) * zone.half[0] + abs(axes[k][1]) * zone.half[1] + abs(axes[k][2]) * zone.half[2]
        : zone.kind == ZoneKind::SPHERE ? zone.half[0]
                                        : sqrt(sqr(axes[k][0]) + sqr(axes[k][1])) * zone.half[0] +
                                              (zone.has_ends ? abs(axes[k][2]) * zone.half[2] : Interval(0.0));
    bounds.lower[static_cast<int>(k)] = (zone.center[k] - reach).lower();
    bounds.upper[static_cast<int>(k)] = (zone.center[k] + reach).upper();
  }
  return bounds;
}

PlainZone<double> turnedBack(const PlainZone<double>& zone, const Eigen::Vector3d& center, double angle)
{
  PlainZone<double> result = zone;
  const Eigen::Vector3d offset = turnedAboutZ(vectorOf(zone.center) - center, -angle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d row = turnedAboutZ(vectorOf(zone.turn[k]), -angle);
    result.turn[k] = { row.x(), row.y(), row.z() };
    result.center[k] = center[static_cast<int>(k)] + offset[static_cast<int>(k)];
  }
  return result;
}

Eigen::Vector3d nearestOf(const PlainZone<double>& zone, const Eigen::Vector3d& p)
{
  return nearestBeneath(zone, p, 0.0);
}

Eigen::Vector3d nearestOfCore(const PlainZone<double>& zone, const Eigen::Vector3d& p)
{
  return inOwnAxes(zone, p, [&](const Eigen::Vector3d& u) -> Eigen::Vector3d {
    if (zone.kind == ZoneKind::SPHERE)
      return Eigen::Vector3d::Zero();
    if (zone.kind != ZoneKind::CYLINDER)
      return nearestWithin(zone, u, 0.0);
    return { 0.0, 0.0, zone.has_ends ? clamped(u[2], zone.half[2], 0.0) : u[2] };
  });
}

std::optional<Eigen::Vector3d> pointWithin(const ZoneToKeepOut& zone, const Eigen::Vector3d& p, double depth)
{
  for (const double roundings : { depth, 16.0 * depth })
  {
    const Eigen::Vector3d within = nearestBeneath(zone.numbers, p, roundings);
    if (clearance(zone.enclosed, enclose(within)).certainlyNegative())
      return within;
  }
  return std::nullopt;
}

Eigen::Vector3d pointAround(const PlainZone<double>& zone, const Eigen::Vector3d& p)
{
  return nearestBeneath(zone, p, -ABOVE);
}

std::vector<ZoneToKeepOut> zonesToKeepOut(const std::vector<Zone>& zones, double tool_radius)
{
  std::vector<ZoneToKeepOut> result;
  for (const Zone& zone : zones)
    if (zone.use == Zone::Use::KEEP_OUT)
    {
      const EnclosedZone exact = enclosed(zone, tool_radius);
      result.push_back({ exact, plainZone(zoneOfForms<double>(exact)) });
    }
  return result;
}
}  // namespace pkm_workspace
