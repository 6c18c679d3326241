// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "pkm_workspace/interval/centered_box.h"
#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// Encloses the rotations about z, from x to y, by the angles of a bounded set [rad].
IntervalMatrix rotationsAboutZ(const Interval& angles);

/// The offset turned about z, in floating point.
Eigen::Vector3d turnedAboutZ(const Eigen::Vector3d& offset, double angle);
std::vector<GrowingVector> turnedAboutZ(const std::vector<GrowingVector>& offsets, double angle);

/// A function of the center and the angle: a member of the form over the center's delta in [-1, 1]^3, plus turn tau
/// with the angle's tau in [-1, 1], up to the radius of the turn.
struct TurningForm
{
  AffineForm<double> form;
  Enclosed<double> turn{};

  double upper() const { return overCenters().upper(); }
  double lower() const { return overCenters().lower(); }

private:
  /// With the turn in the radius.
  AffineForm<double> overCenters() const;
};

TurningForm operator+(const TurningForm& a, const TurningForm& b);
TurningForm operator*(const Enclosed<double>& s, const TurningForm& f);

/// The places c + R(t) k of points k of a body, over a box of centers c and angles t about z in [m - d, m + d].
///
/// With t = m + x and sin x = tau sin d, each is c + cos(x) a + tau sin(d) b, where a = R(m) k and b is a turned by a
/// quarter in the plane xy; and cos(x) lies in [cos d, 1]. So a place is affine in the center and tau, to second order.
class TurningBox
{
public:
  /// @param angles of a width below pi [rad]
  TurningBox(const Box& centers, const Interval& angles, double size, const std::vector<GrowingVector>& points);

  /// All centers and more: moved by a place, it holds those of its point.
  const CenteredBox<double>& box() const { return box_; }
  /// One offset for each point, at which box() is to be moved to.
  const std::vector<GrowingVector>& places() const { return places_; }
  /// What a form over the box moved by the place of point k says of center and angle.
  TurningForm formOf(std::size_t k, const AffineForm<double>& over_box) const;
  /// Where the place of point k is in that box, in floating point.
  std::array<double, 3> deltaOf(std::size_t k, const std::array<double, 3>& center, double turn) const;

private:
  using Enclosures = std::array<Enclosed<double>, 3>;

  void widenBy(const std::vector<IntervalVector>& sweeps);

  CenteredBox<double> box_;
  std::vector<GrowingVector> places_;
  Enclosures share_;                ///< of the center's delta, in that over the box
  std::vector<Enclosures> sweeps_;  ///< of tau, up to a radius that holds what is not affine
};
/// The offsets R(-t) (c - p) of a point p from bodies with centers c of a box that are turned by t in [m - d, m + d]
/// about z, seen from the point along the axes of the bodies: affine in center and tau, to second order. For x = t - m
/// and v = R(-m) (c - p) each is cos(x) v + tau sin(d) w, where w is v turned by a quarter in the plane xy.
class TurningOffset
{
public:
  /// @param angles of a width below pi [rad]
  TurningOffset(const Box& centers, const Interval& angles, const Eigen::Vector3d& point);

  /// Contains all of them [m].
  const Box& box() const { return box_; }
  /// What a form over that box says of center and angle.
  TurningForm formOf(const AffineForm<double>& over_box) const;

private:
  std::array<TurningForm, 3> coordinates_;
  Box box_;
};
}  // namespace pkm_workspace
