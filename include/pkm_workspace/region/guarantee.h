// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
/// How much of something every point of a region has. Values with defaults; validate() tells what is wrong.
struct GuaranteeQuery
{
  Criterion criterion = {};  ///< its aspect and what is known of the joints count, its set and bounds do not
  double accuracy = 1e-4;    ///< wanted relative width of the bracket, from 1e-12 to 1
  Budget budget;             ///< of each number

  void validate(Problems& problems) const;
};

/// The best value of one bound that a region keeps: the largest one of a bound from below, the least of one from above.
struct Guarantee
{
  const CriterionBound* bound = nullptr;
  std::string counting;  ///< with what is known of the joints, in words: " by joints up to 1 m/s"
  /// Encloses it; the end that asks for less is proved for every point of the region, and no better one than the other
  /// end is kept at the place. From 0 (or to infinity) where nothing is proved.
  Interval value = 0.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< the worst point of the region that was found [m]
  std::optional<Limit> limit;  ///< what binds there: the bound, for which leg, or what is not reached
  bool is_reached = false;     ///< whether every point is proved to be reached in the aspect
  bool complete = false;       ///< whether the accuracy was met
  std::int64_t boxes = 0;
  double seconds = 0.0;

  /// The end that is proved for every point.
  double proved() const { return bound->is_lower ? value.lower() : value.upper(); }
};

/// Whether a guarantee can be asked for: a bound that need not be there, of which all is known that it counts with.
/// @param missing gets what is not known
bool canBeGuaranteed(const Machine& machine, const Criterion& criterion, const CriterionBound& bound,
                     Problems& missing);

/// The bracket for c + K(h), by proofs that all of it keeps a number (checkContainment) and by points of it that do not
/// keep a better one. @throws std::invalid_argument when the query is not valid or canBeGuaranteed() is not true
Guarantee guaranteed(const Machine& machine, const GuaranteeQuery& query, const CriterionBound& bound,
                     const Shape& shape, const Eigen::Vector3d& center, double size);
}  // namespace pkm_workspace
