// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace bench
{
/// What the list algorithm has proved.
struct ListAnswer
{
  double size = 0.0;              ///< edge of a region whose points are all dextrous [m]
  double size_upper_bound = 0.0;  ///< no such region is larger, in either aspect [m]
  std::int64_t boxes = 0;         ///< boxes of centers looked at
  std::int64_t looks = 0;         ///< boxes of points and points looked at
};

/// How the list algorithm goes about it.
enum class ListWay
{
  EIGENVALUES,  ///< Eigen's eigenvalues of the middle; in steps of one digit of accuracy, as section 2.4 of the paper
                ///< does
  MINORS,       ///< the same test without computing eigenvalues; at once: the fastest peer that we could make
};

/// The largest cube or square by a list of boxes of centers, on natural interval extensions and a Weyl/Rohn test of the
/// eigenvalues. Independent of interval/, dexterity/ and region/.
///
/// Boost.Interval computes with the rounding mode set once, upward: its lower bounds are negated upper bounds. That is
/// the one way to use it that is fast and that g++ does not break; the mode is put back at the end.
/// @param machine with rails along axes of the root frame @param edges (1, 1, 1) for a cube, (1, 1, 0) for a square
/// @param centers where the center may be [m]; a side may have zero width
/// @param accuracy of size_upper_bound - size [m]
ListAnswer findLargestByList(ListWay way, const Machine& machine, const Eigen::Vector3d& edges, const Box& centers,
                             double accuracy);

/// M by the same means: bisects the box until every part is proved dextrous. @return boxes looked at; 0 if not proved
std::int64_t verifyByList(ListWay way, const Machine& machine, const Box& box);
}  // namespace bench
}  // namespace pkm_workspace
