// SPDX-License-Identifier: BSD-3-Clause
#include "looks.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A right-handed frame whose z is along @p z and whose x is across it, along @p x as far as possible.
Matrix3d frameAlong(const Vector3d& z, const Vector3d& x)
{
  Matrix3d frame;
  frame.col(2) = z.normalized();
  Vector3d across = x - x.dot(frame.col(2)) * frame.col(2);
  frame.col(0) = across.norm() > 1e-6 * x.norm() ? across.normalized() : frame.col(2).unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

Solid rod(const Vector3d& from, const Vector3d& to, double radius, const char* material)
{
  const Matrix3d frame = frameAlong(to - from, Vector3d::UnitX());
  return { Solid::Shape::CYLINDER, { radius, radius, (to - from).norm() }, 0.5 * (from + to), frame, material };
}

/// A box from one point to another, its width along @p side.
Solid beam(const Vector3d& from, const Vector3d& to, const Vector3d& side, double width, double height,
           const char* material)
{
  return {
    Solid::Shape::BOX, { width, height, (to - from).norm() }, 0.5 * (from + to), frameAlong(to - from, side), material
  };
}

/// Where the tool points: away from the sliders.
Vector3d toolDirection(const std::array<LegNumbers, 3>& numbers)
{
  const Vector3d sum = numbers[0].strut + numbers[1].strut + numbers[2].strut;
  return sum.norm() > 0.1 * numbers[0].strut.norm() ? Vector3d(sum.normalized()) : Vector3d(-Vector3d::UnitZ());
}

/// The side of its rail on which nothing of the machine is: against the strut, or else against the tool.
Vector3d behindRail(const LegNumbers& leg, const Vector3d& tool)
{
  for (const Vector3d& front : { leg.strut, tool })
  {
    const Vector3d across = front - leg.axis.dot(front) * leg.axis;
    if (across.norm() > 0.05 * front.norm())
      return -across.normalized();
  }
  return leg.axis.unitOrthogonal();
}

void lookLikeRail(const LegNumbers& leg, const Vector3d& tool, double unit, LegLooks& looks)
{
  const Vector3d behind = 0.1 * unit * behindRail(leg, tool);
  const Vector3d along = 0.07 * unit * leg.axis;
  const Vector3d start = leg.origin + behind;
  looks.rail = beam(start + leg.drawn.first * leg.axis - 1.5 * along, start + leg.drawn.second * leg.axis + 1.5 * along,
                    behind, 0.035 * unit, 0.05 * unit, "rail");
  looks.slider = { beam(behind - along, behind + along, behind, 0.07 * unit, 0.1 * unit, "slider"),
                   beam(behind, Vector3d::Zero(), leg.axis, 0.05 * unit, 0.03 * unit, "slider") };
}

void lookLikeCrank(const LegNumbers& leg, double unit, LegLooks& looks)
{
  const Vector3d along = 0.09 * unit * leg.axis;
  looks.rail = rod(leg.origin - along, leg.origin + along, 0.035 * unit, "rail");
  looks.slider = { beam(Vector3d::Zero(), leg.arm, leg.axis, 0.04 * unit, 0.03 * unit, "slider") };
}

/// The rod goes through the foot where the barrel is too short for it, as a screw does.
void lookLikeTelescope(const LegNumbers& leg, double unit, LegLooks& looks)
{
  const Vector3d along = leg.strut.normalized();
  const double barrel = 0.95 * (leg.strut.norm() + leg.lower);
  looks.rail = { Solid::Shape::SPHERE, { 0.04 * unit, 0.0, 0.0 }, leg.origin, Matrix3d::Identity(), "rail" };
  looks.barrel = { rod(Vector3d::Zero(), barrel * along, 0.022 * unit, "slider") };
  looks.bar = rod((barrel - leg.upper - 0.03 * unit) * along, leg.strut, 0.012 * unit, "bar");
  looks.short_bar = {
    Solid::Shape::SPHERE, { 0.025 * unit, 0.0, 0.0 }, Vector3d::Zero(), Matrix3d::Identity(), "joint"
  };
}

/// @param middle of the platform, seen from the tool point
LegLooks looksOf(const LegNumbers& leg, const Vector3d& tool, const Vector3d& middle, double unit)
{
  LegLooks looks;
  looks.half_width = 0.06 * unit * leg.revolute;
  looks.short_bar = rod(-1.2 * looks.half_width, 1.2 * looks.half_width, 0.014 * unit, "joint");
  looks.bar = rod(Vector3d::Zero(), leg.strut, 0.01 * unit, "bar");
  if (leg.form == LegForm::SLIDER)
    lookLikeRail(leg, tool, unit, looks);
  else if (leg.form == LegForm::CRANK)
    lookLikeCrank(leg, unit, looks);
  else
    lookLikeTelescope(leg, unit, looks);
  const Vector3d arm = middle - leg.platform;
  if (arm.norm() > 0.02 * unit)
    looks.tip = { beam(Vector3d::Zero(), arm, tool, 0.02 * unit, 0.04 * unit, "platform") };
  return looks;
}
}  // namespace

namespace
{
/// Arms that lead from the middle of all cranks and feet to each.
std::vector<Solid> baseOf(const std::array<LegNumbers, 3>& numbers, double unit)
{
  const Vector3d middle = (numbers[0].origin + numbers[1].origin + numbers[2].origin) / 3.0;
  std::vector<Solid> arms;
  for (const LegNumbers& leg : numbers)
    if (leg.form == LegForm::SLIDER)
      return {};
    else if ((leg.origin - middle).norm() > 0.02 * unit)
      arms.push_back(beam(middle, leg.origin, leg.strut, 0.03 * unit, 0.06 * unit, "rail"));
  return arms;
}
}  // namespace

const std::vector<Material>& materials()
{
  static const std::vector<Material> all{ { "rail", "0.45 0.47 0.5 1" },    { "slider", "0.2 0.4 0.75 1" },
                                          { "joint", "0.3 0.3 0.33 1" },    { "bar", "0.95 0.65 0.2 1" },
                                          { "platform", "0.25 0.6 0.5 1" }, { "tool", "0.85 0.87 0.9 1" } };
  return all;
}

Looks looksOf(const std::array<LegNumbers, 3>& numbers, const Vector3d& tool)
{
  const double unit = std::max({ numbers[0].strut.norm(), numbers[1].strut.norm(), numbers[2].strut.norm() });
  const bool has_tool = tool.norm() > 0.02 * unit;
  const Vector3d pointing = has_tool ? Vector3d(tool.normalized()) : toolDirection(numbers);
  const double body = has_tool ? 0.6 * tool.norm() : 0.12 * unit;
  const double whole = has_tool ? tool.norm() : 0.2 * unit;
  Looks looks;
  for (std::size_t i = 0; i < 3; ++i)
    looks.legs[i] = looksOf(numbers[i], pointing, -tool, unit);
  looks.base = baseOf(numbers, unit);
  looks.platform = { { Solid::Shape::SPHERE, { 0.05 * unit, 0.0, 0.0 }, -tool, Matrix3d::Identity(), "platform" },
                     rod(-tool, body * pointing - tool, 0.03 * unit, "platform"),
                     rod(body * pointing - tool, whole * pointing - tool, 0.01 * unit, "tool") };
  return looks;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
