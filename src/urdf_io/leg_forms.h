// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// What the first movable joint of a leg makes of it, and which joints no mimic undoes (docs/urdf.md).
enum class LegForm
{
  SLIDER,     ///< a prismatic joint first, then passive joints: a sliding strut
  TELESCOPE,  ///< passive joints first, a prismatic one between these and the wrist: a strut of variable length
  CRANK       ///< a revolute joint first that the next movable joint undoes: a crank
};

/// The joints from the root link to @p joint, this included.
std::vector<const urdf::Joint*> jointsFromRoot(const urdf::Joint& joint, const Model& model);

/// "a sliding strut" and so on.
const char* nameOf(LegForm form);

/// The form of the leg that the joint drives. @pre it is prismatic or a crank
LegForm formOf(const urdf::Joint& joint, const Model& model);

/// Whether the joint turns, is carried by fixed joints alone, and is undone by the next movable joint below it.
bool isCrank(const urdf::Joint& joint, const Model& model);

/// The joints from a crank's child link to the one that undoes it, this included. @pre isCrank()
std::vector<const urdf::Joint*> elbowOf(const urdf::Joint& crank, const Model& model);

/// All joints that may drive a leg, in the order of the file.
std::vector<std::string> driveJoints(const Model& model);
}  // namespace urdf_io
}  // namespace pkm_workspace
