// SPDX-License-Identifier: BSD-3-Clause
#include "leg_forms.h"

#include <algorithm>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
bool turns(const urdf::Joint& joint)
{
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

bool isCarriedByFixedJoints(const urdf::Joint& joint, const Model& model)
{
  const auto path = jointsFromRoot(joint, model);
  return std::all_of(path.begin(), path.end() - 1, [](const auto* above) { return above->type == urdf::Joint::FIXED; });
}

/// The way down from a link, through fixed joints, to a joint that follows the crank; empty where there is none.
std::vector<const urdf::Joint*> wayToFollower(const urdf::Link& link, const urdf::Joint& crank, const Model& model)
{
  for (const auto& joint : link.child_joints)
  {
    if (turns(*joint) && joint->mimic && model.masters.at(joint->name).source == crank.name)
      return { joint.get() };
    if (joint->type != urdf::Joint::FIXED)
      continue;
    auto way = wayToFollower(model.link(joint->child_link_name), crank, model);
    if (way.empty())
      continue;
    way.insert(way.begin(), joint.get());
    return way;
  }
  return {};
}
}  // namespace

std::vector<const urdf::Joint*> jointsFromRoot(const urdf::Joint& joint, const Model& model)
{
  std::vector<const urdf::Joint*> joints;
  for (const urdf::Joint* next = &joint; next != nullptr; next = model.link(next->parent_link_name).parent_joint.get())
    joints.push_back(next);
  std::reverse(joints.begin(), joints.end());
  return joints;
}

const char* nameOf(LegForm form)
{
  switch (form)
  {
    case LegForm::TELESCOPE:
      return "a strut of variable length";
    case LegForm::CRANK:
      return "a crank with a forearm";
    default:
      return "a strut of fixed length on a slider";
  }
}

LegForm formOf(const urdf::Joint& joint, const Model& model)
{
  if (joint.type != urdf::Joint::PRISMATIC)
    return LegForm::CRANK;
  const auto path = jointsFromRoot(joint, model);
  const auto hinges = std::count_if(path.begin(), path.end() - 1, [](const auto* above) { return turns(*above); });
  return hinges >= 2 ? LegForm::TELESCOPE : LegForm::SLIDER;
}

std::vector<const urdf::Joint*> elbowOf(const urdf::Joint& crank, const Model& model)
{
  return wayToFollower(model.link(crank.child_link_name), crank, model);
}

bool isCrank(const urdf::Joint& joint, const Model& model)
{
  return turns(joint) && !joint.mimic && isCarriedByFixedJoints(joint, model) && !elbowOf(joint, model).empty();
}

std::vector<std::string> driveJoints(const Model& model)
{
  std::vector<std::string> names;
  for (const auto& name : model.document.joints)
    if (model.joint(name).type == urdf::Joint::PRISMATIC || isCrank(model.joint(name), model))
      names.push_back(name);
  return names;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
