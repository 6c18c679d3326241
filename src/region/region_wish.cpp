// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/region_wish.h"

#include <cmath>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/growing_prisms.h"
#include "pkm_workspace/region/path.h"
#include "pkm_workspace/region/polytope.h"
#include "pkm_workspace/region/turned_region.h"

namespace pkm_workspace
{
namespace
{
template <class... Words>
[[noreturn]] void refuse(const Words&... words)
{
  TextStream text;
  (text << ... << words);
  throw std::invalid_argument(text.str());
}

/// A measure that the shape has no use for.
void refuseFor(const ShapeWish& wish, const char* measure, const char* shape)
{
  refuse(measure, " is for the shape ", shape, " only, the shape is ", wish.name);
}

void requireOwnMeasures(const ShapeWish& wish)
{
  const bool is_cylinder = wish.name == "cylinder";
  if (wish.ratio && !is_cylinder)
    refuseFor(wish, "a ratio", "cylinder");
  if (wish.radius && !is_cylinder)
    refuseFor(wish, "a radius", "cylinder");
  if (wish.height && !is_cylinder)
    refuseFor(wish, "a height", "cylinder");
  if (wish.footprint && wish.name != "box")
    refuseFor(wish, "a footprint", "box");
  if (!wish.vertices.empty() && wish.name != "polytope")
    refuseFor(wish, "a list of vertices", "polytope");
}

void setRatio(const RatioRange& ratio, RegionQuery& query)
{
  if (!(ratio.lower <= ratio.upper))
    refuse("ratio = [", ratio.lower, ", ", ratio.upper, "] must have the least one first");
  makeCylinder(ratio.lower);
  query.shape = makeCylinder(ratio.upper);
  if (ratio.lower < ratio.upper)
    query.ratio = ratio;
}

void setCylinder(const ShapeWish& wish, RegionQuery& query)
{
  const int given = int(wish.ratio.has_value()) + int(wish.radius.has_value()) + int(wish.height.has_value());
  if (given == 0)
    refuse(
        "shape = cylinder needs a ratio: the least and the largest of radius over height; or a radius, to be as high "
        "as it can, or a height, to be as wide as it can");
  if (given > 1)
    refuse(
        "a cylinder takes one of ratio, radius and height: two of them leave nothing to look for; for the same in "
        "every size give the ratio of radius over height twice, and whether one of given measures fits tells a check");
  if (wish.ratio)
    setRatio(*wish.ratio, query);
  else
    query.shape =
        wish.radius ? makeCylinderOfRadius(*wish.radius, Stand::ABOUT_CENTER) : makeCylinderOfHeight(*wish.height);
  if (wish.proportions && *wish.proportions != 2.0 * query.shape->halfExtents().per_size)
    refuse("proportions are for the shape box only, the shape is cylinder");
}
}  // namespace

namespace
{
void setPolytope(const ShapeWish& wish, RegionQuery& query)
{
  if (wish.proportions)
    refuseFor(wish, "a list of proportions", "box");
  if (wish.vertices.empty())
    refuse("shape = polytope needs vertices: points whose hull it is, as seen from its center");
  query.shape = makePolytope(wish.vertices);
}
}  // namespace

bool ShapeWish::hasMeasures() const
{
  return proportions || ratio || radius || height || footprint || !vertices.empty();
}

ShapeWish ShapeWish::as(const std::string& shape) const
{
  ShapeWish wish;
  wish.name = shape;
  if (shape == "box")
  {
    wish.proportions = proportions;
    wish.footprint = footprint;
  }
  if (shape == "cylinder")
  {
    wish.ratio = ratio;
    wish.radius = radius;
    wish.height = height;
  }
  if (shape == "polytope")
    wish.vertices = vertices;
  return wish;
}

void setShape(const ShapeWish& wish, RegionQuery& query)
{
  requireOwnMeasures(wish);
  query.ratio.reset();
  if (wish.name == "cylinder")
    setCylinder(wish, query);
  else if (wish.name == "polytope")
    setPolytope(wish, query);
  else if (wish.footprint && wish.proportions)
    refuse("a box takes either proportions or a footprint");
  else if (wish.footprint)
    query.shape = makeBoxOfFootprint((*wish.footprint)[0], (*wish.footprint)[1]);
  else
    query.shape = makeShape(wish.name, wish.proportions);
}

namespace
{
void requireWithin(const char* name, const Eigen::Vector3d& point)
{
  if (!point.allFinite() || point.cwiseAbs().maxCoeff() > FARTHEST)
    refuse(name, " = (", point.x(), ", ", point.y(), ", ", point.z(), ") m must be finite, within 1e9 m");
}

void stand(double z, const std::optional<Box>& search_box, RegionQuery& query)
{
  if (!(std::abs(z) <= FARTHEST))
    refuse("base_z = ", z, " m must be finite, within 1e9 m");
  query.shape = query.shape->standing();
  Box base = search_box.value_or(Box{ Eigen::Vector3d::Constant(-FARTHEST), Eigen::Vector3d::Constant(FARTHEST) });
  if (!(base.lower.z() <= z && z <= base.upper.z()))
    refuse("the search box goes from z = ", base.lower.z(), " m to ", base.upper.z(), " m and base_z = ", z,
           " m is not between them: it bounds the middle of the base, so let it hold that height");
  base.lower.z() = base.upper.z() = z;
  query.search_box = base;
  query.base_z = z;
}
}  // namespace

void setPlace(const PlaceWish& wish, RegionQuery& query)
{
  if (wish.center && wish.search_box)
    refuse("a center and a search box: only one of the two can be given");
  if (wish.center && wish.base_z)
    refuse(
        "a center and base_z exclude each other, as the size decides how high above its base a region has its center: "
        "for a base about (X, Y) give the search box X X Y Y Z Z and base_z = Z");
  if (wish.base_z && !query.shape->standing() && query.shape->kind() == "polytope")
    refuse(
        "base_z asks for a polytope about a point of its lowest face, and moves it there where that is exact: give its "
        "vertices as seen from such a point, so that the lowest z is 0");
  if (wish.base_z && !query.shape->standing())
    refuse("base_z is for regions with a lowest face, and a ", query.shape->name(),
           " has none: give a shape that has one, or a search box");
  query.search_box = wish.search_box;
  query.base_z.reset();
  if (wish.center)
  {
    requireWithin("center", *wish.center);
    query.search_box = Box{ *wish.center, *wish.center };
  }
  if (wish.base_z)
    stand(*wish.base_z, wish.search_box, query);
  query.angles = 0.0;
  if (wish.turned)
    setTurned(query);
}
}  // namespace pkm_workspace
