// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "checked_claims.h"

namespace pkm_workspace
{
namespace checking
{
/// Enough digits for sums of products of any four doubles: where bodies end is compared without rounding.
using Exact =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<2600>, boost::multiprecision::et_off>;

/// What a body measures: fixed + h per_size.
struct Measure
{
  double fixed = 0.0;
  double per_size = 0.0;
  Exact at(double h) const { return Exact(fixed) + Exact(h) * Exact(per_size); }
};

/// A family of bodies c + K(h): a box, a ball or an upright cylinder.
class CheckedBody
{
public:
  explicit CheckedBody(const Json& json);

  /// Along how many axes it is round: 0, 2 or 3.
  std::size_t round() const { return round_; }
  const Measure& lower(std::size_t axis) const { return lower_[axis]; }
  const Measure& upper(std::size_t axis) const { return upper_[axis]; }
  const Measure& radius() const { return upper_[0]; }
  /// Whether both parts of the family have a point.
  bool has(const Numbers& fixed, const Numbers& per_size) const;
  /// What is not negative for centers c of a box whose bodies do not have the point; nothing where that is no single
  /// function.
  std::optional<Jet> avoidance(const Numbers& point, const Cube& centers, double h) const;

private:
  std::size_t round_;
  std::array<Measure, 3> lower_;
  std::array<Measure, 3> upper_;
};

/// An enclosure.
Ball ballOf(const Exact& x);

/// A point of a box, as delta.
using Corner = std::array<Ball, 3>;
std::vector<Corner> cornersOfCube();
/// Whether the criterion, but for the aspect where psi_min is asked for, holds for all delta in the hull of the
/// corners.
bool isGood(const CheckedClaims& claims, const JetVector& points, const std::vector<Corner>& corners);
/// Whether a point is in the aspect, where psi_min is asked for: that keeps det A from 0, so that one point of a
/// connected set settles its sign.
bool isInAspect(const CheckedClaims& claims, const JetVector& point);

/// Every point of c + K(h) satisfies the criterion.
class RegionCheck
{
public:
  RegionCheck(const CheckedClaims& claims, const CheckedBody& body, const Json& json);
  /// @param leaf is called for each leaf that holds @throws Refused
  void run(const std::function<void()>& leaf) const;

private:
  bool holds(const Cube& box) const;
  bool isBeyond(const Cube& box) const;
  std::vector<Corner> cornersOf(const Cube& box) const;

  const CheckedClaims& claims_;
  const CheckedBody& body_;
  const Json& json_;
  Numbers center_;
  double size_;
  std::array<Exact, 3> lower_;
  std::array<Exact, 3> upper_;
  Exact radius_;
};

/// The points of a box, as far as they are proved to satisfy the criterion, or not to.
class BoxesCheck
{
public:
  BoxesCheck(const CheckedClaims& claims, const Json& json);
  /// @return a sentence on what holds
  std::string run(const std::function<void()>& leaf) const;

private:
  bool excludes(const Question& question, const Cube& box) const;

  const CheckedClaims& claims_;
  const Json& json_;
};

/// Every point of straight segments satisfies it.
/// @return a sentence on that
std::string checkPath(const CheckedClaims& claims, const Json& json, const std::function<void()>& leaf);

/// No c + K(h) with h above the bound satisfies it.
class BoundCheck
{
public:
  BoundCheck(const CheckedClaims& claims, const CheckedBody& body, const Json& json);
  void run(const std::function<void()>& leaf) const;

private:
  struct Point
  {
    Numbers fixed;
    Numbers per_size;
  };
  struct BadPoint
  {
    Numbers point;
    Question why;
  };
  struct Term
  {
    double weight = 0.0;
    std::optional<std::size_t> bad;  ///< its number; of others:
    std::size_t at = 0;              ///< the number of the point of the body
    Question question;
  };

  void readPoints();
  bool hasAllCenters(const Cube& box) const;
  bool isWithin(std::size_t axis, int sign, double face) const;
  bool isWithinReach(const Vector& u, const Ball& most) const;
  const SlidingLeg& slider(std::size_t leg) const;
  bool isWithinPlaces(const SlidingLeg& leg, const Vector& u, const Ball& most) const;
  Term termOf(const Json& json) const;
  int push(const Question& question) const;
  bool excludes(const std::vector<Term>& terms, double size, const Cube& box) const;
  bool excludesByTravel(const Jet& sum, const Exact& travel, const Cube& box) const;

  const CheckedClaims& claims_;
  const CheckedBody& body_;
  const Json& json_;
  double size_;
  Cube centers_;
  std::optional<Cube> search_box_;
  std::optional<std::size_t> travel_axis_;
  std::vector<Point> points_;
  std::vector<BadPoint> bad_;
};
}  // namespace checking
}  // namespace pkm_workspace
