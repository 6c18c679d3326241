// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/solid.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
namespace
{
/// Products with sizes have to stay ordinary numbers [m].
constexpr double LEAST_LENGTH = 1e-100;

bool isOrdinary(double length)
{
  return length >= LEAST_LENGTH && length <= FARTHEST;
}

void requireDimensions(const std::vector<double>& dimensions, const std::string& meaning, std::size_t count)
{
  const auto is_zero = [](double length) { return length == 0.0; };
  const auto is_good = [&](double length) { return is_zero(length) || isOrdinary(length); };
  if (dimensions.size() != count || !std::all_of(dimensions.begin(), dimensions.end(), is_good) ||
      std::all_of(dimensions.begin(), dimensions.end(), is_zero))
    throw std::invalid_argument("must be " + meaning);
}

Solid cylinder(double height, double radius)
{
  if (radius == 0.0)  // no thickness across
    return { makeBox({ 0.0, 0.0, height }) };
  return height == 0.0 ? Solid{ makeDisc(), radius } : Solid{ makeCylinder(radius, height) };
}
}  // namespace

CenteredSolid centeredSolid(const Shape& shape, const Eigen::Vector3d& center, double size)
{
  CenteredSolid solid{ center, shape.dimensions(size) };
  const Interval from = encloseAt(shape.lower(), size)[2];
  const Interval to = encloseAt(shape.upper(), size)[2];
  if (from == -to || solid.dimensions.empty())
    return solid;
  const double lowest = (Interval(center.z()) + from).upper();
  const double highest = (Interval(center.z()) + to).lower();
  double& middle = solid.center.z();
  middle = lowest + 0.5 * (highest - lowest);
  const double half =
      std::min((Interval(highest) - Interval(middle)).lower(), (Interval(middle) - Interval(lowest)).lower());
  (shape.isBox() ? solid.dimensions.back() : solid.dimensions.front()) = std::max(0.0, 2.0 * half);
  return solid;
}

Solid makeSolid(SolidKind kind, const std::vector<double>& d)
{
  switch (kind)
  {
    case SolidKind::BOX:
      requireDimensions(d, "three full sides, each 0 or from 1e-100 to 1e9 m, not all 0", 3);
      return { makeBox({ d[0], d[1], d[2] }) };
    case SolidKind::SPHERE:
      requireDimensions(d, "one radius, from 1e-100 to 1e9 m", 1);
      return { makeSphere(), d[0] };
    case SolidKind::CYLINDER:
      requireDimensions(d, "height and radius, each 0 or from 1e-100 to 1e9 m, not both 0", 2);
      return cylinder(d[0], d[1]);
  }
  throw std::logic_error("a kind of solid without a shape");
}

Solid makeSolid(const ShapePtr& shape, double size)
{
  if (!isOrdinary(size))
    throw std::invalid_argument(shape->sizeMeaning() + " must be from 1e-100 to 1e9");
  return { shape, size };
}
}  // namespace pkm_workspace
