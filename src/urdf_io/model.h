// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <map>
#include <string>

#include "document.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The tree of links and joints as urdfdom reads it, with what it rounds or leaves open.
struct Model
{
  urdf::ModelInterfaceSharedPtr tree;
  Document document;
  std::map<std::string, JointFollower>
      masters;  ///< for each joint the one that its <mimic> leads to in the end, or itself

  const urdf::Joint& joint(const std::string& name) const { return *tree->joints_.at(name); }
  const urdf::Link& link(const std::string& name) const { return *tree->links_.at(name); }
  const Origin& originOf(const urdf::Joint& joint) const { return document.origins.at(joint.name); }
};

/// "revolute" and so on.
std::string typeOf(const urdf::Joint& joint);

inline Eigen::Vector3d axisOf(const urdf::Joint& joint)
{
  return { joint.axis.x, joint.axis.y, joint.axis.z };
}

/// Reads the text. @throws std::invalid_argument listing all that the file itself has wrong, whatever machine it
/// describes
Model readModel(const std::string& xml);
}  // namespace urdf_io
}  // namespace pkm_workspace
