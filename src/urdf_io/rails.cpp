// SPDX-License-Identifier: BSD-3-Clause
#include "rails.h"

#include <algorithm>

#include "notice.h"
#include "number_text.h"
#include "pkm_workspace/machine/rails.h"
#include "refusal.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
void checkNamed(const Model& model, const std::vector<std::string>& names, Problems& problems)
{
  const std::string list = listOf(driveJoints(model), "none");
  if (names.size() != 3)
    complain(problems, "rails names ", names.size(), " joints (", listOf(names, "none"),
             "), expected three of the prismatic joints and cranks: ", list);
  for (auto name = names.begin(); name != names.end(); ++name)
    if (model.tree->joints_.count(*name) == 0)
      complain(problems, "rails names '", *name,
               "', which is not a joint; the prismatic joints and cranks are: ", list);
    else if (model.joint(*name).type != urdf::Joint::PRISMATIC && !isCrank(model.joint(*name), model))
      complain(problems, "rails names joint '", *name, "', which is ", typeOf(model.joint(*name)),
               " and no crank; the prismatic joints and cranks are: ", list);
    else if (std::find(names.begin(), name, *name) != name)
      complain(problems, "rails names joint '", *name, "' twice, expected three different ones");
}

std::vector<std::string> railNames(const Model& model, const std::vector<std::string>& names)
{
  Problems problems;
  if (!names.empty())
    checkNamed(model, names, problems);
  const auto found = names.empty() ? driveJoints(model) : names;
  if (names.empty() && found.size() != 3)
    complain(problems, "the robot has ", found.size(), " prismatic joints and cranks (", listOf(found, "none"),
             "), expected the three that drive the legs; of more, rails may name three");
  throwRefusal(problems);
  return found;
}

void checkRail(const urdf::Joint& joint, const Model& model, Problems& problems)
{
  if (joint.mimic)
    complain(problems, "rail '", joint.name, "' follows joint '", joint.mimic->joint_name,
             "' by <mimic>, expected an actuated joint");
  for (const urdf::Joint* above : jointsFromRoot(joint, model))
    if (above != &joint && above->type != urdf::Joint::FIXED && formOf(joint, model) != LegForm::TELESCOPE)
      complain(problems, "rail '", joint.name, "' is carried by joint '", above->name, "', which is ", typeOf(*above),
               "; expected fixed joints between the root link and a rail");
}

IntervalVector negative(const IntervalVector& v)
{
  return { -v[0], -v[1], -v[2] };
}

constexpr double SHORTEST_CRANK = 1e-9;  ///< [m]

/// The elbow has to undo the crank exactly: parallel axes, and as much the other way round.
void checkElbow(const urdf::Joint& crank, const urdf::Joint& elbow, const Direction& axis, const Direction& other,
                const Model& model, Problems& problems)
{
  const JointFollower& follower = model.masters.at(elbow.name);
  const int sense = exactlyParallel(axis, other);
  if (sense == 0)
    complain(problems, "joint '", elbow.name, "' follows the crank '", crank.name,
             "' about another axis; expected one that is parallel to its, exactly, to undo it");
  else if (follower.factor != -sense || follower.offset != 0.0)
    complain(problems, "joint '", elbow.name, "' follows the crank '", crank.name, "' with multiplier ",
             numberText(follower.factor), " and offset ", numberText(follower.offset), ", expected ", -sense,
             " and 0, to undo it");
}

/// Where the passive joints of the leg begin.
void setStart(const Model& model, Rail& rail, const Direction& axis, Problems& problems)
{
  rail.start = rail.joint->child_link_name;
  if (rail.form == LegForm::CRANK)
  {
    const auto way = elbowOf(*rail.joint, model);
    for (const urdf::Joint* joint : way)
      rail.slider = rail.slider.then(model.originOf(*joint));
    rail.start = way.back()->child_link_name;
    checkElbow(*rail.joint, *way.back(), axis, directionIn(rail.slider, axisOf(*way.back())), model, problems);
    const Interval radius = lengthOf(cross(axis.enclosure, rail.slider.position - rail.origin));
    if (!(radius.lower() > SHORTEST_CRANK))
      complain(problems, "crank '", rail.joint->name, "': its elbow is ", roundedText(radius.mid(), 3),
               " m from its axis, expected more than ", roundedText(SHORTEST_CRANK, 3), " m");
  }
  if (rail.form != LegForm::TELESCOPE)
    return;
  rail.slider = Frame();
  for (const urdf::Joint* joint : jointsFromRoot(*rail.joint, model))
  {
    rail.start = joint->parent_link_name;
    rail.first = joint->name;
    if (joint->type != urdf::Joint::FIXED)
      return;
    rail.slider = rail.slider.then(model.originOf(*joint));
  }
}

/// Sets the directions that rails share, and the axes: the same numbers, or their negatives, for one direction.
void setAxes(const std::array<Direction, 3>& directions, std::array<Rail, 3>& rails)
{
  const auto sense = [&](std::size_t i, std::size_t j) {
    const bool slide = rails[i].form == LegForm::SLIDER && rails[j].form == LegForm::SLIDER;
    return slide ? exactlyParallel(directions[i], directions[j]) : 0;
  };
  const std::array<int, 3> shared = sharedDirections(sense);
  for (std::size_t i = 0; i < 3; ++i)
  {
    rails[i].direction = shared[i];
    rails[i].axis = directions[i].enclosure;
    for (std::size_t j = 0; j < i; ++j)
      if (const int found = sense(i, j))
        rails[i].axis = found > 0 ? rails[j].axis : negative(rails[j].axis);
  }
}
}  // namespace

std::array<Rail, 3> findRails(const Model& model, const std::vector<std::string>& names)
{
  const auto found = railNames(model, names);
  Problems problems;
  std::array<Rail, 3> rails;
  std::array<Direction, 3> directions;
  for (std::size_t i = 0; i < 3; ++i)
  {
    rails[i].joint = &model.joint(found[i]);
    rails[i].form = formOf(*rails[i].joint, model);
    checkRail(*rails[i].joint, model, problems);
    for (const urdf::Joint* joint : jointsFromRoot(*rails[i].joint, model))
      rails[i].slider = rails[i].slider.then(model.originOf(*joint));
    directions[i] = directionIn(rails[i].slider, axisOf(*rails[i].joint));
    rails[i].origin = rails[i].slider.position;
    setStart(model, rails[i], directions[i], problems);
  }
  throwRefusal(problems);
  setAxes(directions, rails);
  return rails;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
