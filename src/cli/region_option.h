// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common_options.h"

namespace pkm_workspace
{
namespace cli
{
/// What bounds the points that count, for Command::remedy().
constexpr const char* REGION_REMEDY = "a region by --shape, --center and --size";

/// One region by --shape, --proportions, --ratio, --center and --size; all of them, or none.
class RegionOption
{
public:
  void declare(Options& options);
  /// @pre for all of these, the options have been parsed
  bool given() const { return center_.has_value(); }
  const ShapePtr& shape() const { return query_.shape; }
  const Eigen::Vector3d& center() const { return *center_; }
  double size() const { return *size_; }

private:
  ShapeOptions options_;
  RegionQuery query_;
  std::optional<Eigen::Vector3d> center_;
  std::optional<double> size_;
};
}  // namespace cli
}  // namespace pkm_workspace
