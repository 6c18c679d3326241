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

bool isCoordinate(double x)
{
  return std::abs(x) <= LARGEST;
}

bool arePlaced(const Vector3d& v)
{
  return isCoordinate(v.x()) && isCoordinate(v.y()) && isCoordinate(v.z());
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
  if (std::abs(leg.working_mode) != 1)
    complain(problems, place, ": working mode ", leg.working_mode, ", expected -1 or 1");
  if (!arePlaced({ leg.foot.x(), leg.foot.y(), 0.0 }) || !arePlaced(leg.slider_joint) || !arePlaced(leg.platform_joint))
    complain(problems, place, ": a coordinate is not a number from -1e9 to 1e9 m");
}

/// Of the two points where the struts meet, those that leave each strut on its side of the rail.
bool isInModes(const MachineDescription& machine, const Matrix3d& centers, const Vector3d& p)
{
  bool fits = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegDescription& leg = machine.legs[i];
    const Vector3d axis = legAxes(leg) * railDirection(leg);
    fits = fits && leg.working_mode * axis.dot(p - centers.col(static_cast<Eigen::Index>(i))) > 0.0;
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

Vector3d sliderJoint(const LegDescription& leg, double joint)
{
  const Vector3d at_zero = Vector3d(leg.radius, 0.0, leg.height) + leg.slider_joint;
  return Vector3d(leg.foot.x(), leg.foot.y(), 0.0) + legAxes(leg) * (at_zero + joint * railDirection(leg));
}

std::optional<Vector3d> assembledTool(const MachineDescription& machine, const Vector3d& joints)
{
  Matrix3d centers;
  Vector3d lengths;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const LegDescription& leg = machine.legs[static_cast<std::size_t>(i)];
    centers.col(i) = sliderJoint(leg, joints[i]) - (legAxes(leg) * leg.platform_joint - machine.tool);
    lengths[i] = leg.length;
  }
  std::optional<Vector3d> best;
  const double upwards = machine.is_upper ? 1.0 : -1.0;
  if (const auto points = meetingPoints(centers, lengths))
    for (const Vector3d& p : *points)
      if (isInModes(machine, centers, p) && (!best || upwards * p.z() > upwards * best->z()))
        best = p;
  return best;
}
}  // namespace pkm_workspace
