// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "pkm_workspace/dexterity/machine_forms.h"

namespace pkm_workspace
{
/// Box verification, the paper's M(B) (section 2.2): about all points of a box. Not the answer of a containment test.
enum class BoxVerdict
{
  INSIDE,     ///< every point is proved to satisfy the criterion
  OUTSIDE,    ///< no point does, proved
  UNDECIDED,  ///< neither is proved
};

/// Verdicts on boxes for one machine and one criterion. Each is a theorem or UNDECIDED; there is no tolerance.
/// Thread-safe: constant after construction.
class BoxTest
{
public:
  /// @throws std::invalid_argument when the criterion is not valid
  BoxTest(const Machine& machine, const Criterion& criterion);

  const MachineModel<double>& model() const { return model_; }

  /// One look at the box as a whole, without subdivision. Cost: about half a microsecond.
  BoxVerdict classify(const Box& box) const;

  /// M(B): bisects until every part is INSIDE, every part is OUTSIDE, or parts of both kinds are found.
  /// @param min_width parts are not bisected below this width [m]; > 0
  /// @param max_boxes parts looked at at the most
  BoxVerdict verify(const Box& box, double min_width, std::int64_t max_boxes = 1000000) const;

  /// The verdict on a single point; UNDECIDED only within rounding of the border.
  BoxVerdict classify(const Eigen::Vector3d& point) const { return classify(Box{ point, point }); }

  /// How far a point is from violating the criterion, in floating point, without unit: negative where it is violated,
  /// and the more so the worse. For finding points, not for proving anything.
  double margin(const Eigen::Vector3d& point) const;

private:
  MachineModel<double> model_;
};
}  // namespace pkm_workspace
