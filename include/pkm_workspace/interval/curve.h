// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pkm_workspace/interval/enclosed_constants.h"
#include "pkm_workspace/interval/interval_vector.h"
#include "pkm_workspace/interval/skew_box.h"

namespace pkm_workspace
{
/// A piece of a curve: a box with edges along it that holds its points, and one that holds the unit vectors along the
/// way there (0 where the curve is a point).
struct CurvePiece
{
  SkewBox<double> points;    ///< [m]
  SkewBox<double> tangents;  ///< over the same delta
};

/// Encloses the sine and cosine of every angle of a bounded set, to some roundings and its own radius.
struct SineCosine
{
  Enclosed<double> sine;
  Enclosed<double> cosine;

  explicit SineCosine(const Interval& angle);
};

/// The curve p(t) = origin + t drift + cos(t angle) u + sin(t angle) w, t in [0, 1]: a line (u = w = 0), an arc
/// (drift = 0), a helix. Enclosures [m], [rad].
class Curve
{
public:
  static Curve line(const Eigen::Vector3d& start, const Eigen::Vector3d& end);
  /// @param u, @param w of one length, perpendicular to each other and to @p drift
  Curve(const IntervalVector& origin, const IntervalVector& drift, const IntervalVector& u, const IntervalVector& w,
        const Interval& angle);

  const Interval& angle() const { return angle_; }
  /// Encloses the length of the curve [m].
  const Interval& length() const { return length_; }

  /// Encloses p(t) for t from first to last, tightly to second order: with a = (first + last) angle / 2 and
  /// b = (last - first) angle / 2, cos(b d) lies in [cos b, 1], and sin(b d) - d sin b within b^3 / (9 sqrt 3) for d in
  /// [-1, 1] (the error of interpolation in -1, 0, 1).
  CurvePiece piece(double first, double last) const;
  /// Encloses the second derivatives of the points by the length of the way there [1/m], over the same delta.
  SkewBox<double> curvatures(double first, double last) const;
  /// Encloses p(t).
  IntervalVector point(double t) const;

private:
  /// What turns: factors for the directions of radius and tangent in the middle of a piece.
  struct Turn
  {
    SineCosine middle;
    Enclosed<double> center;  ///< of cos(b d)
    Enclosed<double> radial;  ///< half the range of cos(b d)
    Enclosed<double> along;   ///< slope of sin(b d)
    double bend;              ///< a bound on what is left of sin(b d)

    Turn(const Interval& angle, const Interval& half_angle);
  };

  Curve(const Eigen::Vector3d& start, const IntervalVector& drift);
  void setDirection(const IntervalVector& drift);
  /// The middle of a piece, and half its length.
  struct Middle
  {
    double t, h;

    Middle(double first, double last);
  };
  /// The piece about t of half length h.
  CurvePiece straightPiece(double t, double h) const;
  CurvePiece turningPiece(double t, double h) const;

  EnclosedVector<double> origin_, drift_, u_, w_;
  EnclosedVector<double> drift_direction_;  ///< drift over the length
  Enclosed<double> turning_;                ///< angle over the length [rad/m]
  Interval angle_, length_;
};
}  // namespace pkm_workspace
