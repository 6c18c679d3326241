// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "pkm_workspace/machine/leg.h"

namespace pkm_workspace
{
namespace test
{
/// A leg whose loop is closed by geometry in 100 digits: by triangles, not by the formulas of forms. It has the middles
/// of its enclosures for numbers, its directions made unit vectors.
struct ClosedLeg
{
  using Number = boost::multiprecision::cpp_bin_float_100;
  using Vector = std::array<Number, 3>;

  bool reaches = true;
  Vector row;        ///< from what the joint moves to the platform point
  Number drive = 0;  ///< b, as transmission factors count it
  Number joint = 0;
  Number reach = 0;  ///< what its reach is measured by

  static Vector middle(const IntervalVector& v) { return { v[0].mid(), v[1].mid(), v[2].mid() }; }
  static Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector plus(const Vector& a, const Number& s, const Vector& b)
  {
    return { a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2] };
  }
  static Vector unit(const IntervalVector& v)
  {
    const Vector m = middle(v);
    return plus({ 0, 0, 0 }, 1 / sqrt(dot(m, m)), m);
  }
};

inline ClosedLeg legAt(const SlidingStrut& strut, const ClosedLeg::Vector& point)
{
  using Number = ClosedLeg::Number;
  ClosedLeg leg;
  const ClosedLeg::Vector e = ClosedLeg::unit(strut.axis);
  const ClosedLeg::Vector from = ClosedLeg::plus(point, -1, ClosedLeg::middle(strut.origin - strut.platform));
  const Number along = ClosedLeg::dot(e, from);
  const ClosedLeg::Vector across = ClosedLeg::plus(from, -along, e);
  const Number length = strut.length.mid();
  leg.reach = sqrt(ClosedLeg::dot(across, across));
  const Number radicand = length * length - leg.reach * leg.reach;
  leg.reaches = radicand >= 0;
  leg.drive = leg.reaches ? Number(strut.working_mode * sqrt(radicand)) : Number(0);
  leg.joint = along - leg.drive;
  leg.row = ClosedLeg::plus(from, -leg.joint, e);
  return leg;
}

inline ClosedLeg legAt(const TelescopicStrut& strut, const ClosedLeg::Vector& point)
{
  ClosedLeg leg;
  leg.row =
      ClosedLeg::plus(ClosedLeg::plus(point, 1, ClosedLeg::middle(strut.platform)), -1, ClosedLeg::middle(strut.foot));
  leg.drive = sqrt(ClosedLeg::dot(leg.row, leg.row));
  leg.joint = leg.drive - strut.length.mid();
  return leg;
}

/// The crank, the part of the forearm in the crank's plane and the line between their ends are a triangle: its angle at
/// the pivot, by the law of cosines, is between the crank and that line.
inline ClosedLeg legAt(const Crank& crank, const ClosedLeg::Vector& point)
{
  using Number = ClosedLeg::Number;
  using Vector = ClosedLeg::Vector;
  ClosedLeg leg;
  const Vector u = ClosedLeg::unit(crank.along);
  const Vector v = ClosedLeg::unit(crank.across);
  const Vector from =
      ClosedLeg::plus(ClosedLeg::plus(point, 1, ClosedLeg::middle(crank.platform)), -1, ClosedLeg::middle(crank.pivot));
  const Number along = ClosedLeg::dot(u, from), across = ClosedLeg::dot(v, from);
  const Number distance = sqrt(along * along + across * across);
  const Number sideways = ClosedLeg::dot(from, from) - distance * distance;
  const Number r = crank.radius.mid(), l = crank.length.mid();
  const Number in_plane = l * l - sideways;
  const Number cosine =
      distance > 0 ? Number((r * r + distance * distance - in_plane) / (2 * r * distance)) : Number(2);
  leg.reach = abs(cosine) * distance;
  leg.reaches = abs(cosine) <= 1;
  if (!leg.reaches)
    return leg;
  // ahead of the crank the forearm's end has a larger angle than the crank
  const Number angle = atan2(across, along) - crank.working_mode * acos(cosine);
  leg.row = ClosedLeg::plus(ClosedLeg::plus(from, -r * cos(angle), u), -r * sin(angle), v);
  leg.drive = (cos(angle) * ClosedLeg::dot(v, leg.row) - sin(angle) * ClosedLeg::dot(u, leg.row)) *
              (crank.drive_scale > 0.0 ? Number(r / crank.drive_scale) : Number(1));
  const Number turn = 2 * acos(Number(-1));
  leg.joint = angle - turn * round((angle - crank.reference) / turn);
  return leg;
}

inline ClosedLeg legAt(const Leg& leg, const ClosedLeg::Vector& point)
{
  return visitLeg([&](const auto& kind) { return legAt(kind, point); }, leg.kind);
}

/// b over |n| cos phi, phi the angle between strut and the way of what the joint moves.
inline ClosedLeg::Number gearOfDrive(const Leg& leg)
{
  const auto* const crank = std::get_if<Crank>(&leg.kind);
  return crank && crank->drive_scale > 0.0 ? ClosedLeg::Number(crank->radius.mid()) / crank->drive_scale : 1;
}

/// By what a joint velocity is multiplied before transmission factors compare it with others.
inline ClosedLeg::Number scaleOf(const Leg& leg)
{
  const auto* const crank = std::get_if<Crank>(&leg.kind);
  return !crank ? 1.0 : crank->drive_scale > 0.0 ? crank->drive_scale : crank->radius.mid();
}
}  // namespace test
}  // namespace pkm_workspace
