// SPDX-License-Identifier: BSD-3-Clause
#include "leg_chain.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// A spherical joint has three axes; more would turn the strut no further.
constexpr std::size_t MOST_HINGES = 3;

std::string quoted(const std::string& name)
{
  return "'" + name + "'";
}

std::string namesOf(const std::vector<Hinge>& hinges)
{
  std::string names;
  for (const Hinge& hinge : hinges)
    names += (names.empty() ? "'" : ", '") + hinge.joint + "'";
  return names;
}

/// The last hinge at the slider that the wrist has not undone yet.
const Hinge* nextToUndo(const Station& station)
{
  const std::size_t open = station.at_slider.size() - station.wrist.size();
  return open == 0 ? nullptr : &station.at_slider[open - 1];
}

/// Upper bound of the sine of the angle between two lines: 0 when they are proved parallel.
double sineBetween(const Direction& a, const Direction& b)
{
  return exactlyParallel(a, b) != 0 ? 0.0 : norm(cross(a.enclosure, b.enclosure)).upper();
}

/// Lets @p hinge undo @p undone, or says why it does not.
void undo(Station& station, const Hinge& hinge, const Hinge& undone)
{
  const double sine = sineBetween(hinge.axis, undone.axis);
  const bool same_side = dot(hinge.axis.enclosure, undone.axis.enclosure).certainlyPositive();
  const double expected = same_side ? -undone.factor : undone.factor;
  if (!(sine <= urdf_tolerance::PARALLEL))
    station.problem = "joint " + quoted(hinge.joint) + " turns the platform: its axis is " +
                      roundedText(std::asin(std::min(1.0, sine)), 3) + " rad off that of " + quoted(undone.joint) +
                      ", which it follows by <mimic>; expected at most " + roundedText(urdf_tolerance::PARALLEL, 3) +
                      " rad";
  else if (hinge.factor != expected)
    station.problem = "joint " + quoted(hinge.joint) + " turns the platform: it follows " + quoted(hinge.master) +
                      " with multiplier " + numberText(hinge.factor) + " about the " +
                      (same_side ? "same" : "opposite") + " axis as " + quoted(undone.joint) + ", expected " +
                      numberText(expected);
  else
  {
    // Two turns by the angle at most, and asin(x) <= 1.001 x for x as small as here.
    station.turn = (Interval(station.turn) + Interval(2.002) * Interval(sine)).upper();
    station.wrist.push_back(hinge);
  }
}

void addFreedom(Station& station, const Hinge& hinge)
{
  if (!station.wrist.empty())
    station.problem = "joint " + quoted(hinge.joint) + " turns the platform: it follows none of the joints " +
                      namesOf(station.at_slider) + " at the slider; expected <mimic> to undo them";
  else if (station.at_slider.size() == MOST_HINGES)
    station.problem = "joint " + quoted(hinge.joint) + " turns the platform: it follows none of the joints " +
                      namesOf(station.at_slider) + " before it, and these turn the strut already; expected <mimic>";
  else
    station.at_slider.push_back(hinge);
}

void passHinge(Station& station, const Hinge& hinge)
{
  const auto same_master = [&hinge](const Hinge& other) { return other.master == hinge.master; };
  const auto followed = std::find_if(station.at_slider.begin(), station.at_slider.end(), same_master);
  const Hinge* const next = nextToUndo(station);
  station.fixed_joints = 0;
  station.offset = { 0.0, 0.0, 0.0 };
  if (followed == station.at_slider.end())
    addFreedom(station, hinge);
  else if (next == nullptr || next->master != hinge.master)
    station.problem =
        "joint " + quoted(hinge.joint) + " turns the platform: it follows " + quoted(hinge.master) +
        (next == nullptr ? ", which is undone already" : " before " + quoted(next->joint) + " is undone") +
        "; expected the joints of the wrist in the reverse order of those at the slider";
  else
    undo(station, hinge, *next);
}

/// What is wrong with a passive joint whatever else its chain holds.
std::string problemWith(const urdf::Joint& joint, const JointFollower& follower, const Model& model)
{
  const std::string name = "joint " + quoted(joint.name);
  const urdf::Joint& master = model.joint(follower.source);
  if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS)
    return name + " between slider and platform is " + typeOf(joint) + ", expected revolute, continuous or fixed";
  if (follower.offset != 0.0)
    return name + ": <mimic> offset = " + numberText(follower.offset) + " rad, expected 0 in a strut or wrist";
  if (master.type != urdf::Joint::REVOLUTE && master.type != urdf::Joint::CONTINUOUS)
    return name + " follows " + quoted(master.name) + ", which is " + typeOf(master) + "; expected a passive joint";
  return "";
}

/// Lets the strut become longer, or says why the joint does not.
void extend(Station& station, const Direction& axis, const std::string& joint)
{
  station.fixed_joints = 0;
  if (station.at_slider.size() < 2 || !station.wrist.empty())
    station.problem = "joint " + quoted(joint) +
                      " lengthens no strut: it has to be between the passive joints at the " +
                      "foot, two or three, and those of the wrist that undo them";
  else
    station.extension = axis;
}

/// The child link of @p joint, which hangs at @p parent.
Station beyond(const Station& parent, const urdf::Joint& joint, const Rail& rail, const Model& model)
{
  Station station = parent;
  station.link = joint.child_link_name;
  ++station.fixed_joints;
  if (!station.problem.empty())
    return station;
  station.frame = parent.frame.then(model.originOf(joint));
  station.offset = parent.offset + parent.frame.rotation * enclose(model.originOf(joint).xyz);
  if (joint.type == urdf::Joint::FIXED)
    return station;
  if (rail.form == LegForm::TELESCOPE && &joint == rail.joint)
  {
    extend(station, directionIn(station.frame, axisOf(joint)), joint.name);
    return station;
  }
  const JointFollower& follower = model.masters.at(joint.name);
  station.problem = problemWith(joint, follower, model);
  if (station.problem.empty())
    passHinge(station, { joint.name, joint.child_link_name, directionIn(station.frame, axisOf(joint)), station.offset,
                         follower.source, follower.factor });
  return station;
}

/// Orders links by how far they have come on the way to a platform: passive joints, then one that failed, then
/// nearness.
bool isFarther(const Station& a, const Station& b)
{
  const auto rank = [](const Station& s) {
    return std::make_tuple(s.at_slider.size() + s.wrist.size(), !s.problem.empty(), -s.fixed_joints);
  };
  return rank(a) > rank(b);
}
}  // namespace

std::vector<Station> stationsBelow(const Rail& rail, const Model& model)
{
  std::vector<Station> stations(1);
  stations[0].link = rail.start;
  for (std::size_t i = 0; i < stations.size(); ++i)
    for (const auto& joint : model.link(stations[i].link).child_joints)
      if (i > 0 || rail.first.empty() || joint->name == rail.first)
        stations.push_back(beyond(stations[i], *joint, rail, model));
  return stations;
}

std::string whyNotOnPlatform(const Station& station)
{
  const std::string link = "link " + quoted(station.link);
  const Hinge* const open = nextToUndo(station);
  if (!station.problem.empty())
    return station.problem;
  if (station.at_slider.empty())
    return link + " is carried by no passive joints, expected two or three at the slider and as many at the platform";
  if (open != nullptr)
    return link + " turns with joint " + quoted(open->joint) +
           ", which nothing undoes; expected a joint that follows it by <mimic>, with multiplier -1 about the same "
           "axis";
  if (station.at_slider.size() == 1)
    return link + " swings about one axis only, that of joint " + quoted(station.at_slider[0].joint) +
           "; expected two or three passive joints at the slider";
  return "";
}

std::string whyNoPlatform(const std::vector<Station>& stations)
{
  const Station& nearest = *std::min_element(stations.begin(), stations.end(), isFarther);
  if (nearest.isOnPlatform())
    return "no link is fixed to link " + quoted(nearest.link) + ", expected one for the tool point";
  return whyNotOnPlatform(nearest);
}

std::optional<std::pair<std::size_t, const Station*>> findLink(const std::string& link, const Stations& stations)
{
  for (std::size_t i = 0; i < 3; ++i)
    for (const Station& station : stations[i])
      if (station.link == link)
        return std::make_pair(i, &station);
  return std::nullopt;
}

std::string linksOf(const Model& model)
{
  std::string list;
  for (const auto& link : model.tree->links_)
    list += (list.empty() ? "'" : ", '") + link.first + "'";
  return list;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
