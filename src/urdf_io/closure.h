// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "leg_geometry.h"
#include "rails.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// One leg from its slider to the link that stands for the tool point.
struct ClosedLeg
{
  Station tcp;
  LegGeometry geometry;       ///< in the slider's frame
  IntervalVector tool_point;  ///< the tool point by this leg, at zero, in the root frame [m]
};

/// Closes the loops: finds one link on each leg's platform so that the three coincide at zero. Of several such triples
/// the one whose least depth (number of fixed joints below the wrist) is largest counts, and of those the one with the
/// fewest fixed joints in all.
/// @param tcp_links names them outright, in any order; empty: any link fixed to the last one of a wrist
/// @throws std::invalid_argument when no or no single triple coincides, or a leg is not as the design has it
std::array<ClosedLeg, 3> closeLegs(const Model& model, const std::array<Rail, 3>& rails,
                                   const std::vector<std::string>& tcp_links);
}  // namespace urdf_io
}  // namespace pkm_workspace
