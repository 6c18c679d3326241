// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/dexterity/strut_sphere.h"
#include "pkm_workspace/dexterity/zone_forms.h"

namespace pkm_workspace
{
/// The arithmetic of verdicts: doubles only, or doubles first and multi-precision for the boxes that these leave open.
enum class Precision
{
  DOUBLE,
  MULTIPLE,
};

/// Verdicts on boxes for one machine and one criterion. Each is a theorem or UNDECIDED; there is no tolerance.
/// Thread-safe: constant after construction.
class BoxTest
{
public:
  /// Boxes narrower than this, relative to the longest strut, may need multi-precision.
  static constexpr double NARROW = 1e-8;

  /// @throws std::invalid_argument when the criterion is not valid
  BoxTest(const Machine& machine, const Criterion& criterion, Precision precision = Precision::DOUBLE);

  const MachineModel<double>& model() const { return model_; }

  /// Spheres where det A is 0 although no form may tell: those of the machine where only the sign of det A is asked
  /// for.
  const std::vector<StrutSphere>& spheres() const { return spheres_; }

  /// The zones that the tool keeps out of.
  const std::vector<ZoneToKeepOut>& zonesToKeepOut() const { return keep_out_; }

  /// The arithmetic for many boxes at a time.
  const BoxKernel& kernel() const { return *kernel_; }

  /// The arithmetic for a box that doubles have left undecided; nullptr where they have to be enough.
  const BoxKernel* finerKernel(const Box& box) const;

  /// Whether a part of a proof is too narrow for what any arithmetic at hand could settle.
  bool isBeyondPrecision(const Box& box) const;

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
  std::vector<StrutSphere> spheres_;
  std::vector<ZoneToKeepOut> keep_out_;
  std::shared_ptr<const BoxKernel> kernel_;
  std::shared_ptr<const BoxKernel> precise_kernel_;
  double scale_;  ///< the longest strut [m]
  double least_width_;
  bool is_tolerated_;  ///< whether the machine stands for all within tolerances
};
}  // namespace pkm_workspace
