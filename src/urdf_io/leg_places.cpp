// SPDX-License-Identifier: BSD-3-Clause
#include "leg_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "number_text.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
using Eigen::Vector3d;

/// The nearest multiple of a power of ten; never -0.
double roundedTo(double value, double parts)
{
  return std::round(value * parts) / parts + 0.0;
}

/// Angles that only say how the machine is drawn at zero.
double drawnAngle(double angle)
{
  return roundedTo(angle, 1e9);
}

Origin turned(double roll, double pitch, double yaw)
{
  return { Vector3d::Zero(), { roll, pitch, yaw } };
}

/// The turns about y and then x that lead from -z to a direction in the leg's axes.
struct StrutTurns
{
  double pitch;
  double roll;
};

StrutTurns turnsOf(const Vector3d& direction)
{
  const double sine = std::max(-1.0, std::min(1.0, direction.y()));
  return { drawnAngle(std::atan2(-direction.x(), -direction.z())), drawnAngle(std::asin(sine)) };
}

const char* placeNameOf(LegDescription::Kind kind)
{
  switch (kind)
  {
    case LegDescription::Kind::TELESCOPE:
      return "foot";
    case LegDescription::Kind::CRANK:
      return "crank";
    default:
      return "rail";
  }
}

std::string commentOn(const LegDescription& leg, std::size_t number)
{
  TextStream text;
  text << "leg " << number << ": ";
  if (leg.foot != Eigen::Vector2d::Zero())
    text << "at x = " << nearly(leg.foot.x(), 9) << " m, y = " << nearly(leg.foot.y(), 9) << " m, ";
  text << "turned by " << nearly(leg.angle * 180.0 / M_PI, 9) << " degrees, " << placeNameOf(leg.kind) << " at radius "
       << leg.radius << " m, ";
  if (leg.kind == LegDescription::Kind::CRANK)
    text << "crank " << leg.crank << " m, ";
  text << "strut " << leg.length << " m";
  if (leg.kind == LegDescription::Kind::TELESCOPE)
    text << " at joint value 0";
  return text.str();
}

Vector3d railAxis(const LegDescription& leg)
{
  return railDirection(leg).unaryExpr([](double x) { return roundedTo(x, 1e15); });
}

/// From the leg's own axes to where its passive joints begin.
void placeDrive(const LegDescription& leg, LegPlaces& places)
{
  const Vector3d base(leg.radius, 0.0, leg.height);
  places.rail = { base, {} };
  places.rail_axis = railAxis(leg);
  if (leg.kind == LegDescription::Kind::TELESCOPE)
    places.rail_axis = -Vector3d::UnitZ();
  if (leg.kind != LegDescription::Kind::CRANK)
    return;
  places.rail = { base, { 0.0, leg.crank_zero, 0.0 } };
  if (leg.axis_lean != 0.0)
  {
    places.hip = Origin{ base, { leg.axis_lean, 0.0, 0.0 } };
    places.level = turned(-leg.axis_lean, 0.0, 0.0);
    places.rail.xyz.setZero();
  }
  places.rail_axis = leg.turn * Vector3d::UnitY();
  places.elbow = { { leg.crank, 0.0, 0.0 }, { 0.0, -leg.crank_zero, 0.0 } };
}

LegPlaces placesOf(const LegDescription& leg, const StrutTurns& strut, const Vector3d& tool, std::size_t number)
{
  LegPlaces places;
  places.comment = commentOn(leg, number);
  places.tower = Origin{ { leg.foot.x(), leg.foot.y(), 0.0 }, { 0.0, 0.0, leg.angle } };
  placeDrive(leg, places);
  places.revolute = { leg.slider_joint, { 0.0, strut.pitch, 0.0 } };
  if (leg.kind == LegDescription::Kind::TELESCOPE)
    places.revolute.xyz = places.rail.xyz;
  places.revolute_axis = Vector3d::UnitY();
  places.parallelogram = turned(strut.roll, 0.0, 0.0);
  places.parallelogram_axis = Vector3d::UnitX();
  places.parallelogram_back = { { 0.0, 0.0, -leg.length }, {} };
  const Origin upright = turned(0.0, -strut.pitch, 0.0);
  places.revolute_back = strut.roll == 0.0 ? upright : turned(-strut.roll, 0.0, 0.0);
  if (strut.roll != 0.0)
    places.flange = upright;
  const Origin middle{ -leg.platform_joint, { 0.0, 0.0, -leg.angle } };
  places.tcp = middle;
  if (!tool.isZero(0.0))
  {
    places.plate = middle;
    places.tcp = { tool, {} };
  }
  return places;
}

/// What is drawn of the leg, and where its joint may go.
LegNumbers numbersOf(const LegDescription& leg, const Vector3d& zero, const Vector3d& tool)
{
  const Eigen::Matrix3d axes = legAxes(leg);
  LegNumbers numbers;
  numbers.joint = leg.joint;
  numbers.form = leg.kind == LegDescription::Kind::CRANK       ? LegForm::CRANK
                 : leg.kind == LegDescription::Kind::TELESCOPE ? LegForm::TELESCOPE
                                                               : LegForm::SLIDER;
  numbers.arm = crankArm(leg, 0.0);
  numbers.origin = drivenJoint(leg, 0.0) - numbers.arm;
  numbers.axis = axes * railDirection(leg);
  numbers.platform = axes * leg.platform_joint - tool;
  numbers.strut = zero + numbers.platform - drivenJoint(leg, 0.0);
  if (numbers.form == LegForm::CRANK)
    numbers.axis = leg.turn * crankAxes(leg).col(1);
  if (numbers.form == LegForm::TELESCOPE)
    numbers.axis = numbers.strut.normalized();
  numbers.speed = leg.speed;
  numbers.effort = leg.effort;
  numbers.lower = leg.lower;
  numbers.upper = leg.upper;
  numbers.drawn = { leg.lower, leg.upper };
  return numbers;
}
}  // namespace

LegPlaces placesOf(const LegNumbers& numbers)
{
  LegPlaces places;
  places.rail.xyz = numbers.origin;
  places.rail_axis = numbers.axis;
  places.elbow.xyz = numbers.arm;
  if (numbers.form == LegForm::TELESCOPE)
    places.revolute.xyz = numbers.origin;
  places.revolute_axis = numbers.revolute;
  places.parallelogram_axis = numbers.parallelogram;
  places.parallelogram_back.xyz = numbers.strut;
  places.tcp.xyz = -numbers.platform;
  return places;
}

std::array<DescribedLeg, 3> describedLegs(const MachineDescription& machine)
{
  Problems problems;
  machine.validate(problems);
  throwProblems(problems);
  const auto zero = assembledTool(machine, Vector3d::Zero());
  if (!zero)
    throw std::invalid_argument("machine '" + machine.name +
                                "': with all joints at 0 m the struts do not meet in their working modes; check their "
                                "lengths, or count the joint values from another place of the sliders");
  std::array<DescribedLeg, 3> legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegDescription& leg = machine.legs[i];
    const Eigen::Matrix3d axes = crankAxes(leg);
    legs[i].numbers = numbersOf(leg, *zero, machine.tool);
    const StrutTurns strut = turnsOf(axes.transpose() * legs[i].numbers.strut.normalized());
    legs[i].places = placesOf(leg, strut, machine.tool, i + 1);
    legs[i].numbers.revolute = axes * Vector3d::UnitY();
    legs[i].numbers.parallelogram = axes * Vector3d(std::cos(strut.pitch), 0.0, -std::sin(strut.pitch));
  }
  return legs;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
