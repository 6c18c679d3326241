// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "pkm_workspace/machine/description.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Vector3d;

inline double degrees(double angle)
{
  return angle * M_PI / 180.0;
}

/// The calibrated machine of an integrator, homed at one height.
inline MachineDescription calibrated()
{
  MachineDescription machine;
  machine.name = "calibrated";
  const double angles[] = { 0.0, 120.4, 239.7 };
  const double lengths[] = { 0.2690, 0.2688, 0.2691 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    LegDescription& leg = machine.legs[i];
    leg.joint = "rail_" + std::to_string(i + 1);
    leg.angle = degrees(angles[i]);
    leg.radius = 0.130;
    leg.height = 0.3;
    leg.platform_joint = { 0.030, 0.0, 0.0 };
    leg.length = lengths[i];
    leg.upper = 0.35;
  }
  machine.tool = { 0.0, 0.0, -0.040 };
  machine.mount = Mount{ { 0.0, 0.0, 0.75 }, { 0.0, 0.0, degrees(15.0) } };
  return machine;
}

/// A machine with nothing straight about it.
inline MachineDescription crooked(Random& random)
{
  MachineDescription machine = calibrated();
  for (LegDescription& leg : machine.legs)
  {
    const auto some = [&random](double size) { return random.uniform(-size, size); };
    leg.angle += some(0.2);
    leg.foot = { some(0.02), some(0.02) };
    leg.lean = some(0.4);
    leg.side_lean = some(0.4);
    leg.slider_joint = { some(0.02), some(0.02), some(0.02) };
    leg.platform_joint += Vector3d(some(0.01), some(0.01), some(0.01));
    leg.length += some(0.02);
  }
  machine.mount->rpy = { random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0) };
  return machine;
}

/// How much the strut of a leg is too long, by the description's own words [m].
inline double excess(const MachineDescription& machine, std::size_t i, const Vector3d& tool_in_root, double joint)
{
  const LegDescription& leg = machine.legs[i];
  const Vector3d& rpy = machine.mount->rpy;
  const Eigen::Quaterniond stands = Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX());
  const Vector3d tool = stands.conjugate() * (tool_in_root - machine.mount->xyz);
  const auto in_machine = [&leg](const Vector3d& v) {
    return Vector3d(Eigen::AngleAxisd(leg.angle, Vector3d::UnitZ()) * v);
  };
  const Vector3d platform = tool - machine.tool + in_machine(leg.platform_joint);
  const Vector3d base = Vector3d(leg.foot.x(), leg.foot.y(), 0.0) + in_machine({ leg.radius, 0.0, leg.height });
  if (leg.kind == LegDescription::Kind::TELESCOPE)
    return (platform - base).norm() - (leg.length + joint);
  if (leg.kind == LegDescription::Kind::CRANK)
  {
    // The axis is the leg's y, raised by its lean; a crank that points outwards goes down the way that z is turned away
    // from it.
    const Vector3d axis(0.0, std::cos(leg.axis_lean), std::sin(leg.axis_lean));
    const Vector3d down = axis.cross(Vector3d::UnitX());
    const double angle = leg.crank_zero + leg.turn * joint;
    const Vector3d tip = base + in_machine(leg.crank * (std::cos(angle) * Vector3d::UnitX() + std::sin(angle) * down));
    return (platform - tip).norm() - leg.length;
  }
  // Leaning: first outwards, about the leg's y; then sideways, so that the side lean is the angle out of that plane.
  const double radial = std::sin(leg.lean) * std::cos(leg.side_lean);
  const double upright = std::cos(leg.lean) * std::cos(leg.side_lean);
  const Vector3d along(radial, std::sin(leg.side_lean), upright);
  const Vector3d slider = base + in_machine(joint * along + leg.slider_joint);
  return (platform - slider).norm() - leg.length;
}

/// Joint values of points near the zero configuration against the description.
inline void expectDescribed(const MachineDescription& description, Random& random, double reach = 0.03)
{
  const UrdfMachine urdf = readUrdf(writeUrdf(description));
  EXPECT_TRUE(urdf.warnings.empty()) << urdf.warnings.at(0);
  for (int k = 0; k < 20; ++k)
  {
    const auto some = [&random, reach] { return random.uniform(-reach, reach); };
    const Vector3d p = urdf.machine.zero() + Vector3d(some(), some(), some());
    const auto joints = inverseKinematics(urdf.machine, p);
    ASSERT_TRUE(joints);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(excess(description, i, p, (*joints)[static_cast<Eigen::Index>(i)]), 0.0, 1e-13) << "leg " << i;
  }
}

/// The calibrated machine with something wrong.
inline void refuseSpoilt(const std::function<void(MachineDescription&)>& spoil, const std::string& pattern)
{
  MachineDescription machine = calibrated();
  spoil(machine);
  expectThrow<std::invalid_argument>([&] { writeUrdf(machine); }, pattern);
}
}  // namespace test
}  // namespace pkm_workspace
