// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/interval/growing.h"

namespace pkm_workspace
{
/// A form over a box of centers that is not negative at any center which carries a region.
struct ReasonTerm
{
  enum class Kind
  {
    CONDITION,  ///< what the criterion makes necessary at a point of the body
    BAD_POINT,  ///< a point that is proved to be bad does not lie in the region
    TRAVEL,     ///< the joint limits and the search box leave it a way along parallel rails
    SPHERE      ///< a point of the body lies on the side of a strut sphere that the region is on
  };

  Kind kind;
  GrowingVector place = scaling(Eigen::Vector3d::Zero());    ///< of all but bad points: the point of the body
  FormOrigin origin = { { ConditionKind::REACH }, {}, {} };  ///< of a condition: what the form says
  Eigen::Vector3d point = Eigen::Vector3d::Zero();           ///< of a bad point: itself; of a sphere: its center [m]
  AffineForm<double> form{};                                 ///< over the box of centers, without unit
  double weight = 1.0;                                       ///< >= 0
  std::optional<Subject> limit{};                            ///< of the travel: the joint limit; none of the search box
};

/// Why no center of a box carries a region of a size, nor of a larger one: the sum of the terms' forms, times their
/// weights, is negative all over the box. None where what is known is worth as much, or where nothing is proved.
struct Reason
{
  Closing closing = Closing::UNSETTLED;
  Box centers;  ///< of which it is proved, and over which the forms are: the box, or one around it
  double size = 0.0;
  std::vector<ReasonTerm> terms;
};
}  // namespace pkm_workspace
