// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_draft.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "draft_values.h"
#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Kind = DraftKey::Kind;

/// A height that nobody gave is a round number of micrometres.
constexpr double PER_METRE = 1e6;

/// What is not given of a leg, for each leg.
constexpr double USUAL_ANGLES[] = { 0.0, 120.0, 240.0 };
const char* const USUAL_NAMES[] = { "rail_", "strut_", "crank_" };

/// What no machine can be made without, said once where no leg has it.
void askFor(const char* name, const std::string& what, const std::array<bool, 3>& has, Problems& problems)
{
  std::string legs;
  for (std::size_t i = 0; i < 3; ++i)
    if (!has[i])
      legs += (legs.empty() ? "" : ", ") + std::to_string(i + 1);
  if (!legs.empty())
    complain(problems, name, " is missing", legs == "1, 2, 3" ? "" : " for leg " + legs, ": ", what);
}

std::string kindsOf(const DraftKey& key)
{
  std::vector<std::string> names;
  for (std::size_t kind = 0; kind < LEG_KINDS.size(); ++kind)
    if ((key.legs & (1U << kind)) != 0)
      names.emplace_back(LEG_KINDS[kind]);
  return "kind " + joined(names, " and ");
}
}  // namespace

/// Turns texts into numbers and collects what is wrong.
class MachineDraft::Reader : public DraftValues
{
public:
  explicit Reader(const MachineDraft& draft) : DraftValues(draft.unit), draft_(draft)
  {
    for (std::size_t i = 0; i < 3; ++i)
      kinds_[i] = word(draft.legs_[i], "kind", LEG_KINDS);
  }

  /// The values of a leg that its kind has.
  Values valuesOf(std::size_t i)
  {
    Values values = draft_.legs_[i];
    const std::size_t kind = kinds_[i];
    for (const DraftKey& key : legKeys())
      if ((key.legs & (1U << kind)) == 0 && values.count(key.name) > 0)
      {
        if (!values[key.name].is_shared)
          complain(problems, values[key.name].place, ": ", key.name, " of leg ", i + 1, ", which is of kind ",
                   LEG_KINDS[kind], ": it has none");
        values.erase(key.name);
      }
    return values;
  }

  /// What is said of all legs counts for one of them at least.
  void checkShared()
  {
    for (const DraftKey& key : legKeys())
    {
      const bool counts =
          std::any_of(kinds_.begin(), kinds_.end(), [&](std::size_t kind) { return (key.legs & (1U << kind)) != 0; });
      const auto given = draft_.legs_[0].find(key.name);
      if (!counts && given != draft_.legs_[0].end() && given->second.is_shared)
        complain(problems, given->second.place, ": ", key.name, " is a number of ", kindsOf(key),
                 " only, and no leg is of such a kind");
    }
  }

  /// A leg with all that its values say; its height is that of joint value 0, counted from the home height or from 0.
  LegDescription leg(std::size_t i)
  {
    const Values values = valuesOf(i);
    LegDescription leg;
    leg.kind = static_cast<LegDescription::Kind>(kinds_[i]);
    const auto name = values.find("joint");
    leg.joint = name == values.end() ? USUAL_NAMES[static_cast<std::size_t>(leg.kind)] + std::to_string(i + 1)
                                     : name->second.texts.front();
    leg.radius = one(values, "rail_radius", Kind::LENGTH, one(values, "base_radius", Kind::LENGTH, 0.0));
    leg.length = one(values, "length", Kind::LENGTH, 0.0);
    const auto lean = find(values, "lean", Kind::ANGLE).value_or(std::vector<double>{ 0.0, 0.0 });
    leg.lean = lean[0];
    leg.side_lean = lean[1];
    place(values, i, leg);
    leg.slider_joint = three(values, "slider_joint", Kind::LENGTH);
    leg.platform_joint = three(values, "platform_joint", Kind::LENGTH);
    leg.platform_joint.x() += one(values, "platform_radius", Kind::LENGTH, 0.0);
    turns = leg.kind == LegDescription::Kind::CRANK;
    const auto travel =
        find(values, "travel", turns ? Kind::ANGLE : Kind::LENGTH).value_or(std::vector<double>{ 0.0, 1.0 });
    leg.lower = travel[0];
    leg.upper = travel[1];
    leg.speed = one(values, "joint_speed_max", Kind::SPEED, leg.speed);
    leg.effort = one(values, "joint_effort_max", Kind::FORCE, leg.effort);
    leg.working_mode = one(values, "working_mode", Kind::SIGN, -1.0) > 0.0 ? 1 : -1;
    leg.crank = one(values, "crank", Kind::LENGTH, leg.crank);
    leg.crank_zero = one(values, "crank_zero", Kind::ANGLE, leg.crank_zero);
    leg.axis_lean = one(values, "axis_lean", Kind::ANGLE, leg.axis_lean);
    leg.turn = one(values, "turn", Kind::SIGN, 1.0) > 0.0 ? 1 : -1;
    leg.height = one(values, "base_height", Kind::LENGTH, 0.0);
    if (leg.kind == LegDescription::Kind::RAIL)
      putHome(values, i, leg);
    checkRadii(values, i);
    return leg;
  }

  /// @return whether heights are given: of home, or of what is no rail
  bool askForMissing(const MachineDescription& machine)
  {
    std::array<bool, 3> has_rail{}, has_base{}, has_crank{}, has_length{}, has_travel{}, has_height{};
    bool stands = false;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto has = [&](const char* name) { return draft_.legs_[i].count(name) > 0; };
      const bool is_rail = machine.legs[i].kind == LegDescription::Kind::RAIL;
      const bool is_placed = has("x") || has("y");
      has_rail[i] = !is_rail || is_placed || has("rail_radius");
      has_base[i] = is_rail || is_placed || has("base_radius");
      has_crank[i] = machine.legs[i].kind != LegDescription::Kind::CRANK || has("crank");
      has_length[i] = has("length");
      has_travel[i] = has("travel");
      has_height[i] = !is_rail || has("home_height");
      stands = stands || has_height[i];
    }
    askFor("rail_radius", "the distance of its rail from the middle of the machine, or its x and y", has_rail,
           problems);
    askFor("base_radius", "the distance of its crank's axis or foot from the middle of the machine, or its x and y",
           has_base, problems);
    askFor("crank", "the length of its crank", has_crank, problems);
    askFor("length", "that of its strut", has_length, problems);
    askFor("travel", "the least and the largest joint value", has_travel, problems);
    if (stands)
      askFor("home_height", "other legs have a height", has_height, problems);
    return stands;
  }

private:
  /// Radius and height are those of the slider at home; a description has them at joint value 0.
  void putHome(const Values& values, std::size_t i, LegDescription& leg)
  {
    const double home = one(values, "home", Kind::LENGTH, 0.0);
    if (values.count("home") > 0 && values.count("home_height") == 0)
      complain(problems, values.at("home").place, ": home of leg ", i + 1,
               " says where the slider is at home, and home_height at which height that is; give both or neither");
    const Vector3d way = home * railDirection(leg);
    leg.radius -= way.x();
    leg.slider_joint.y() -= way.y();
    leg.height = one(values, "home_height", Kind::LENGTH, 0.0) - way.z();
  }

  void checkRadii(const Values& values, std::size_t i)
  {
    const double platform = one(values, "platform_radius", Kind::LENGTH, 0.0);
    for (const char* const name : { "rail_radius", "base_radius" })
      if (const double radius = one(values, name, Kind::LENGTH, 1.0); !(radius > 0.0))
        complain(problems, values.at(name).place, ": ", name, " of leg ", i + 1, " = ", radius,
                 " m, expected a positive length; angle says on which side the ",
                 std::string(name) == "rail_radius" ? "rail" : "leg", " is");
    if (!(platform >= 0.0))
      complain(problems, values.at("platform_radius").place, ": platform_radius of leg ", i + 1, " = ", platform,
               " m, expected none or a positive length");
  }

  void place(const Values& values, std::size_t i, LegDescription& leg)
  {
    const auto x = find(values, "x", Kind::LENGTH);
    const auto y = find(values, "y", Kind::LENGTH);
    if (x && y)
      leg.foot = { x->front(), y->front() };
    else if (x || y)
      complain(problems, "leg ", i + 1, ": x and y belong together, and ", x ? "y" : "x", " is missing");
    for (const char* const name : { "rail_radius", "base_radius" })
      if ((x || y) && values.count(name) > 0)
        complain(problems, values.at(name).place, ": ", name, " and x, y of leg ", i + 1, " both say where its ",
                 std::string(name) == "rail_radius" ? "rail" : "base", " is; give one of them");
    const double usual = x && y ? std::atan2(leg.foot.y(), leg.foot.x()) : USUAL_ANGLES[i] * DEGREE;
    leg.angle = one(values, "angle", Kind::ANGLE, usual);
  }

  const MachineDraft& draft_;
  std::array<std::size_t, 3> kinds_{};
};

namespace
{
/// Moves all sliders so that the tool touches z = 0 when they are at the lower ends of their travels.
void standOnTheTable(MachineDescription& machine, Problems& problems)
{
  const Vector3d lowest(machine.legs[0].lower, machine.legs[1].lower, machine.legs[2].lower);
  const auto tool = assembledTool(machine, lowest);
  if (!tool)
    complain(problems,
             "with all sliders at the lower end of their travel, at one height, the struts do not meet: check "
             "length, rail_radius and platform_radius, or give home_height");
  else
    for (LegDescription& leg : machine.legs)
      leg.height = std::round((leg.height - tool->z()) * PER_METRE) / PER_METRE;
}
}  // namespace

void MachineDraft::setLeg(std::size_t leg, const DraftKey& key, const Texts& texts, const std::string& place,
                          bool is_shared)
{
  legs_.at(leg)[key.name] = { texts, place, is_shared };
}

void MachineDraft::setMachine(const DraftKey& key, const Texts& texts, const std::string& place)
{
  machine_[key.name] = { texts, place, true };
}

bool MachineDraft::isEmpty() const
{
  return legs_[0].empty() && legs_[1].empty() && legs_[2].empty() && machine_.empty();
}

MachineDescription MachineDraft::finished() const
{
  Reader reader(*this);
  MachineDescription machine;
  machine.name = name;
  for (std::size_t i = 0; i < 3; ++i)
    machine.legs[i] = reader.leg(i);
  reader.checkShared();
  const bool stands = reader.askForMissing(machine);
  machine.tool = reader.three(machine_, "tool", Kind::LENGTH);
  machine.is_upper = reader.word(machine_, "assembly", std::array<const char*, 2>{ "lower", "upper" }) == 1;
  if (machine_.count("mount") + machine_.count("mount_rpy") > 0)
    machine.mount =
        Mount{ reader.three(machine_, "mount", Kind::LENGTH), reader.three(machine_, "mount_rpy", Kind::ANGLE) };
  if (reader.problems.empty())
    machine.validate(reader.problems);
  if (reader.problems.empty() && !stands)
    standOnTheTable(machine, reader.problems);
  throwProblems(reader.problems);
  return machine;
}
}  // namespace pkm_workspace
