// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
/// The answer about a region that somebody asks about: not the verdict on all points of a box (BoxVerdict).
enum class Containment
{
  INSIDE,     ///< every point of the region satisfies the criterion, proved
  OUTSIDE,    ///< a point of the region is proved to violate it
  UNDECIDED,  ///< the budget or the precision ended the proof
};

struct ContainmentResult
{
  Containment verdict = Containment::UNDECIDED;
  /// With OUTSIDE: a point of the region that is proved to be bad, or no further from one than bad_within [m].
  std::optional<Eigen::Vector3d> bad_point;
  double bad_within = 0.0;  ///< above 0 where two struts are one vector at the bad point, a singularity [m]
  /// With OUTSIDE, of bodies that are not convex: where in the family that point is.
  std::optional<GrowingVector> bad_place;
  /// With UNDECIDED: the border of the set is within rounding of the region, and no budget would settle it.
  bool is_within_rounding = false;
  std::int64_t boxes = 0;  ///< boxes looked at
  double seconds = 0.0;
};

/// Is told each part of a region's bounding box that is divided, and by which plane across which axis [m].
using CutLog = std::function<void(const Box& part, int axis, double plane)>;

/// Whether c + K(h) satisfies the criterion. Looks for a bad point by local search first and subdivides afterwards.
/// @param budget when it is over, the proof ends: UNDECIDED @param cuts the tree of a proof, if wanted: its leaves are
/// proved, or have no point of the region
ContainmentResult checkContainment(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size,
                                   const Budget& budget, const CutLog& cuts = nullptr);
ContainmentResult checkContainment(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size,
                                   std::int64_t max_boxes = 1000000);
}  // namespace pkm_workspace
