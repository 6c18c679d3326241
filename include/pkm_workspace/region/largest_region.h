// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/common/pace.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/shape.h"

namespace pkm_workspace
{
struct Reason;

/// How far a computation has come; sizes and volumes as in LargestRegion. Brackets only get narrower: of sizes, where
/// the ratio is free of volumes (the height may get less when a wider cylinder has the larger volume).
struct RegionProgress
{
  double size = 0.0;
  double size_upper_bound = 0.0;
  double volume = 0.0;
  double volume_upper_bound = 0.0;
  std::int64_t boxes_done = 0;
  std::int64_t boxes_open = 0;
  double seconds = 0.0;
};

/// Ratios of radius over height that a cylinder may have.
struct RatioRange
{
  double lower;
  double upper;
};

/// What to look for. Values with defaults; validate() tells what is wrong.
struct RegionQuery
{
  ShapePtr shape = makeCube();
  std::optional<RatioRange> ratio;  ///< of a cylinder whose ratio is free: then the largest volume counts
  Criterion criterion;
  /// Wanted: size_upper_bound - size [m, or the unit of the shape's size]; > 0. Of a free ratio: that no volume is
  /// above that of the cylinder found if its height, at the same ratio, were larger by this.
  double accuracy = 1e-3;
  Precision precision = Precision::DOUBLE;
  std::optional<Box> search_box;  ///< bounds the center [m]; a side may have zero width
  /// Where centers are searched in place of the tightest box around the set: a wider one, whose derivation is simple.
  std::optional<Box> plain_bounds;
  std::optional<double> base_z;                         ///< regions stand on this plane [m]: see setPlace()
  Interval angles = 0.0;                                ///< by which regions may be turned about z [rad]: setTurned()
  Budget budget;                                        ///< max_boxes counts boxes of centers
  std::function<void(const RegionProgress&)> progress;  ///< called now and then, if given
  double progress_period = PROGRESS_PERIOD;             ///< [s], >= 0
  ProofLog<Box, Reason> closed;  ///< told each box of centers that is closed (reason.h), if given; of a free ratio or
                                 ///< where regions turn nothing

  void validate(Problems& problems) const;
  /// Whether the search box says anything about the centers along an axis.
  bool bounds(int axis) const;
  /// Whether there is one but for the plane that regions stand on.
  bool hasSearchBox() const { return search_box && (!base_z || bounds(0) || bounds(1)); }
  /// Whether regions may be turned about the vertical.
  bool turns() const { return angles != Interval(0.0); }
  /// Where centers are to be along an axis that leaves them free: in the middle of the search box, otherwise at the
  /// zero configuration [m].
  double levelAlong(int axis, const Machine& machine) const;
  /// Where regions are looked for, in words: "wherever its center", "standing on z = 0.5 m".
  std::string place() const;
};

/// What may be asked for, in the unit of the size: as a length of the region, 1e-18 to 1000 times the longest strut.
struct AccuracyRange
{
  double finest;
  double coarsest;
};
AccuracyRange accuracyRange(const Machine& machine, const Shape& shape);
/// The machine's default, or what comes nearest to it in that range; of a polytope, as a length of the region.
double defaultAccuracy(const Machine& machine, const Shape& shape);
/// Appends one sentence when the accuracy is out of that range.
void validateAccuracy(const Machine& machine, const RegionQuery& query, Problems& problems);

struct LargestRegion
{
  enum class Status
  {
    PROVEN,   ///< the bracket is as narrow as the accuracy
    STOPPED,  ///< a budget, the stop flag or the precision ended the search; the bracket holds all the same
    NONE,     ///< no region of size >= accuracy exists, of a free ratio: of the largest one's volume at it; size is 0
  };

  Status status = Status::STOPPED;
  ShapePtr shape;                                    ///< the query's, or the cylinder of the ratio that was found
  std::optional<RatioRange> ratio;                   ///< the query's: then the bracket is that of the volume
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< [m], in the machine's root frame; meaningless when size is 0
  double size = 0.0;                                 ///< certified: c + size K satisfies the criterion
  /// About z, from x to y, by which K is turned there [rad]: certified of every angle within 2^-50 of it, relative.
  std::optional<double> angle;
  /// Certified: no such region is larger, anywhere in the search box. Of a free ratio: no cylinder is higher, whatever
  /// its ratio; the cylinder of the largest volume may be far below.
  double size_upper_bound = 0.0;
  double volume = 0.0;                     ///< of the region, rounded down [m^3]; 0 when it is flat
  double volume_upper_bound = 0.0;         ///< certified: no such region has a larger one, whatever its ratio [m^3]
  std::array<JointRange, 3> joint_ranges;  ///< over the region; meaningless when size is 0
  std::int64_t boxes = 0;                  ///< boxes of centers looked at
  std::int64_t verification_boxes = 0;     ///< boxes looked at in proving regions
  bool out_of_memory = false;              ///< the memory ended the search
  double seconds = 0.0;
  std::string message;  ///< one sentence: what ended the search, what to do about it
};

/// Sets status, message and, unless the ratio is free, the volumes by the bounds.
/// @param ended_by what ended the search early, if anything: Budget::endedBy()
/// @param finer whether a finer precision may settle more
void conclude(LargestRegion& region, double accuracy, const std::string& ended_by, bool finer);

/// Finds the largest region c + K(h) of the criterion's set with a certified size and a certified upper bound
/// (paper, section 2.4; docs/theory.md). The search is over all centers of the workspace in the machine's aspect, or
/// over the search box. Where all rails are parallel, the coordinate of the center along which the rails run most is
/// the one of the zero configuration, or the middle of the search box; as near to it as joint limits leave it.
/// @throws std::invalid_argument for a query that is not valid or has no bounded answer, with all reasons
LargestRegion findLargestRegion(const Machine& machine, const RegionQuery& query);

/// The paper's C(x, y, z): the same for one given center [m].
LargestRegion largestRegionAt(const Machine& machine, const RegionQuery& query, const Eigen::Vector3d& center);
}  // namespace pkm_workspace
