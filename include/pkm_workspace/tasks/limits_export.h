// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/import/firmware_limits.h"
#include "pkm_workspace/tasks/placed_solid.h"

namespace pkm_workspace
{
/// A region that is to be written as limits for the configuration of a controller, whose axes are parallel to those of
/// the root link.
struct ExportTask
{
  std::string format;                                ///< one of limitFormats()
  PlacedSolid region;                                ///< in the frame of the root link
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< the controller's zero, in that frame
  /// Whether a cylinder is written that ends below where the switches are.
  bool top_by_slicer = false;
  Budget budget;  ///< of the proof

  /// What is said to help: how the asker gives a cylinder, its center, a box, no joint limits, the above, the origin.
  struct Remedies
  {
    std::string cylinder, center, box, limits_off, by_slicer, origin;
  };
  Remedies remedies = {};

  /// Appends one sentence for each reason why the format cannot hold the body.
  void validateBody(Problems& problems) const;
  /// The same for a body that it can hold, on this machine.
  void validateMachine(const Machine& machine, Problems& problems) const;
  /// What is held, seen from the controller's zero, rounded inward.
  HeldRegion held() const;

private:
  bool isCylinder() const { return region.solid.shape->kind() == "cylinder"; }
};

struct ExportReport
{
  FirmwareLimits limits;
  std::string message;  ///< what is proved of the region
};

/// Proves the region and writes it, with the proof's hypotheses as comments.
/// @throws std::invalid_argument where the task is not valid, or the region not proved
ExportReport exportLimits(const PointEvaluator& evaluator, const ExportTask& task);
}  // namespace pkm_workspace
