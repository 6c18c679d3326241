// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leg_geometry.h"
#include "pkm_workspace/machine/sliding_strut.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The link that slides, and the unit direction of its rail in that link's frame.
struct RailOfHinges
{
  std::string slider;
  IntervalVector axis;
};

/// What the limits of all joints that turn with a leg's two hinges mean for its strut. At angles t1, t2 of hinges with
/// the axes h1, h2, perpendicular to each other, and h2 across the strut, the strut is n = Rot(h1, t1) Rot(h2, t2) n0:
/// t2 is told by n . h1, which is monotone as long as n does not pass h1, and t1 by the turn about h1 of what is left.
struct HingeStops
{
  std::vector<StrutStop> stops;   ///< in the slider's frame
  std::vector<std::string> open;  ///< why a limit is no stop, one sentence each
};
/// Within a working mode it does not where h1 is across the rail.
/// @param rail of the slider
/// @param leg n0 is its strut; where its axes miss each other, stops hold for all that n may be off by that
HingeStops hingeStops(const Station& station, const LegGeometry& leg, const RailOfHinges& rail, const Model& model);
}  // namespace urdf_io
}  // namespace pkm_workspace
