// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/urdf_writer.h"

#include <cmath>

#include "leg_places.h"
#include "urdf_text.h"

namespace pkm_workspace
{
using namespace urdf_io;

namespace
{
using Eigen::Vector3d;

/// The passive joints and links of one leg; their names end on its number.
class LegText
{
public:
  LegText(UrdfText& text, const LegNumbers& leg, const LegPlaces& places, const LegLooks& looks,
          const std::string& number)
    : text_(text), leg_(leg), places_(places), looks_(looks), number_(number)
  {}

  /// From the rail to the tool point: what readUrdf() reads.
  void writeChain() const
  {
    const LegPlaces& at = places_;
    if (!at.comment.empty())
      text_.comment(at.comment);
    if (at.tower)
      text_.branch({ numbered("tower_joint"), "fixed", "base_link", numbered("tower"), *at.tower });
    const std::string base = at.tower ? numbered("tower") : "base_link";
    const std::string start = leg_.form == LegForm::TELESCOPE ? base : writeDrive(base);
    text_.branch(hinge("revolute", start, "knuckle", at.revolute, at.revolute_axis), { looks_.short_bar });
    text_.branch(hinge("parallelogram", numbered("knuckle"), "strut", at.parallelogram, at.parallelogram_axis),
                 looks_.barrel);
    std::string end = "strut";
    if (leg_.form == LegForm::TELESCOPE)
    {
      end = "rod";
      text_.branch(driven("prismatic", numbered("strut"), end, {}, at.rail_axis), { looks_.bar });
    }
    text_.branch(follower(numbered("parallelogram"), -1.0, "parallelogram_back", end, "wrist", at.parallelogram_back,
                          at.parallelogram_axis),
                 { looks_.short_bar });
    text_.branch(
        follower(numbered("revolute"), -1.0, "revolute_back", "wrist", "tip", at.revolute_back, at.revolute_axis),
        looks_.tip);
    writePlatform();
  }

  /// The two bars of the parallelogram, beside the strut: what rviz shows.
  void writeBars() const
  {
    if (leg_.form == LegForm::TELESCOPE)
      return;
    for (const auto& [name, sign] : { std::make_pair("a", 1.0), std::make_pair("b", -1.0) })
    {
      Origin beside = places_.parallelogram;
      beside.xyz += text_.inLink(numbered("knuckle"), sign * looks_.half_width);
      if (places_.tower)  // turned there and back: rounding is no coordinate
        beside.xyz = beside.xyz.unaryExpr([](double x) { return std::round(x * 1e9) / 1e9 + 0.0; });
      text_.branch(follower(numbered("parallelogram"), 1.0, std::string("bar_joint_") + name, "knuckle",
                            std::string("bar_") + name, beside, places_.parallelogram_axis),
                   { looks_.bar });
    }
  }

private:
  /// The joint that a motor moves, before all others. @return the link that the passive joints begin at
  std::string writeDrive(const std::string& base) const
  {
    const LegPlaces& at = places_;
    if (leg_.form == LegForm::SLIDER)
    {
      text_.branch(driven("prismatic", base, "slider", at.rail, at.rail_axis), looks_.slider);
      return numbered("slider");
    }
    if (at.hip)
      text_.branch({ numbered("hip_joint"), "fixed", base, numbered("hip"), *at.hip });
    text_.branch(driven(std::isfinite(leg_.lower) ? "revolute" : "continuous", at.hip ? numbered("hip") : base,
                        "crank_link", at.rail, at.rail_axis),
                 looks_.slider);
    text_.branch(follower(leg_.joint, -1.0, "elbow", "crank_link", "elbow_link", at.elbow, at.rail_axis));
    return numbered("elbow_link");
  }
  void writePlatform() const
  {
    std::string last = "tip";
    const auto fix = [&](const std::optional<Origin>& place, const std::string& link) {
      if (place)
        text_.branch({ numbered(link + "_joint"), "fixed", numbered(last), numbered(link), *place });
      last = place ? link : last;
    };
    fix(places_.flange, "flange");
    fix(places_.level, "level");
    fix(places_.plate, "plate");
    fix(places_.tcp, "tcp");
  }
  std::string numbered(const std::string& name) const { return name + "_" + number_; }
  JointText driven(const char* type, const std::string& parent, const std::string& child, const Origin& origin,
                   const Vector3d& axis) const
  {
    JointText joint{ leg_.joint, type, parent, numbered(child), origin, axis };
    if (std::isfinite(leg_.lower))
      joint.limits = std::make_pair(leg_.lower, leg_.upper);
    joint.speed = leg_.speed;
    joint.effort = leg_.effort;
    return joint;
  }
  JointText hinge(const std::string& name, const std::string& parent, const std::string& child, const Origin& origin,
                  const Vector3d& axis) const
  {
    return { numbered(name), "continuous", parent, numbered(child), origin, axis };
  }
  JointText follower(const std::string& master, double multiplier, const std::string& name, const std::string& parent,
                     const std::string& child, const Origin& origin, const Vector3d& axis) const
  {
    JointText joint = hinge(name, numbered(parent), child, origin, axis);
    joint.master = master;
    joint.multiplier = multiplier;
    return joint;
  }

  UrdfText& text_;
  const LegNumbers& leg_;
  const LegPlaces& places_;
  const LegLooks& looks_;
  std::string number_;
};

/// The rest of the robot, below its root.
std::string writeBelow(UrdfText& text, const std::array<LegNumbers, 3>& numbers, const std::array<LegPlaces, 3>& places,
                       const Looks& looks, const Tolerances& tolerances)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegText leg(text, numbers[i], places[i], looks.legs[i], std::to_string(i + 1));
    leg.writeChain();
    leg.writeBars();
  }
  text.branch({ "platform_joint", "fixed", "tcp_1", "platform", {} }, looks.platform);
  text.tolerances(tolerances, { numbers[0].joint, numbers[1].joint, numbers[2].joint });
  return text.finish();
}

/// What does not move.
std::vector<Solid> baseOf(const Looks& looks)
{
  std::vector<Solid> base = looks.base;
  for (const LegLooks& leg : looks.legs)
    base.push_back(leg.rail);
  return base;
}
}  // namespace

std::string writeUrdf(const Machine& machine)
{
  const auto numbers = numbersOf(withTolerances(machine, {}));
  const Looks looks = looksOf(numbers);
  UrdfText text(machine.name());
  text.link("base_link", baseOf(looks));
  return writeBelow(text, numbers, { placesOf(numbers[0]), placesOf(numbers[1]), placesOf(numbers[2]) }, looks,
                    tolerancesOf(machine));
}

std::string writeUrdf(const MachineDescription& machine)
{
  const auto legs = describedLegs(machine);
  const std::array<LegNumbers, 3> numbers = { legs[0].numbers, legs[1].numbers, legs[2].numbers };
  const Looks looks = looksOf(numbers, machine.tool);
  UrdfText text(machine.name);
  if (machine.mount)
  {
    const Vector3d& rpy = machine.mount->rpy;
    text.link("world");
    text.branch({ "mount", "fixed", "world", "base_link", { machine.mount->xyz, { rpy.x(), rpy.y(), rpy.z() } } },
                baseOf(looks));
  }
  else
    text.link("base_link", baseOf(looks));
  return writeBelow(text, numbers, { legs[0].places, legs[1].places, legs[2].places }, looks, machine.tolerances);
}
}  // namespace pkm_workspace
