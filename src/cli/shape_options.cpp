// SPDX-License-Identifier: BSD-3-Clause
#include "shape_options.h"

#include <stdexcept>

#include "pkm_workspace/import/vertices_file.h"

namespace pkm_workspace
{
namespace cli
{
void ShapeOptions::declareNames(Options& options)
{
  Words names = shapeNames();
  names.insert(names.end(), { "cylinder", "polytope" });
  options.choice("shape", wish_.name, names, "what to look for; a square and a disc lie in the plane xy");
  options.vector("proportions", wish_.proportions, "A B C", NUMBER_NOT_NEGATIVE,
                 "of a box: its sides are size A, size B and size C, in metres");
  options.range("ratio", wish_.ratio, NUMBER_POSITIVE,
                "of a cylinder: least and largest radius over height; the one of the largest volume is found");
  options.points("vertices", wish_.vertices,
                 "of a polytope: an STL, or lines of X Y Z; it is their convex hull, times the size", readVertices);
  options.vector("seen-from", seen_from_, "X Y Z", LENGTH,
                 "point of the file's hull that is the center of regions; without it, its origin");
}

void ShapeOptions::check(const Words& more, Options& options, RegionQuery& query)
{
  Words names = { "shape", "proportions", "ratio", "vertices", "seen-from" };
  names.insert(names.end(), more.begin(), more.end());
  options.check(names, [this, &query](Problems& problems) {
    try
    {
      if (seen_from_ && wish_.vertices.empty())
        throw std::invalid_argument("--seen-from is for a polytope by its --vertices");
      ShapeWish wish = wish_;
      for (Eigen::Vector3d& vertex : wish.vertices)
        vertex -= seen_from_.value_or(Eigen::Vector3d::Zero());
      setShape(wish, query);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  });
}

void ShapeOptions::declareOfSize(Options& options, RegionQuery& query)
{
  declareNames(options);
  check({}, options, query);
}

void ShapeOptions::declare(Options& options, RegionQuery& query)
{
  declareNames(options);
  options.number("radius", wish_.radius, LENGTH_POSITIVE,
                 "in place of --ratio, of a cylinder that is to be as high as it can");
  options.number("height", wish_.height, LENGTH_POSITIVE,
                 "in place of --ratio, of a cylinder that is to be as wide as it can");
  options.pair("footprint", wish_.footprint, "A B", LENGTH_POSITIVE,
               "in place of --proportions, sides along x and y of a box that is to be as high as it can");
  check({ "radius", "height", "footprint" }, options, query);
}

void PlaceOptions::declare(Options& options, RegionQuery& query)
{
  options.box("search-box", wish_.search_box,
              "where the center may be, of a region that stands the middle of its base; without it, anywhere");
  options.vector("center", wish_.center, "X Y Z", LENGTH, "the one center to look at, in place of --search-box");
  options.number("base-z", wish_.base_z, LENGTH, "height that the lowest face of the region lies at");
  options.flag("turned", wish_.turned,
               "the region may be turned about the vertical: the largest over all angles; not for round shapes");
  options.check({ "search-box", "center", "base-z", "turned" }, [this, &query](Problems& problems) {
    try
    {
      if (query.shape)
        setPlace(wish_, query);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(reason.what());
    }
  });
}
}  // namespace cli
}  // namespace pkm_workspace
