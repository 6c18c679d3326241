// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "pkm_workspace/dexterity/box_kernel.h"

namespace pkm_workspace
{
/// Verdicts on boxes for one machine and one criterion. Each is a theorem or UNDECIDED; there is no tolerance.
/// Thread-safe: constant after construction.
class BoxTest
{
public:
  /// @throws std::invalid_argument when the criterion is not valid
  BoxTest(const Machine& machine, const Criterion& criterion);

  const MachineModel<double>& model() const { return model_; }

  /// The arithmetic for many boxes at a time.
  const BoxKernel& kernel() const { return *kernel_; }

  /// One look at the box as a whole, without subdivision.
  BoxVerdict classify(const Box& box) const;
  BoxVerdict operator()(const Box& box) const { return classify(box); }

  /// The verdict on a single point; UNDECIDED only within rounding of the border.
  BoxVerdict classify(const Eigen::Vector3d& point) const { return classify(Box{ point, point }); }

  /// How far a point is from violating the criterion, in floating point, without unit: negative where it is violated,
  /// and the more so the worse. For finding points, not for proving anything.
  double margin(const Eigen::Vector3d& point) const;

private:
  MachineModel<double> model_;
  std::shared_ptr<const BoxKernel> kernel_;
};
}  // namespace pkm_workspace
