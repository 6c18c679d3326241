// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_draft.h"

#include <cmath>
#include <limits>

#include "decimal_number.h"
#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Kind = DraftKey::Kind;

constexpr double DEGREE = M_PI / 180.0;

/// A height that nobody gave is a round number of micrometres.
constexpr double PER_METRE = 1e6;

/// What is not given of a leg, for each leg.
constexpr double USUAL_ANGLES[] = { 0.0, 120.0, 240.0 };
}  // namespace

const std::vector<DraftKey>& legKeys()
{
  static const std::vector<DraftKey> keys = {
    { "joint", Kind::NAME, 1, "NAME", "name of the rail's joint; without it, rail_1, rail_2, rail_3" },
    { "angle", Kind::ANGLE, 1, "ANGLE",
      "where the leg stands around the machine, counter-clockwise from x; without it, 0, 120 and 240 degrees" },
    { "rail_radius", Kind::LENGTH, 1, "R",
      "from the middle of the machine to the strut's joint on the slider at home, or to the rail with --slider-joint" },
    { "x", Kind::LENGTH, 1, "X", "place of the rail, with y, in place of a radius" },
    { "y", Kind::LENGTH, 1, "Y", "place of the rail, with x, in place of a radius" },
    { "lean", Kind::ANGLE, 2, "OUT SIDE",
      "how far the rail leans from the vertical: outwards first, then counter-clockwise; without it, 0 0" },
    { "length", Kind::LENGTH, 1, "L", "of the strut, from joint to joint" },
    { "platform_radius", Kind::LENGTH, 1, "r",
      "from the middle of the platform to the strut's joint; without it 0: R is then the difference of the radii" },
    { "slider_joint", Kind::LENGTH, 3, "OUT SIDE UP",
      "the strut's joint, seen from the slider's place on its rail; without it, 0 0 0" },
    { "platform_joint", Kind::LENGTH, 3, "OUT SIDE UP",
      "the strut's joint, seen from its place on the platform's circle; without it, 0 0 0" },
    { "travel", Kind::LENGTH, 2, "LO HI", "joint values that the slider can take" },
    { "home", Kind::LENGTH, 1, "Q",
      "joint value of the slider when the machine is homed, with home_height; without it, 0" },
    { "home_height", Kind::LENGTH, 1, "Z",
      "height of the slider then; without it, the tool touches z = 0 with all sliders at the lower end" },
    { "joint_speed_max", Kind::SPEED, 1, "V", "largest speed of its slider; without it, none is known" },
    { "joint_effort_max", Kind::FORCE, 1, "F", "largest force on its slider; without it, none is known" },
    { "working_mode", Kind::SIGN, 1, "-1|1",
      "-1: the strut hangs below its slider, 1: it stands on it; without it, -1" },
  };
  return keys;
}

const std::vector<DraftKey>& machineKeys()
{
  static const std::vector<DraftKey> keys = {
    { "tool", Kind::LENGTH, 3, "X Y Z", "the tool point, seen from the middle of the platform; without it, 0 0 0" },
    { "assembly", Kind::SIDE, 1, "lower|upper",
      "where the platform is when the struts can meet on both sides (rails that lie); without it, lower" },
    { "mount", Kind::LENGTH, 3, "X Y Z", "where the machine stands in a frame \"world\"; without it, there is none" },
    { "mount_rpy", Kind::ANGLE, 3, "ROLL PITCH YAW", "how it is turned there; without it, 0 0 0" },
  };
  return keys;
}

/// Turns texts into numbers and collects what is wrong.
class MachineDraft::Reader
{
public:
  explicit Reader(const MachineDraft& draft) : draft_(draft) {}

  Problems problems;

  /// The values of a key in metres and radians. @return nothing where it was not given
  std::optional<std::vector<double>> find(const Values& values, const std::string& name, Kind kind)
  {
    const auto given = values.find(name);
    if (given == values.end())
      return std::nullopt;
    std::vector<double> numbers;
    for (const std::string& text : given->second.texts)
      numbers.push_back(number(text, name, kind, given->second.place));
    return numbers;
  }
  double one(const Values& values, const char* name, Kind kind, double otherwise)
  {
    const auto numbers = find(values, name, kind);
    return numbers ? numbers->front() : otherwise;
  }
  Vector3d three(const Values& values, const char* name, Kind kind)
  {
    const auto numbers = find(values, name, kind);
    return numbers ? Vector3d(numbers->data()) : Vector3d(Vector3d::Zero());
  }

  bool isUpper(const Values& values)
  {
    const auto given = values.find("assembly");
    const std::string side = given == values.end() ? "lower" : given->second.texts.front();
    if (side != "lower" && side != "upper")
      complain(problems, given->second.place, ": assembly = '", shortened(side, 60), "', expected lower or upper");
    return side == "upper";
  }

  /// A leg with all that its values say; its height is that of joint value 0, counted from the home height or from 0.
  LegDescription leg(std::size_t i)
  {
    const Values& values = draft_.legs_[i];
    LegDescription leg;
    const auto name = values.find("joint");
    leg.joint = name == values.end() ? "rail_" + std::to_string(i + 1) : name->second.texts.front();
    leg.radius = one(values, "rail_radius", Kind::LENGTH, 0.0);
    leg.length = one(values, "length", Kind::LENGTH, 0.0);
    const auto lean = find(values, "lean", Kind::ANGLE).value_or(std::vector<double>{ 0.0, 0.0 });
    leg.lean = lean[0];
    leg.side_lean = lean[1];
    place(values, i, leg);
    leg.slider_joint = three(values, "slider_joint", Kind::LENGTH);
    leg.platform_joint = three(values, "platform_joint", Kind::LENGTH);
    leg.platform_joint.x() += one(values, "platform_radius", Kind::LENGTH, 0.0);
    const auto travel = find(values, "travel", Kind::LENGTH).value_or(std::vector<double>{ 0.0, 1.0 });
    leg.lower = travel[0];
    leg.upper = travel[1];
    leg.speed = one(values, "joint_speed_max", Kind::SPEED, leg.speed);
    leg.effort = one(values, "joint_effort_max", Kind::FORCE, leg.effort);
    leg.working_mode = one(values, "working_mode", Kind::SIGN, -1.0) > 0.0 ? 1 : -1;
    putHome(values, i, leg);
    checkRadii(values, i);
    return leg;
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
    const double rail = one(values, "rail_radius", Kind::LENGTH, 1.0);
    if (!(rail > 0.0))
      complain(problems, values.at("rail_radius").place, ": rail_radius of leg ", i + 1, " = ", rail,
               " m, expected a positive length; angle says on which side the rail is");
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
    if ((x || y) && values.count("rail_radius") > 0)
      complain(problems, values.at("rail_radius").place, ": rail_radius and x, y of leg ", i + 1,
               " both say where its rail is; give one of them");
    const double usual = x && y ? std::atan2(leg.foot.y(), leg.foot.x()) : USUAL_ANGLES[i] * DEGREE;
    leg.angle = one(values, "angle", Kind::ANGLE, usual);
  }

  std::string expected(Kind kind) const
  {
    if (kind == Kind::SIGN)
      return "-1 or 1";
    if (kind == Kind::SPEED || kind == Kind::FORCE)
      return kind == Kind::SPEED ? "a positive number [m/s]" : "a positive number [N]";
    return "a number [" + (kind == Kind::LENGTH ? draft_.unit : "degrees") + "]";
  }

  double number(const std::string& text, const std::string& name, Kind kind, const std::string& place)
  {
    const auto decimal = firmware::Decimal::parse(text);
    const bool is_drive = kind == Kind::SPEED || kind == Kind::FORCE;
    if (!decimal || (kind == Kind::SIGN && std::abs(decimal->nearest()) != 1.0) ||
        (is_drive && !(decimal->nearest() > 0.0)))
      complain(problems, place, ": ", name, " = '", shortened(text, 60), "', expected ", expected(kind));
    if (!decimal)
      return 0.0;
    if (kind == Kind::LENGTH)
      return draft_.unit == "mm" ? (*decimal * firmware::Decimal(1, -3)).nearest() : decimal->nearest();
    return kind == Kind::ANGLE ? decimal->nearest() * DEGREE : decimal->nearest();
  }

  const MachineDraft& draft_;
};

namespace
{
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

void MachineDraft::setLeg(std::size_t leg, const DraftKey& key, const Texts& texts, const std::string& place)
{
  legs_.at(leg)[key.name] = { texts, place };
}

void MachineDraft::setMachine(const DraftKey& key, const Texts& texts, const std::string& place)
{
  machine_[key.name] = { texts, place };
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
  std::array<bool, 3> has_place{}, has_length{}, has_travel{}, has_height{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    machine.legs[i] = reader.leg(i);
    has_place[i] = legs_[i].count("rail_radius") + legs_[i].count("x") + legs_[i].count("y") > 0;
    has_length[i] = legs_[i].count("length") > 0;
    has_travel[i] = legs_[i].count("travel") > 0;
    has_height[i] = legs_[i].count("home_height") > 0;
  }
  askFor("rail_radius", "the distance of its rail from the middle of the machine, or its x and y", has_place,
         reader.problems);
  askFor("length", "that of its strut", has_length, reader.problems);
  askFor("travel", "the least and the largest joint value of its slider", has_travel, reader.problems);
  const bool any_height = has_height[0] || has_height[1] || has_height[2];
  if (any_height)
    askFor("home_height", "other legs have one", has_height, reader.problems);
  machine.tool = reader.three(machine_, "tool", Kind::LENGTH);
  machine.is_upper = reader.isUpper(machine_);
  if (machine_.count("mount") + machine_.count("mount_rpy") > 0)
    machine.mount =
        Mount{ reader.three(machine_, "mount", Kind::LENGTH), reader.three(machine_, "mount_rpy", Kind::ANGLE) };
  if (reader.problems.empty())
    machine.validate(reader.problems);
  if (reader.problems.empty() && !any_height)
    standOnTheTable(machine, reader.problems);
  throwProblems(reader.problems);
  return machine;
}
}  // namespace pkm_workspace
