// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "options.h"
#include "pkm_workspace/region/region_wish.h"

namespace pkm_workspace
{
namespace cli
{
/// --shape and what goes with it: of the size that is looked for.
class ShapeOptions
{
public:
  /// Sets the shape and ratio of the query.
  void declare(Options& options, RegionQuery& query);
  /// The same for a body of a given size: --shape, --proportions, --ratio, --vertices.
  void declareOfSize(Options& options, RegionQuery& query);

private:
  void declareNames(Options& options);
  void check(const Words& more, Options& options, RegionQuery& query);

  ShapeWish wish_;
  std::optional<Eigen::Vector3d> seen_from_;
};

/// --search-box, --center, --base-z, --turned: where a region may be, and how.
class PlaceOptions
{
public:
  /// Sets it in the query. @pre the shape's options are declared before
  void declare(Options& options, RegionQuery& query);

private:
  PlaceWish wish_;
};
}  // namespace cli
}  // namespace pkm_workspace
