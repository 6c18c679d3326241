// SPDX-License-Identifier: BSD-3-Clause
#include "leg_maker.h"

#include "hinge_stops.h"
#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// What the limits of its passive joints mean for the strut, in the root frame.
void addStops(const Model& model, const Rail& rail, const ClosedLeg& closed, SlidingStrut& strut)
{
  IntervalMatrix to_slider = rail.slider.rotation;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      to_slider[row][column] = rail.slider.rotation[column][row];
  const RailOfHinges along{ rail.joint->child_link_name, to_slider * rail.axis };
  HingeStops hinges = hingeStops(closed.tcp, closed.geometry, along, model);
  for (StrutStop& stop : hinges.stops)
    stop.direction = rail.slider.rotation * stop.direction;
  strut.stops = hinges.stops;
  strut.open_hinges = hinges.open;
}

/// Limits of passive joints that no stop is made of.
void addOpenHinges(const Model& model, const Rail& rail, const ClosedLeg& closed, const char* what,
                   PassiveJoints& joints)
{
  const auto add = [&](const urdf::Joint& hinge) {
    if (hinge.type == urdf::Joint::REVOLUTE)
      joints.open_hinges.push_back("joint '" + hinge.name + "' is a passive joint of " + what +
                                   ", whose limits are not known as planes; those of struts on sliders are");
  };
  if (rail.form == LegForm::CRANK)
    add(*elbowOf(*rail.joint, model).back());
  for (const auto* const hinges : { &closed.tcp.at_slider, &closed.tcp.wrist })
    for (const Hinge& hinge : *hinges)
      add(model.joint(hinge.joint));
}

IntervalVector platformOf(const Rail& rail, const ClosedLeg& closed, const IntervalVector& tool)
{
  return rail.slider.rotation * closed.geometry.platform - tool;
}

SlidingStrut slidingStrutOf(const Model& model, const Rail& rail, const ClosedLeg& closed, const IntervalVector& tool)
{
  SlidingStrut strut;
  addStops(model, rail, closed, strut);
  strut.origin = rail.slider.toOuter(closed.geometry.slider_point);
  strut.axis = rail.axis;
  strut.direction = rail.direction;
  strut.platform = platformOf(rail, closed, tool);
  strut.length = closed.geometry.length;
  strut.working_mode = driveAtZero(rail, closed).mid() > 0.0 ? 1 : -1;
  return strut;
}

/// The prismatic joint goes along the strut, or nearly: then |s + q a| is within |q| |a - s / L| of L + q.
TelescopicStrut telescopicStrutOf(const Model& model, const Rail& rail, const ClosedLeg& closed,
                                  const IntervalVector& tool, Problems& problems)
{
  TelescopicStrut strut;
  addOpenHinges(model, rail, closed, "a strut of variable length", strut);
  strut.foot = rail.slider.toOuter(closed.geometry.slider_point);
  strut.platform = platformOf(rail, closed, tool);
  const IntervalVector& along = closed.tcp.extension->enclosure;
  const Interval& length = closed.geometry.length;
  const Interval off = norm(closed.geometry.strut - length * along) / length;
  if (!(off.upper() <= urdf_tolerance::PARALLEL))
    complain(problems, "joint '", rail.joint->name, "' has to lengthen its strut: its axis is ",
             roundedText(off.mid(), 3), " rad off the strut from the foot to the platform, expected at most ",
             roundedText(urdf_tolerance::PARALLEL, 3), " rad, and to point to the platform");
  const Interval most(std::max(std::abs(rail.joint->limits->lower), std::abs(rail.joint->limits->upper)));
  const double miss = (most * off).upper();
  strut.length = off.upper() <= 1e-15 ? length : length + Interval(-miss, miss);
  return strut;
}

/// The elbow goes round the crank's axis, and with it the end of the forearm, which is always as far from it.
Crank crankOf(const Model& model, const Rail& rail, const ClosedLeg& closed, const IntervalVector& tool)
{
  Crank crank;
  addOpenHinges(model, rail, closed, "a forearm", crank);
  const IntervalVector from_axis = rail.slider.position - rail.origin;
  const IntervalVector middle = rail.origin + dot(rail.axis, from_axis) * rail.axis;
  const IntervalVector arm = rail.slider.position - middle;
  crank.radius = lengthOf(arm);
  crank.along = { arm[0] / crank.radius, arm[1] / crank.radius, arm[2] / crank.radius };
  crank.across = cross(rail.axis, crank.along);
  crank.pivot = middle + rail.slider.rotation * closed.geometry.slider_point;
  crank.platform = platformOf(rail, closed, tool);
  crank.length = closed.geometry.length;
  crank.working_mode = driveAtZero(rail, closed).mid() > 0.0 ? 1 : -1;
  if (rail.joint->type == urdf::Joint::REVOLUTE)
    crank.reference = 0.5 * rail.joint->limits->lower + 0.5 * rail.joint->limits->upper;
  return crank;
}
}  // namespace

IntervalVector strutOf(const Rail& rail, const ClosedLeg& leg)
{
  return rail.slider.rotation * leg.geometry.strut;
}

Interval driveAtZero(const Rail& rail, const ClosedLeg& leg)
{
  if (rail.form == LegForm::TELESCOPE)
    return leg.geometry.length;
  if (rail.form == LegForm::SLIDER)
    return dot(strutOf(rail, leg), rail.axis);
  const IntervalVector way = cross(rail.axis, rail.slider.position - rail.origin);
  const Interval radius = lengthOf(way);
  return radius.certainlyPositive() ? dot(strutOf(rail, leg), way) / radius : Interval(0.0);
}

Leg machineLeg(const Model& model, const Rail& rail, const ClosedLeg& closed, const IntervalVector& tool,
               Problems& problems)
{
  Leg leg;
  leg.joint = rail.joint->name;
  if (rail.form == LegForm::SLIDER)
    leg.kind = slidingStrutOf(model, rail, closed, tool);
  else if (rail.form == LegForm::TELESCOPE)
    leg.kind = telescopicStrutOf(model, rail, closed, tool, problems);
  else
    leg.kind = crankOf(model, rail, closed, tool);
  if (!rail.joint->limits)
    return leg;
  const urdf::JointLimits& limits = *rail.joint->limits;
  const auto known = [](double most) { return most > 0.0 ? most : INF; };  // many files have 0 where nothing is known
  if (rail.joint->type != urdf::Joint::CONTINUOUS)
    leg.limits = Interval(limits.lower, limits.upper);
  leg.speed = known(limits.velocity);
  leg.effort = known(limits.effort);
  return leg;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
