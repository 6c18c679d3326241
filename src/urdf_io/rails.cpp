// SPDX-License-Identifier: BSD-3-Clause
#include "rails.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
std::string listOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const auto& name : names)
    list += (list.empty() ? "'" : ", '") + name + "'";
  return list.empty() ? "none" : list;
}

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
  const std::string list = listOf(prismaticJoints(model));
  if (names.size() != 3)
    problems.add() << "rails names " << names.size() << " joints (" << listOf(names)
                   << "), expected three of the prismatic joints: " << list;
  for (auto name = names.begin(); name != names.end(); ++name)
    if (model.tree->joints_.count(*name) == 0)
      problems.add() << "rails names '" << *name << "', which is no joint; the prismatic joints are: " << list;
    else if (model.joint(*name).type != urdf::Joint::PRISMATIC)
      problems.add() << "rails names joint '" << *name << "', which is " << typeOf(model.joint(*name))
                     << "; the prismatic joints are: " << list;
    else if (std::find(names.begin(), name, *name) != name)
      problems.add() << "rails names joint '" << *name << "' twice, expected three different ones";
}

std::vector<std::string> railNames(const Model& model, const std::vector<std::string>& names)
{
  Problems problems;
  if (!names.empty())
    checkNamed(model, names, problems);
  const auto found = names.empty() ? prismaticJoints(model) : names;
  if (names.empty() && found.size() != 3)
    problems.add() << "the robot has " << found.size() << " prismatic joints (" << listOf(found)
                   << "), expected the three rails; of more, rails may name three";
  problems.throwIfAny();
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
    problems.add() << "rail '" << joint.name << "' follows joint '" << joint.mimic->joint_name
                   << "' by <mimic>, expected an actuated joint";
  for (const urdf::Joint* above : jointsFromRoot(joint, model))
    if (above != &joint && above->type != urdf::Joint::FIXED)
      problems.add() << "rail '" << joint.name << "' is carried by joint '" << above->name << "', which is "
                     << typeOf(*above) << "; expected fixed joints between the root link and a rail";
}

/// Widens the axis by one double.
void widen(IntervalVector& axis)
{
  const double infinity = std::numeric_limits<double>::infinity();
  axis[0] = Interval(std::nextafter(axis[0].lower(), -infinity), axis[0].upper());
}

IntervalVector negative(const IntervalVector& v)
{
  return { -v[0], -v[1], -v[2] };
}

bool isSingle(const IntervalVector& v)
{
  return v[0].isSingle() && v[1].isSingle() && v[2].isSingle();
}

/// Enclosures of the axes that are the same numbers, or their negatives, where the directions are proved to be parallel
/// and nowhere else: Machine takes the same numbers for one direction.
std::array<IntervalVector, 3> distinctAxes(const std::array<Direction, 3>& directions)
{
  std::array<IntervalVector, 3> axes;
  for (std::size_t i = 0; i < 3; ++i)
  {
    axes[i] = directions[i].enclosure;
    for (std::size_t j = 0; j < i; ++j)
      if (const int sign = exactlyParallel(directions[i], directions[j]))
        axes[i] = sign > 0 ? axes[j] : negative(axes[j]);
    const auto looks_parallel = [&](std::size_t j) {
      return !isSingle(axes[i]) && exactlyParallel(directions[i], directions[j]) == 0 &&
             (axes[i] == axes[j] || axes[i] == negative(axes[j]));
    };
    while ((i > 0 && looks_parallel(0)) || (i > 1 && looks_parallel(1)))
      widen(axes[i]);
  }
  return axes;
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
  problems.throwIfAny();
  const auto axes = distinctAxes(directions);
  for (std::size_t i = 0; i < 3; ++i)
    rails[i].axis = axes[i];
  return rails;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
