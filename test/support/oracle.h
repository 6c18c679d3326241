// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "closed_leg.h"
#include "driven_tool.h"
#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/machine/machine.h"
#include "zones.h"

namespace pkm_workspace
{
namespace test
{
/// Decides a criterion at a point in 100 digits, by the definitions (docs/theory.md) and by leading minors. The
/// machine is the member of its enclosure that has their middles for numbers: what is proved holds for it too.
class Oracle
{
public:
  using Number = ClosedLeg::Number;
  using Vector = ClosedLeg::Vector;

  Oracle(const Machine& machine, const Criterion& criterion) : machine_(machine), criterion_(criterion) {}

  bool isGood(const Eigen::Vector3d& point) const { return isGood(Vector{ point.x(), point.y(), point.z() }); }

  bool isGood(const Vector& point) const
  {
    if (!keepsToZones(criterion_.zones, criterion_.tool_radius, point))
      return false;
    std::array<Vector, 3> strut;
    Vector eta;
    for (int i = 0; i < 3; ++i)
      if (!solveLeg(i, point, strut[static_cast<std::size_t>(i)], eta[static_cast<std::size_t>(i)]))
        return false;
    const int wanted = criterion_.aspect == Criterion::Aspect::OTHER ? -machine_.aspect() : machine_.aspect();
    if (criterion_.aspect != Criterion::Aspect::BOTH && wanted * det(strut) <= 0)
      return false;
    const auto isWithin = [&](const Number& lower, const Number& upper) {
      return (lower == 0 || isSemidefinite(strut, eta, lower, 1)) &&
             (upper == 0 || isSemidefinite(strut, eta, upper, -1));
    };
    const auto inverse = [](double factor) { return factor > 0.0 ? 1 / Number(factor) : Number(0); };
    return (criterion_.set == Criterion::Set::REACHABLE || isWithin(criterion_.psi_min, criterion_.psi_max)) &&
           isWithin(inverse(criterion_.force_max), inverse(criterion_.force_min)) &&
           (criterion_.kappa_max == 0.0 || condition(strut, eta) <= criterion_.kappa_max) && drivesAreGood(strut, eta);
  }

  /// det A [m^3]; the point must be reachable.
  Number determinant(const Vector& point) const
  {
    std::array<Vector, 3> strut;
    Number eta;
    for (int i = 0; i < 3; ++i)
      solveLeg(i, point, strut[static_cast<std::size_t>(i)], eta);
    return det(strut);
  }

  /// The joint value of leg i [m], of a crank [rad]; the point must be reachable.
  Number joint(int i, const Vector& point) const { return legAt(machine_.leg(i), point).joint; }

  /// What a limit is about, at a point that all struts reach; for its reach anywhere.
  Number valueOf(const Limit& limit, const Vector& point) const
  {
    using Kind = Limit::Kind;
    if (limit.kind == Kind::KEEP_IN || limit.kind == Kind::KEEP_OUT)
      return ZoneOracle(criterion_.zones.at(static_cast<std::size_t>(limit.which)), criterion_.tool_radius)
          .clearance(point);
    if (limit.kind == Kind::REACH)
      return legAt(machine_.leg(limit.leg), point).reach;
    if (limit.kind == Kind::JOINT_LOWER || limit.kind == Kind::JOINT_UPPER)
      return joint(limit.leg, point);
    std::array<Vector, 3> strut;
    Vector eta;
    for (int i = 0; i < 3; ++i)
      solveLeg(i, point, strut[static_cast<std::size_t>(i)], eta[static_cast<std::size_t>(i)]);
    if (limit.kind == Kind::ASPECT)
    {
      const int wanted = criterion_.aspect == Criterion::Aspect::OTHER ? -machine_.aspect() : machine_.aspect();
      return wanted * det(strut) / (length(strut[0]) * length(strut[1]) * length(strut[2]));
    }
    if (limit.kind == Kind::BALL_TILT_MAX)
      return limit.leg < 0 ? largestTilt(strut) : tiltOf(limit.leg, strut[static_cast<std::size_t>(limit.leg)]);
    if (limit.kind == Kind::STRUT_ANGLE_MIN || limit.kind == Kind::STRUT_ANGLE_MAX)
      return DrivenTool(criterion_, strut, alongWays(eta)).valueOf(limit.kind);
    if (limit.kind >= Kind::TOOL_SPEED_MIN)
      return DrivenTool(criterion_, strut, perJoint(eta)).valueOf(limit.kind);
    const auto [least, largest] = squaredFactors(strut, eta);
    switch (limit.kind)
    {
      case Kind::PSI_MIN:
        return sqrt(least);
      case Kind::PSI_MAX:
        return sqrt(largest);
      case Kind::FORCE_MIN:
        return 1 / sqrt(largest);
      case Kind::FORCE_MAX:
        return 1 / sqrt(least);
      case Kind::KAPPA_MAX:
        return sqrt(largest / least);
      default:
        throw std::logic_error("the oracle does not know " + name(limit.kind));
    }
  }

private:
  static Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  static Number det(const std::array<Vector, 3>& m)
  {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }

  /// @param eta b, as transmission factors count it @return false where the leg does not reach or a limit is passed
  bool solveLeg(int i, const Vector& point, Vector& strut, Number& eta) const
  {
    const Leg& leg = machine_.leg(i);
    const ClosedLeg at = legAt(leg, point);
    strut = at.row;
    eta = at.drive;
    return at.reaches &&
           (!criterion_.joint_limits || (at.joint >= leg.limits.lower() && at.joint <= leg.limits.upper()));
  }

  Number length(const Vector& row) const { return sqrt(dot(row, row)); }

  /// The struts' parts along the ways of what joints move.
  Vector alongWays(const Vector& eta) const
  {
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = eta[i] / gearOfDrive(machine_.legs()[i]);
    return result;
  }

  /// b of joint velocities as they are, not times the drive scales.
  Vector perJoint(const Vector& eta) const
  {
    Vector result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = eta[i] * scaleOf(machine_.legs()[i]);
    return result;
  }

  /// Speeds, forces, stiffness, errors and angles.
  bool drivesAreGood(const std::array<Vector, 3>& strut, const Vector& eta) const
  {
    if (!criterion_.boundsMore())
      return true;
    const DrivenTool tool(criterion_, strut, perJoint(eta));
    const DrivenTool angled(criterion_, strut, alongWays(eta));
    const auto isKept = [&](Limit::Kind kind, double bound, bool is_lower) {
      if (kind == Limit::Kind::STRUT_ANGLE_MIN || kind == Limit::Kind::STRUT_ANGLE_MAX)
        return bound == 0.0 || (is_lower ? angled.valueOf(kind) >= bound : angled.valueOf(kind) <= bound);
      return bound == 0.0 || (is_lower ? tool.valueOf(kind) >= bound : tool.valueOf(kind) <= bound);
    };
    using Kind = Limit::Kind;
    return isKept(Kind::TOOL_SPEED_MIN, criterion_.tool_speed_min, true) &&
           isKept(Kind::TOOL_FORCE_MIN, criterion_.tool_force_min, true) &&
           isKept(Kind::STIFFNESS_MIN, criterion_.stiffness_min, true) &&
           isKept(Kind::POSITION_ERROR_MAX, criterion_.position_error_max, false) &&
           isKept(Kind::STRUT_ANGLE_MIN, criterion_.strut_angle_min, true) &&
           isKept(Kind::STRUT_ANGLE_MAX, criterion_.strut_angle_max, false) && tiltsAreGood(strut) &&
           hingesAreGood(strut);
  }

  Number largestTilt(const std::array<Vector, 3>& strut) const
  {
    return std::max({ tiltOf(0, strut[0]), tiltOf(1, strut[1]), tiltOf(2, strut[2]) });
  }

  /// Each strut within the tilt of all, and within its own.
  bool tiltsAreGood(const std::array<Vector, 3>& strut) const
  {
    for (int i = 0; criterion_.ball_tilt_max > 0.0 && i < 3; ++i)
    {
      const Number tilt = tiltOf(i, strut[static_cast<std::size_t>(i)]);
      const double own = criterion_.strut_tilt_max[static_cast<std::size_t>(i)];
      if (tilt > criterion_.ball_tilt_max || (own > 0.0 && tilt > own))
        return false;
    }
    return true;
  }

  /// The angle between a strut and its ball joints' axis, or the way it stands at zero.
  Number tiltOf(int i, const Vector& now) const
  {
    Vector axis;
    Number eta;
    solveLeg(i, { machine_.zero().x(), machine_.zero().y(), machine_.zero().z() }, axis, eta);
    for (const IntervalVector& given : passiveJoints(machine_.leg(i)).ball_axes)
      axis = { given[0].mid(), given[1].mid(), given[2].mid() };
    const Number cosine = dot(axis, now) / sqrt(dot(axis, axis) * dot(now, now));
    return acos(cosine > 1 ? Number(1) : cosine);
  }

  bool hingesAreGood(const std::array<Vector, 3>& strut) const
  {
    for (int i = 0; criterion_.hinge_limits && i < 3; ++i)
      for (const StrutStop& stop : passiveJoints(machine_.leg(i)).stops)
      {
        const Vector u = { stop.direction[0].mid(), stop.direction[1].mid(), stop.direction[2].mid() };
        if (dot(u, strut[static_cast<std::size_t>(i)]) < stop.least.mid())
          return false;
      }
    return true;
  }

  /// psi_3 / psi_1.
  static Number condition(const std::array<Vector, 3>& strut, const Vector& eta)
  {
    const auto [least, largest] = squaredFactors(strut, eta);
    return least > 0 ? Number(sqrt(largest / least)) : Number(1e300);
  }

  /// psi_1^2 and psi_3^2: the extreme eigenvalues of B^-1 A A^T B^-1.
  static std::pair<Number, Number> squaredFactors(const std::array<Vector, 3>& strut, const Vector& eta)
  {
    std::array<Vector, 3> m;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        m[i][j] = dot(strut[i], strut[j]) / (eta[i] * eta[j]);
    return DrivenTool::extremeEigenvalues(m);
  }

  /// Whether sign * (A A^T - psi^2 B^2) is positive semidefinite, by all its principal minors.
  static bool isSemidefinite(const std::array<Vector, 3>& strut, const Vector& eta, const Number& psi, int sign)
  {
    std::array<Vector, 3> s;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        s[i][j] = sign * (dot(strut[i], strut[j]) - (i == j ? psi * psi * eta[i] * eta[i] : Number(0)));
    bool good = det(s) >= 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      good = good && s[i][i] >= 0 && s[i][i] * s[j][j] - s[i][j] * s[i][j] >= 0;
    }
    return good;
  }

  Machine machine_;
  Criterion criterion_;
};
}  // namespace test
}  // namespace pkm_workspace
