// SPDX-License-Identifier: BSD-3-Clause
#include "checked_leg.h"

namespace pkm_workspace
{
namespace checking
{
namespace
{
int signOf(const Json& json, const char* name)
{
  const double value = numberOf(json.at(name));
  need(value == 1.0 || value == -1.0, std::string(name) + " is neither 1 nor -1");
  return static_cast<int>(value);
}

Ball lengthOf(const Json& json, const char* name)
{
  const Ball length = checking::ballOf(json.at(name));
  need(length.isPositive(), std::string(name) + " is not positive");
  return length;
}

Ball norm(const Vector& v)
{
  return sqrt(scalarProduct(v, v));
}

bool isNone(const Ball& x)
{
  return x.middle() == 0 && x.radius() == 0.0;
}
}  // namespace

CheckedLeg::CheckedLeg(const Json& json)
{
  center_ = vectorOf(json.at("center"));
  const Json& limits = json.at("limits");
  need(limits.is_array() && limits.size() == 2, "joint limits are missing");
  for (std::size_t side = 0; side < 2; ++side)
    if (!limits[side].is_null())
      limits_[side] = numberOf(limits[side]);
  need(!limits_[0] || !limits_[1] || *limits_[0] <= *limits_[1], "joint limits that leave nothing");
}

SlidingLeg::SlidingLeg(const Json& json, const std::vector<Vector>& directions, const std::optional<Ball>& steepest)
  : CheckedLeg(json)
{
  expect(json, "a leg", { "joint", "kind", "center", "direction", "sense", "length", "working_mode", "limits" });
  direction_ = indexOf(json.at("direction"), directions.size());
  const Vector& direction = directions[direction_];
  sense_ = signOf(json, "sense");
  mode_ = signOf(json, "working_mode");
  for (std::size_t k = 0; k < 3; ++k)
  {
    axis_[k] = Ball(sense_) * direction[k];
    if (isNone(direction[(k + 1) % 3]) && isNone(direction[(k + 2) % 3]))
      axis_of_rail_ = static_cast<int>(k);
  }
  length_ = lengthOf(json, "length");
  radius_ = length_;
  if (!steepest)
    return;
  // b^2 >= (L / steepest)^2, by |n| = L; so |q|^2 = L^2 - b^2 is at most the rest
  least_ = (length_ / *steepest * (length_ / *steepest)).lower();
  radius_ = length_ * sqrt(Ball(1.0) - Ball(1.0) / (*steepest * *steepest));
}

Vector SlidingLeg::across(const Vector& v) const
{
  const Ball along = scalarProduct(axis_, v);
  return { v[0] - along * axis_[0], v[1] - along * axis_[1], v[2] - along * axis_[2] };
}

Ball SlidingLeg::offset(const Vector& v) const
{
  return norm(across(v)) * radius_;
}

/// p = c + q + (rho + b) e with 0 <= |b| <= L.
std::optional<Ball> SlidingLeg::farthest(const Vector& u, bool is_limited) const
{
  if (!is_limited || !limits_[0] || !limits_[1])
    return std::nullopt;
  const Ball slope = scalarProduct(u, axis_);
  const Ball length = Ball(length_.upper(), 0.0);
  const Ball least = slope * (Ball(*limits_[0]) + (mode_ < 0 ? -length : Ball(0.0)));
  const Ball most = slope * (Ball(*limits_[1]) + (mode_ > 0 ? length : Ball(0.0)));
  return scalarProduct(u, center_) + offset(u) + (least.upper() > most.upper() ? least : most);
}

LegAt SlidingLeg::at(const JetVector& p) const
{
  const JetVector x = fromCenter(p);
  const Jet along = scalarProduct(axis_, x);
  LegAt leg;
  Jet squared_distance;
  for (std::size_t k = 0; k < 3; ++k)
  {
    leg.row[k] = x[k] - axis_[k] * along;
    squared_distance = squared_distance + leg.row[k] * leg.row[k];
  }
  leg.squared_drive = Jet(length_ * length_) - squared_distance;
  const Jet drive = Ball(mode_) * rootAbove(leg.squared_drive, least_);
  for (std::size_t k = 0; k < 3; ++k)
    leg.row[k] = leg.row[k] + axis_[k] * drive;
  leg.joint = along - drive;
  return leg;
}

/// |n| = L.
Jet SlidingLeg::diagonal(const LegAt& at, const Ball& square) const
{
  return Jet(length_ * length_) - square * at.squared_drive;
}

Jet SlidingLeg::fromLimit(int side, const LegAt& at) const
{
  return side == 0 ? at.joint - Jet(Ball(*limit(0))) : Jet(Ball(*limit(1))) - at.joint;
}

TelescopicLeg::TelescopicLeg(const Json& json) : CheckedLeg(json)
{
  expect(json, "a leg", { "joint", "kind", "center", "length", "limits" });
  length_ = lengthOf(json, "length");
}

LegAt TelescopicLeg::at(const JetVector& p) const
{
  LegAt leg;
  leg.row = fromCenter(p);
  leg.squared_drive = scalarProduct(leg.row, leg.row);
  leg.joint = rootAbove(leg.squared_drive, 0) - Jet(length_);
  return leg;
}

/// n = p - center and b = |n|.
Jet TelescopicLeg::diagonal(const LegAt& at, const Ball& square) const
{
  return (Ball(1.0) - square) * at.squared_drive;
}

Jet TelescopicLeg::fromLimit(int side, const LegAt& at) const
{
  return side == 0 ? at.joint - Jet(Ball(*limit(0))) : Jet(Ball(*limit(1))) - at.joint;
}

Vector TelescopicLeg::across(const Vector& /*v*/) const
{
  return {};
}

Ball TelescopicLeg::offset(const Vector& /*v*/) const
{
  return {};
}

std::optional<Ball> TelescopicLeg::farthest(const Vector& u, bool is_limited) const
{
  if (!is_limited || !limit(1))
    return std::nullopt;
  return scalarProduct(u, center_) + norm(u) * (length_ + Ball(*limit(1)));
}

CrankLeg::CrankLeg(const Json& json, const std::optional<Ball>& steepest) : CheckedLeg(json)
{
  expect(json, "a leg",
         { "joint", "kind", "center", "along", "across", "radius", "length", "working_mode", "drive_scale", "limits" });
  u_ = vectorOf(json.at("along"));
  v_ = vectorOf(json.at("across"));
  const auto isOff = [](const Ball& x) { return x.isPositive() || x.isNegative(); };
  need(!isOff(scalarProduct(u_, u_) - Ball(1.0)) && !isOff(scalarProduct(v_, v_) - Ball(1.0)) &&
           !isOff(scalarProduct(u_, v_)),
       "the directions of a crank are no unit vectors across each other");
  radius_ = lengthOf(json, "radius");
  length_ = lengthOf(json, "length");
  mode_ = signOf(json, "working_mode");
  gear_ = json.at("drive_scale").is_null() ? Ball(1.0) : radius_ / lengthOf(json, "drive_scale");
  need(limit(0).has_value() == limit(1).has_value(), "a crank with one limit");
  need(!limit(0) || (*limit(1) > *limit(0) && *limit(1) - *limit(0) <= 3.14 && std::abs(*limit(0)) <= 8.0 &&
                     std::abs(*limit(1)) <= 8.0),
       "limits of a crank that are a half turn apart, or beyond 8 rad");
  if (!steepest)
    return;
  const Ball drive = length_ / *steepest;
  least_ = (drive * drive).lower();
  least_beta_ = (drive / gear_ * (drive / gear_)).lower();
}

LegAt CrankLeg::at(const JetVector& p) const
{
  const JetVector x = fromCenter(p);
  const Jet x_u = scalarProduct(u_, x);
  const Jet x_v = scalarProduct(v_, x);
  const Jet m = x_u * x_u + x_v * x_v;
  const Jet k = Ball(0.5) / radius_ * (scalarProduct(x, x) + Jet(radius_ * radius_ - length_ * length_));
  const Jet squared_beta = m - k * k;
  const Jet beta = Ball(mode_) * rootAbove(squared_beta, least_beta_);
  LegAt leg;
  leg.squared_drive = gear_ * gear_ * squared_beta;
  leg.tip = { Jet(Ball(0, radius_.most())), Jet(Ball(0, radius_.most())) };
  if (m.range().isPositive())
    leg.tip = { radius_ * ((k * x_u + beta * x_v) / m), radius_ * ((k * x_v - beta * x_u) / m) };
  for (std::size_t j = 0; j < 3; ++j)
    leg.row[j] = x[j] - u_[j] * leg.tip[0] - v_[j] * leg.tip[1];
  return leg;
}

/// |n| = L.
Jet CrankLeg::diagonal(const LegAt& at, const Ball& square) const
{
  return Jet(length_ * length_) - square * at.squared_drive;
}

/// r sin of the angle from the lower limit, or to the upper one: with less than a half turn between them, both together
/// say that the joint is there.
Jet CrankLeg::fromLimit(int side, const LegAt& at) const
{
  const Ball::Middle angle = *limit(side);
  const Ball cosine(cos(angle), 0x1p-130);
  const Ball sine(sin(angle), 0x1p-130);
  const Jet beyond = cosine * at.tip[1] - sine * at.tip[0];
  return side == 0 ? beyond : -beyond;
}

Vector CrankLeg::across(const Vector& v) const
{
  return v;
}

Ball CrankLeg::offset(const Vector& v) const
{
  return norm(v) * (radius_ + length_);
}

std::optional<Ball> CrankLeg::farthest(const Vector& u, bool /*is_limited*/) const
{
  return scalarProduct(u, center_) + offset(u);
}

std::unique_ptr<const CheckedLeg> readLeg(const Json& json, const std::vector<Vector>& directions,
                                          const std::optional<Ball>& steepest)
{
  const Json& kind = json.at("kind");
  if (kind == "sliding_strut")
    return std::make_unique<SlidingLeg>(json, directions, steepest);
  if (kind == "telescopic_strut")
    return std::make_unique<TelescopicLeg>(json);
  need(kind == "crank", "a leg of a kind that is not known here");
  return std::make_unique<CrankLeg>(json, steepest);
}
}  // namespace checking
}  // namespace pkm_workspace
