// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common_options.h"
#include "pkm_workspace/tasks/placed_solid.h"
#include "shape_options.h"

namespace pkm_workspace
{
namespace cli
{
/// What bounds the points that count, for Command::remedy().
constexpr const char* REGION_REMEDY = "a region by --center and --size, --sides or --radius";

/// One body: by --size with --shape, --proportions and --ratio, or by what it measures: --sides, --radius, --height.
class BodyOption
{
public:
  void declare(Options& options);
  /// Whether a body is asked for, good or bad.
  bool given() const { return size_ || sides_ || radius_ || height_; }
  /// @pre for this, the options have been parsed
  const Solid& solid() const { return solid_; }
  /// Of a box that is given by them.
  const std::optional<Eigen::Vector3d>& sides() const { return sides_; }

private:
  Solid read() const;

  ShapeOptions options_;
  RegionQuery query_;
  std::optional<double> size_;
  std::optional<Eigen::Vector3d> sides_;
  std::optional<double> radius_;
  std::optional<double> height_;
  Solid solid_;
};

/// One region, by a body and its --center; both of them, or none.
class RegionOption
{
public:
  /// Sets the region where one is given.
  void declare(Options& options, std::optional<PlacedSolid>& region);

private:
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
};
}  // namespace cli
}  // namespace pkm_workspace
