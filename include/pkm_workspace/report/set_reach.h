// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/beyond_limits.h"

namespace pkm_workspace
{
/// Whether a paving's box is the section across rails along which nothing changes (defaultBox()).
bool isSectionOfAll(const Machine& machine, const Paving& paving);

/// How far each rail goes over the points of a set, for remarkOnLimits(); all of this takes milliseconds.
///
/// Over the part of the set in the box of a paving: the ends that are reached are known from the paving's inner boxes,
/// those that are never passed from all that are not outside. Of a section across rails along which nothing changes
/// (defaultBox()), the set is meant and not the section: it goes on without end.
/// @return nothing where the set is proved to have no point in the box
std::optional<JointReaches> reachOver(const Machine& machine, const Paving& paving);

/// Over a criterion's set, or over its part in a box [m], by a coarse paving. Where aspects are told apart by the sign
/// of det A only, nothing is said that points where it is 0 would contradict.
/// @return nothing where it has no points, or where joint limits are asked for or missing: nobody would look at it
/// @throws std::invalid_argument when the set has no bounds
std::optional<JointReaches> reachOver(const Machine& machine, const Criterion& criterion,
                                      const std::optional<Box>& box = {});

/// Over all boxes with these sides and one of these centers that are good.
/// @param share of the centers whose boxes are good: ALL, or SOME where only the boxes of @p carriers are known to be
/// @param carriers boxes of centers [m] @param sides [m], at least one > 0
JointReaches reachOverCenters(const Machine& machine, const Criterion& criterion, const Box& centers,
                              const Eigen::Vector3d& sides, Share share, const std::vector<Box>& carriers);

/// Over a region of which it is not known whether all of its points satisfy the criterion: where that cannot be proved,
/// nothing is known of the rails.
/// @return nothing where joint limits are asked for or missing
std::optional<JointReaches> reachOver(const Machine& machine, const Criterion& criterion, const Shape& shape,
                                      const Eigen::Vector3d& center, double size);
}  // namespace pkm_workspace
