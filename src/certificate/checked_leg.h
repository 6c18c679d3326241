// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "checked_json.h"

namespace pkm_workspace
{
namespace checking
{
/// One leg at a point: the row n and the square of the drive b, with n . pdot = b qdot.
struct LegAt
{
  JetVector row;
  Jet squared_drive;
  Jet joint;                    ///< its value, of what is a length
  std::array<Jet, 2> tip = {};  ///< of a crank: r cos th, r sin th
};

/// A leg, by formulas of its own: see docs/certificate.md.
class CheckedLeg
{
public:
  virtual ~CheckedLeg() = default;

  virtual LegAt at(const JetVector& p) const = 0;
  /// n^2 - square b^2.
  virtual Jet diagonal(const LegAt& at, const Ball& square) const = 0;
  /// How far the joint is on the right side of a limit. @pre there is one
  virtual Jet fromLimit(int side, const LegAt& at) const = 0;
  /// E v, for the projection E of which |E (p - center)| is bounded where the leg reaches p.
  virtual Vector across(const Vector& v) const = 0;
  /// No v . E (p - center) is larger.
  virtual Ball offset(const Vector& v) const = 0;
  /// No u . p is larger, by this leg alone; nothing where that is without bound.
  virtual std::optional<Ball> farthest(const Vector& u, bool is_limited) const = 0;

  /// Joint limits; nothing where there is none.
  const std::optional<double>& limit(int side) const { return limits_[static_cast<std::size_t>(side)]; }
  const Vector& center() const { return center_; }
  /// What b^2 is at least wherever the criterion holds [m^2].
  const Ball::Middle& least() const { return least_; }

protected:
  explicit CheckedLeg(const Json& json);
  JetVector fromCenter(const JetVector& p) const { return { p[0] - center_[0], p[1] - center_[1], p[2] - center_[2] }; }

  Vector center_;
  std::array<std::optional<double>, 2> limits_;
  Ball::Middle least_ = 0;
};

/// A strut of length L from a foot that slides along an axis: (p - center - q axis)^2 = L^2.
class SlidingLeg : public CheckedLeg
{
public:
  /// @param directions of rails, of length 1 @param steepest the largest |n / b| that is asked for, if any
  SlidingLeg(const Json& json, const std::vector<Vector>& directions, const std::optional<Ball>& steepest);

  LegAt at(const JetVector& p) const override;
  Jet diagonal(const LegAt& at, const Ball& square) const override;
  Jet fromLimit(int side, const LegAt& at) const override;
  Vector across(const Vector& v) const override;
  Ball offset(const Vector& v) const override;
  std::optional<Ball> farthest(const Vector& u, bool is_limited) const override;

  const Vector& axis() const { return axis_; }
  int sense() const { return sense_; }
  std::size_t direction() const { return direction_; }
  /// Whether the rail runs along a coordinate axis.
  bool isAlong(std::size_t axis) const { return axis_of_rail_ == static_cast<int>(axis); }

private:
  std::size_t direction_;
  Vector axis_;
  int axis_of_rail_ = -1;  ///< if it is one
  int sense_;
  int mode_;
  Ball length_;
  Ball radius_;  ///< of the points across the rail [m]
};

/// A strut of variable length: q is |p - center| less its length at 0.
class TelescopicLeg : public CheckedLeg
{
public:
  explicit TelescopicLeg(const Json& json);

  LegAt at(const JetVector& p) const override;
  Jet diagonal(const LegAt& at, const Ball& square) const override;
  Jet fromLimit(int side, const LegAt& at) const override;
  Vector across(const Vector& v) const override;
  Ball offset(const Vector& v) const override;
  std::optional<Ball> farthest(const Vector& u, bool is_limited) const override;

private:
  Ball length_;
};

/// A crank of radius r about a fixed axis, with its tip at r (u cos th + v sin th), and a forearm of length L from
/// there to p - center.
class CrankLeg : public CheckedLeg
{
public:
  CrankLeg(const Json& json, const std::optional<Ball>& steepest);

  LegAt at(const JetVector& p) const override;
  Jet diagonal(const LegAt& at, const Ball& square) const override;
  Jet fromLimit(int side, const LegAt& at) const override;
  Vector across(const Vector& v) const override;
  Ball offset(const Vector& v) const override;
  std::optional<Ball> farthest(const Vector& u, bool is_limited) const override;

private:
  Vector u_;
  Vector v_;
  Ball radius_;
  Ball length_;
  int mode_;
  Ball gear_;  ///< r over the drive scale
  Ball::Middle least_beta_ = 0;
};

std::unique_ptr<const CheckedLeg> readLeg(const Json& json, const std::vector<Vector>& directions,
                                          const std::optional<Ball>& steepest);
}  // namespace checking
}  // namespace pkm_workspace
