// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/description.h"

#include <Eigen/Geometry>
#include <cmath>

#include "numbers.h"
#include "pkm_workspace/machine/assembly.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Kind = LegDescription::Kind;

bool isCoordinate(double x)
{
  return std::abs(x) <= LARGEST;
}

bool arePlaced(const Vector3d& v)
{
  return isCoordinate(v.x()) && isCoordinate(v.y()) && isCoordinate(v.z());
}

void validateCrank(const LegDescription& leg, const std::string& place, Problems& problems)
{
  const auto expect = [&](bool right, const char* what, double value, const char* expected) {
    if (!right)
      complain(problems, place, ": ", what, " = ", value, expected);
  };
  expect(leg.crank >= SHORTEST && leg.crank <= LARGEST, "crank", leg.crank, " m, expected a length from 1e-9 to 1e9 m");
  expect(std::isfinite(leg.axis_lean), "lean of the crank's axis", leg.axis_lean, " rad, expected a finite angle");
  expect(std::isfinite(leg.crank_zero), "crank at joint value 0", leg.crank_zero, " rad, expected a finite angle");
  expect(std::abs(leg.turn) == 1, "sense of the crank's turn", leg.turn, ", expected -1 or 1");
  if (!(leg.upper - leg.lower <= 2.0 * M_PI))
    complain(problems, place, ": travel from ", leg.lower, " to ", leg.upper,
             " rad, expected no more than a whole turn");
}

void validateLeg(const LegDescription& leg, const std::string& place, Problems& problems)
{
  const auto expect = [&](bool right, const char* what, double value, const char* expected) {
    if (!right)
      complain(problems, place, ": ", what, " = ", value, expected);
  };
  const char* const coordinate = " m, expected a number from -1e9 to 1e9 m";
  const char* const angle = " rad, expected a finite angle";
  expect(std::isfinite(leg.angle), "angle", leg.angle, angle);
  expect(std::isfinite(leg.lean), "lean", leg.lean, angle);
  expect(std::isfinite(leg.side_lean), "sideways lean", leg.side_lean, angle);
  expect(isCoordinate(leg.radius), "radius", leg.radius, coordinate);
  expect(isCoordinate(leg.height), "height", leg.height, coordinate);
  expect(leg.length >= SHORTEST && leg.length <= LARGEST, "strut length", leg.length,
         " m, expected a length from 1e-9 to 1e9 m");
  expect(isCoordinate(leg.lower), "lower end of the travel", leg.lower, coordinate);
  expect(isCoordinate(leg.upper), "upper end of the travel", leg.upper, coordinate);
  if (!(leg.lower < leg.upper))
    complain(problems, place, ": travel from ", leg.lower, " to ", leg.upper, " m, expected the lower end first");
  if (leg.kind != Kind::RAIL && (leg.lean != 0.0 || leg.side_lean != 0.0 || !leg.slider_joint.isZero(0.0)))
    complain(problems, place, ": it has no rail, expected no lean and no slider joint");
  if (leg.kind == Kind::TELESCOPE)
    expect(!(leg.length + leg.lower <= 0.0), "lower end of the travel", leg.lower,
           " m, expected one that leaves the strut some length");
  if (leg.kind == Kind::CRANK)
    validateCrank(leg, place, problems);
  if (std::abs(leg.working_mode) != 1)
    complain(problems, place, ": working mode ", leg.working_mode, ", expected -1 or 1");
  if (!arePlaced({ leg.foot.x(), leg.foot.y(), 0.0 }) || !arePlaced(leg.slider_joint) || !arePlaced(leg.platform_joint))
    complain(problems, place, ": a coordinate is not a number from -1e9 to 1e9 m");
}

/// The way of its slider, or of the crank's tip when that goes up, in the machine's axes.
Vector3d wayOf(const LegDescription& leg, double joint)
{
  if (leg.kind == Kind::RAIL)
    return legAxes(leg) * railDirection(leg);
  const double down = leg.crank_zero + leg.turn * joint;
  return crankAxes(leg) * Vector3d(std::sin(down), 0.0, std::cos(down));
}

/// Of the two points where the struts meet, those that leave each strut on its side of the rail or crank.
bool isInModes(const MachineDescription& machine, const Matrix3d& centers, const Vector3d& joints, const Vector3d& p)
{
  bool fits = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegDescription& leg = machine.legs[i];
    const auto k = static_cast<Eigen::Index>(i);
    fits =
        fits && (leg.kind == Kind::TELESCOPE || leg.working_mode * wayOf(leg, joints[k]).dot(p - centers.col(k)) > 0.0);
  }
  return fits;
}
}  // namespace

void MachineDescription::validate(Problems& problems) const
{
  for (std::size_t i = 0; i < 3; ++i)
    validateLeg(legs[i], "leg " + std::to_string(i + 1), problems);
  if (!arePlaced(tool))
    complain(problems, "tool: a coordinate is not a number from -1e9 to 1e9 m");
  if (mount && (!arePlaced(mount->xyz) || !mount->rpy.allFinite()))
    complain(problems, "mount: a coordinate is not a number from -1e9 to 1e9 m, or an angle is not finite");
}

Vector3d railDirection(const LegDescription& leg)
{
  return { std::sin(leg.lean) * std::cos(leg.side_lean), std::sin(leg.side_lean),
           std::cos(leg.lean) * std::cos(leg.side_lean) };
}

Matrix3d legAxes(const LegDescription& leg)
{
  return Eigen::AngleAxisd(leg.angle, Vector3d::UnitZ()).toRotationMatrix();
}

Matrix3d crankAxes(const LegDescription& leg)
{
  if (leg.kind != Kind::CRANK)
    return legAxes(leg);
  return legAxes(leg) * Eigen::AngleAxisd(leg.axis_lean, Vector3d::UnitX()).toRotationMatrix();
}

Vector3d crankArm(const LegDescription& leg, double joint)
{
  if (leg.kind != Kind::CRANK)
    return Vector3d::Zero();
  const double down = leg.crank_zero + leg.turn * joint;
  return leg.crank * (crankAxes(leg) * Vector3d(std::cos(down), 0.0, -std::sin(down)));
}

Vector3d drivenJoint(const LegDescription& leg, double joint)
{
  Vector3d in_leg(leg.radius, 0.0, leg.height);
  if (leg.kind == Kind::RAIL)
    in_leg += leg.slider_joint + joint * railDirection(leg);
  return Vector3d(leg.foot.x(), leg.foot.y(), 0.0) + legAxes(leg) * in_leg + crankArm(leg, joint);
}

std::optional<Vector3d> assembledTool(const MachineDescription& machine, const Vector3d& joints)
{
  Matrix3d centers;
  Vector3d lengths;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const LegDescription& leg = machine.legs[static_cast<std::size_t>(i)];
    centers.col(i) = drivenJoint(leg, joints[i]) - (legAxes(leg) * leg.platform_joint - machine.tool);
    lengths[i] = leg.length + (leg.kind == Kind::TELESCOPE ? joints[i] : 0.0);
  }
  std::optional<Vector3d> best;
  const double upwards = machine.is_upper ? 1.0 : -1.0;
  if (const auto points = meetingPoints(centers, lengths))
    for (const Vector3d& p : *points)
      if (isInModes(machine, centers, joints, p) && (!best || upwards * p.z() > upwards * best->z()))
        best = p;
  return best;
}
}  // namespace pkm_workspace
