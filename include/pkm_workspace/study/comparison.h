// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/singularity.h"
#include "pkm_workspace/paving/range_workspace.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
/// Why a comparison refuses regions that may be turned.
constexpr char NOT_TURNED[] = "machines are compared by regions that are not turned";

/// What section 4.4 of the paper compares machines by.
struct Comparison
{
  Machine machine;
  RegionQuery query;
  LargestRegion region;           ///< the rest has no meaning when its size is 0
  JointIntervals ranges = {};     ///< of the joints over the region, equalised as the paper does [m]
  RangeWorkspace workspace = {};  ///< all that is reachable within these ranges, by aspects
  Singularities in_region = {};   ///< at the points of the region
  Singularities in_ranges = {};   ///< at all points with joint values within the ranges, in either aspect

  std::array<Interval, 3> each(Interval JointRange::*part) const;  ///< of the three joints [m]
  Interval largest(Interval JointRange::*part) const;              ///< of the three joints [m]
};

/// Told what is computed just now.
using Tell = std::function<void(const std::string&)>;

/// What volumes are compared to, relative, unless something else is asked for.
constexpr double VOLUME_ACCURACY = 1e-3;

/// Finds the largest region, then what follows from it. The time limit is shared by all parts.
/// @throws std::invalid_argument for a query that is not valid, has no bounded answer, or is about both aspects at once
Comparison comparisonOf(const Machine& machine, const RegionQuery& query, double volume_accuracy, const Tell& tell);

/// One number of a study.
struct Figure
{
  std::string key;    ///< for JSON
  std::string label;  ///< for people
  int power;          ///< of the metre in its unit
  Interval value;     ///< encloses it; empty where there is none

  /// What it is for the machine scaled to a region of size 1.
  Interval scaled(double size) const;
};

/// What a region's size is, for people: "cube: edge [m]".
std::string sizeOf(const Shape& shape);

/// All numbers of a study, always in the same order; none without a region.
std::vector<Figure> figuresOf(const Comparison& study);

/// The three kinds of serial singularity as one: of the least |eta_i|.
SingularityAnswer least(const std::array<SingularityAnswer, 3>& serial);
}  // namespace pkm_workspace
