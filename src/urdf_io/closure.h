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

/// A link that is fixed to the platform, but not where the legs meet.
struct Beyond
{
  std::string link;
  double distance;  ///< from there [m]
};

/// The loops of a machine, closed.
struct Closure
{
  std::array<ClosedLeg, 3> legs;
  double gap = 0.0;            ///< how far the three links are apart as drawn at zero [m]
  double allowed = 0.0;        ///< the most that it may be [m]
  IntervalVector tool;         ///< the tool point, seen from where the legs meet, in the root frame [m]
  std::string named;           ///< the link of the tool point, where one was named
  std::vector<Beyond> beyond;  ///< where nothing tells the tool point
  double scale() const { return legs[0].geometry.length.upper(); }
  /// Whether it is drawn assembled at zero, as far as the digits of a URDF go.
  bool isDrawnAssembled() const { return gap <= urdf_tolerance::COINCIDE / urdf_tolerance::GAP * allowed; }
};

/// Closes the loops: finds one link on each leg's platform so that the three coincide at zero, or nearly. Of several
/// such triples the one whose least depth (number of fixed joints below the wrist) is largest counts, and of those the
/// one with the fewest fixed joints in all.
/// @throws std::invalid_argument when no or no single triple comes close enough, a leg is not as the design has it, or
/// a link that is named is none of them
Closure closeLegs(const Model& model, const std::array<Rail, 3>& rails, const UrdfOptions& options);

/// The names of the three links, quoted.
std::string tcpNames(const Closure& closure);
}  // namespace urdf_io
}  // namespace pkm_workspace
