// SPDX-License-Identifier: BSD-3-Clause
#include "region_option.h"

#include <stdexcept>

namespace pkm_workspace
{
namespace cli
{
void BodyOption::declare(Options& options)
{
  options_.declareOfSize(options, query_);
  options.number("size", size_, LENGTH_POSITIVE,
                 "edge, radius, factor or height of the region, as pkm largest tells it");
  options.vector("sides", sides_, "A B C", LENGTH_NOT_NEGATIVE,
                 "in place of --shape and --size, full sides of a box along x, y and z; 0 for no thickness");
  options.number("radius", radius_, LENGTH_NOT_NEGATIVE,
                 "in place of --shape and --size, of a sphere; with --height, of a cylinder along z");
  options.number("height", height_, LENGTH_NOT_NEGATIVE, "of the cylinder whose --radius is given");
  options.check({ "shape", "proportions", "ratio", "vertices", "size" }, [this, &options](Problems& problems) {
    if (!size_ &&
        (options.given("shape") || options.given("proportions") || options.given("ratio") || options.given("vertices")))
      problems.push_back("--shape needs --size: they give a region together");
    if (query_.ratio)
      problems.push_back("--ratio of a region that is given is one number: give it twice");
  });
  options.check({ "size", "sides", "radius", "height" }, [this](Problems& problems) {
    try
    {
      if (given())
        solid_ = read();
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  });
}

Solid BodyOption::read() const
{
  if (int(size_.has_value()) + int(sides_.has_value()) + int(radius_ || height_) > 1)
    throw std::invalid_argument("give a region by one of --size, --sides and --radius");
  if (size_)
    return makeSolid(query_.shape, *size_);
  if (sides_)
    return makeSolid(SolidKind::BOX, { sides_->x(), sides_->y(), sides_->z() });
  if (!radius_)
    throw std::invalid_argument("--height needs --radius: they give a cylinder together");
  return height_ ? makeSolid(SolidKind::CYLINDER, { *height_, *radius_ }) : makeSolid(SolidKind::SPHERE, { *radius_ });
}

void RegionOption::declare(Options& options, std::optional<PlacedSolid>& region)
{
  body_.declare(options);
  options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
  options.check({ "center", "size", "sides", "radius", "height" }, [this, &region](Problems& problems) {
    if (center_.has_value() != body_.given())
      problems.push_back("--center and --size, --sides or --radius go together: they give a region");
    else if (center_)
      region = PlacedSolid{ body_.solid(), *center_ };
  });
}
}  // namespace cli
}  // namespace pkm_workspace
