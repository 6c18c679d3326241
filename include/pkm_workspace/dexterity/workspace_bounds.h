// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Encloses the largest |n_i| / b_i that the conditions of the criterion allow in any leg; nothing where none of them
/// bounds it. Legs tell their outer bounds by it.
std::optional<Interval> steepest(const Machine& machine, const Criterion& criterion);

/// The joint limits that the criterion asks for and a point may reach that satisfies the rest of it [m]: an end is
/// infinite where the reach of the three legs, with the margin that psi_max gives, proves that it does. The set of
/// the criterion is the same with these limits.
std::array<Interval, 3> limitsThatBind(const Machine& machine, const Criterion& criterion);

/// A box that contains every point of the criterion's set [m]. It may be infinite (parallel rails without joint
/// limits), or not valid (the set is empty).
Box boundsOfSet(const Machine& machine, const Criterion& criterion);

/// Whether nothing but joint values changes along the rails: they are parallel, and so are all zones.
bool onlyJointsChangeAlongRails(const Machine& machine, const Criterion& criterion);

/// Whether nothing at all changes along the rails: no joint limit is asked for either.
bool slidesAlongRails(const Machine& machine, const Criterion& criterion);

/// The direction of parallel rails: that of the first.
const IntervalVector& directionOfRails(const Machine& machine);

/// The axis of coordinates (0, 1 or 2) that parallel rails run along most.
int mainAxisOfRails(const Machine& machine);

/// A flat box that contains every point of the set with p_axis = level [m]. @pre no rail is across that axis
Box boundsAcrossRails(const Machine& machine, const Criterion& criterion, int axis, double level);

/// Whether the box is not longer than 1000 struts: beyond that nothing could be settled.
bool isBounded(const Box& box, const Machine& machine);

/// boundsOfSet() where it is bounded. @throws Unbounded otherwise
Box workspaceBounds(const Machine& machine, const Criterion& criterion);
}  // namespace pkm_workspace
