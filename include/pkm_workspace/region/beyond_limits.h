// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/region/joint_ranges.h"
#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// How far one rail goes: encloses the least and the largest of its joint values [m]. The lower end of the one and the
/// upper end of the other are never passed; the two ends between are reached.
struct JointReach
{
  Interval least;
  Interval largest;
};
using JointReaches = std::array<JointReach, 3>;

JointReaches reachOver(const std::array<JointRange, 3>& ranges);
/// Over a region that is good; nothing is known where a strut only just reaches it.
JointReaches reachOver(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center, double size);
/// At a point. @param rho joint values [m]
JointReaches reachAt(const std::array<Interval, 3>& rho);
/// Over what these are about together.
JointReaches united(const JointReaches& a, const JointReaches& b);

/// Along a path that is good: what is reached is known from the ends and the middles of its segments, of ever fewer of
/// them where they are more than 10000.
class PathReach
{
public:
  /// @param machine has to outlive this object
  explicit PathReach(const Machine& machine);

  void add(const PathSegment& segment);
  /// @param motion over the whole path
  JointReaches over(const PathMotion& motion) const;

private:
  const Machine& machine_;
  std::array<double, 3> least_;    ///< values that are no less than the least one [m]
  std::array<double, 3> largest_;  ///< and no more than the largest one
  std::size_t segments_ = 0;
  std::size_t taken_ = 0;
  std::size_t stride_ = 1;
};

/// One end of a rail's limits that is passed, proved.
struct BeyondLimit
{
  int leg = 0;            ///< 0, 1, 2
  bool is_upper = false;  ///< which limit
  Interval by = 0.0;      ///< encloses how far [m], > 0
};

/// All of these; none where the machine has no joint limits. @param reaches nothing of no point
std::vector<BeyondLimit> beyondLimits(const Machine& machine, const std::optional<JointReaches>& reaches);

/// What an answer without joint limits means for the limits, in a sentence: which rails would leave theirs and by how
/// much, that none would, or that it is not proved. Empty where joint limits were asked for, where there are none, and
/// of no point. Of a set or of several regions, "by at least" is about the point that is worst.
std::string remarkOnLimits(const Machine& machine, const Criterion& criterion,
                           const std::optional<JointReaches>& reaches);

/// A message with the remark as a further sentence.
std::string withRemark(const std::string& message, const std::string& remark);
}  // namespace pkm_workspace
