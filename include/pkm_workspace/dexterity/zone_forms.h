// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/plain_vector.h"
#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// A zone in one arithmetic, moved outward (to keep out) or inward (to keep in) by the tool's radius at each of its
/// surfaces: a box stays a box. With u = turn (p - center) it is where all depths of eachDepth() are not negative.
template <class Number, class Vector, class Matrix>
struct ZoneConstants
{
  Zone::Use use;
  Zone::Kind kind;
  bool has_ends;  ///< of a cylinder
  Matrix turn;    ///< rows: the axes of the zone; of a half-space only the first one, its normal of length 1
  Vector center;  ///< [m]
  /// Of a box half its sides; of a cylinder (radius, radius, half the height); of a sphere the radius; of a half-space
  /// how far its surface was moved [m].
  std::array<Number, 3> half;
  Number squared_radius;     ///< of a cylinder or sphere [m^2]
  Number per_diameter = {};  ///< 1 over twice the radius [1/m]
};

using EnclosedZone = ZoneConstants<Interval, IntervalVector, IntervalMatrix>;
template <class Real>
using ZoneOfForms = ZoneConstants<Enclosed<Real>, EnclosedVector<Real>, EnclosedMatrix<Real>>;
template <class Real>
using PlainZone = ZoneConstants<Real, PlainVector<Real>, PlainMatrix<Real>>;

/// @pre the zone is valid with this radius
EnclosedZone enclosed(const Zone& zone, double tool_radius);

/// For affine forms in a type Real.
template <class Real, class Number, class Vector, class Matrix>
ZoneOfForms<Real> zoneOfForms(const ZoneConstants<Number, Vector, Matrix>& zone)
{
  ZoneOfForms<Real> result{ zone.use,
                            zone.kind,
                            zone.has_ends,
                            EnclosedMatrix<Real>(zone.turn),
                            EnclosedVector<Real>(zone.center),
                            {},
                            Enclosed<Real>(zone.squared_radius),
                            Enclosed<Real>(zone.per_diameter) };
  for (std::size_t k = 0; k < 3; ++k)
    result.half[k] = Enclosed<Real>(zone.half[k]);
  return result;
}

/// Rounded: for finding points, not for proving anything.
template <class Real>
PlainZone<Real> plainZone(const ZoneOfForms<Real>& zone)
{
  return { zone.use,
           zone.kind,
           zone.has_ends,
           zone.turn.value,
           zone.center.value,
           { zone.half[0].value, zone.half[1].value, zone.half[2].value },
           zone.squared_radius.value,
           zone.per_diameter.value };
}

/// How deep a point is beneath a round surface [m]: of the sign of R - r, and near to it there, for r^2 = @p squared.
template <class Number, class Vector, class Matrix, class Coordinate>
Coordinate roundDepth(const ZoneConstants<Number, Vector, Matrix>& zone, const Coordinate& squared)
{
  return zone.per_diameter * (zone.squared_radius - squared);
}
/// The same exactly.
inline Interval roundDepth(const EnclosedZone& zone, const Interval& squared)
{
  return zone.half[0] - sqrt(squared);
}

/// Tells how deep a point u of the zone's own axes is beneath each of its surfaces [m].
template <class Number, class Vector, class Matrix, class Coordinate, class Tell>
void eachDepth(const ZoneConstants<Number, Vector, Matrix>& zone, const std::array<Coordinate, 3>& u, const Tell& tell)
{
  const auto between = [&](std::size_t k) {
    tell(zone.half[k] - u[k]);
    tell(u[k] + zone.half[k]);
  };
  const auto square = [&u](std::size_t k) {
    if constexpr (std::is_same<Coordinate, Interval>::value)
      return sqr(u[k]);
    else
      return u[k] * u[k];
  };
  switch (zone.kind)
  {
    case Zone::Kind::BOX:
      for (std::size_t k = 0; k < 3; ++k)
        between(k);
      break;
    case Zone::Kind::CYLINDER:
      tell(roundDepth(zone, square(0) + square(1)));
      if (zone.has_ends)
        between(2);
      break;
    case Zone::Kind::SPHERE:
      tell(roundDepth(zone, square(0) + square(1) + square(2)));
      break;
    case Zone::Kind::HALF_SPACE:
      tell(u[0] + zone.half[0]);
      break;
  }
}

/// How far the tool point keeps within a zone to keep in, or out of one to keep out, in any arithmetic.
template <class Number, class Vector, class Matrix, class Coordinate, class Least, class Largest>
Coordinate clearanceOf(const ZoneConstants<Number, Vector, Matrix>& zone, const std::array<Coordinate, 3>& u,
                       const Least& least, const Largest& largest)
{
  std::optional<Coordinate> clearance;
  eachDepth(zone, u, [&](const Coordinate& depth) {
    if (zone.use == Zone::Use::KEEP_IN)
      clearance = clearance ? least(*clearance, depth) : depth;
    else
      clearance = clearance ? largest(*clearance, -depth) : -depth;
  });
  return *clearance;
}

/// Encloses it over points p [m].
Interval clearance(const EnclosedZone& zone, const IntervalVector& p);

/// Whether nothing of the zone changes along the direction e.
bool runsAlong(const EnclosedZone& zone, const IntervalVector& e);

/// Encloses the points that satisfy the zone; all of space where it does not bound them along the axes.
Box boundsOf(const EnclosedZone& zone);

/// A zone that the tool keeps out of, exactly and in floating point.
struct ZoneToKeepOut
{
  EnclosedZone enclosed;
  PlainZone<double> numbers;
};
std::vector<ZoneToKeepOut> zonesToKeepOut(const std::vector<Zone>& zones, double tool_radius);

/// How the zone is seen from axes that are turned about the vertical through the center [m, rad].
PlainZone<double> turnedBack(const PlainZone<double>& zone, const Eigen::Vector3d& center, double angle);
/// The point of the zone nearest to p [m]; floating point.
Eigen::Vector3d nearestOf(const PlainZone<double>& zone, const Eigen::Vector3d& p);
/// The same of what a round zone is all round: the center of a sphere, the axis of a cylinder.
Eigen::Vector3d nearestOfCore(const PlainZone<double>& zone, const Eigen::Vector3d& p);
/// A point that is proved to lie beneath the zone's surface, hardly farther from p [m] than any other; nothing where
/// doubles do not tell. @param depth how far beneath at the least, in roundings of the largest length
std::optional<Eigen::Vector3d> pointWithin(const ZoneToKeepOut& zone, const Eigen::Vector3d& p, double depth = 16.0);
/// The point nearest to p on a surface that lies above its own by so little that a region beside it can be proved.
Eigen::Vector3d pointAround(const PlainZone<double>& zone, const Eigen::Vector3d& p);
}  // namespace pkm_workspace
