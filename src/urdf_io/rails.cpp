// SPDX-License-Identifier: BSD-3-Clause
#include "rails.h"

#include <algorithm>

#include "notice.h"
#include "pkm_workspace/machine/rails.h"
#include "refusal.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
std::vector<std::string> prismaticJoints(const Model& model)
{
  std::vector<std::string> names;
  for (const auto& name : model.document.joints)
    if (model.joint(name).type == urdf::Joint::PRISMATIC)
      names.push_back(name);
  return names;
}

void checkNamed(const Model& model, const std::vector<std::string>& names, Problems& problems)
{
  const std::string list = listOf(prismaticJoints(model), "none");
  if (names.size() != 3)
    complain(problems, "rails names ", names.size(), " joints (", listOf(names, "none"),
             "), expected three of the prismatic joints: ", list);
  for (auto name = names.begin(); name != names.end(); ++name)
    if (model.tree->joints_.count(*name) == 0)
      complain(problems, "rails names '", *name, "', which is not a joint; the prismatic joints are: ", list);
    else if (model.joint(*name).type != urdf::Joint::PRISMATIC)
      complain(problems, "rails names joint '", *name, "', which is ", typeOf(model.joint(*name)),
               "; the prismatic joints are: ", list);
    else if (std::find(names.begin(), name, *name) != name)
      complain(problems, "rails names joint '", *name, "' twice, expected three different ones");
}

std::vector<std::string> railNames(const Model& model, const std::vector<std::string>& names)
{
  Problems problems;
  if (!names.empty())
    checkNamed(model, names, problems);
  const auto found = names.empty() ? prismaticJoints(model) : names;
  if (names.empty() && found.size() != 3)
    complain(problems, "the robot has ", found.size(), " prismatic joints (", listOf(found, "none"),
             "), expected the three rails; of more, rails may name three");
  throwRefusal(problems);
  return found;
}

/// The joints from the root link to @p joint, this included.
std::vector<const urdf::Joint*> jointsFromRoot(const urdf::Joint& joint, const Model& model)
{
  std::vector<const urdf::Joint*> joints;
  for (const urdf::Joint* next = &joint; next != nullptr; next = model.link(next->parent_link_name).parent_joint.get())
    joints.push_back(next);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

void checkRail(const urdf::Joint& joint, const Model& model, Problems& problems)
{
  if (joint.mimic)
    complain(problems, "rail '", joint.name, "' follows joint '", joint.mimic->joint_name,
             "' by <mimic>, expected an actuated joint");
  for (const urdf::Joint* above : jointsFromRoot(joint, model))
    if (above != &joint && above->type != urdf::Joint::FIXED)
      complain(problems, "rail '", joint.name, "' is carried by joint '", above->name, "', which is ", typeOf(*above),
               "; expected fixed joints between the root link and a rail");
}

IntervalVector negative(const IntervalVector& v)
{
  return { -v[0], -v[1], -v[2] };
}

/// Sets the directions that rails share, and the axes: the same numbers, or their negatives, for one direction.
void setAxes(const std::array<Direction, 3>& directions, std::array<Rail, 3>& rails)
{
  const auto sense = [&](std::size_t i, std::size_t j) { return exactlyParallel(directions[i], directions[j]); };
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
    checkRail(*rails[i].joint, model, problems);
    for (const urdf::Joint* joint : jointsFromRoot(*rails[i].joint, model))
      rails[i].slider = rails[i].slider.then(model.originOf(*joint));
    directions[i] = directionIn(rails[i].slider, axisOf(*rails[i].joint));
  }
  throwRefusal(problems);
  setAxes(directions, rails);
  return rails;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
