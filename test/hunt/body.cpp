// SPDX-License-Identifier: BSD-3-Clause
#include "hunt/body.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;
using Number = Oracle::Number;
using Offset = Oracle::Vector;

bool isWithin(const Number& x, const Number& side)
{
  return 2 * abs(x) <= side;
}

/// Of boxes and cylinders.
bool isWithinHeight(const Number& z, const Number& height, bool stands)
{
  return stands ? z >= 0 && z <= height : isWithin(z, height);
}

/// x / a, where a flat body has 0 / 0.
Number shareOf(const Number& x, const Number& a)
{
  return a > 0 ? Number(x / a) : x == 0 ? Number(0) : Number(2);
}

Vector3d turned(const Vector3d& k, double angle)
{
  return { std::cos(angle) * k.x() - std::sin(angle) * k.y(), std::sin(angle) * k.x() + std::cos(angle) * k.y(),
           k.z() };
}

Body scaling(const ShapeWish& wish, Body::Kind kind, const Vector3d& per_size)
{
  Body body;
  body.wish = wish;
  body.kind = kind;
  body.per_size = per_size;
  return body;
}

Body drawnHull(Random& random, bool is_corner)
{
  const Vector3d a(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), random.uniform(0.2, 1.0));
  ShapeWish wish{ "polytope" };
  for (int axis = 0; axis < 3; ++axis)
  {
    wish.vertices.push_back(a[axis] * Vector3d::Unit(axis));
    if (!is_corner)
      wish.vertices.push_back(-a[axis] * Vector3d::Unit(axis));
  }
  if (is_corner)
    wish.vertices.push_back(Vector3d::Zero());
  return scaling(wish, is_corner ? Body::Kind::CORNER : Body::Kind::OCTAHEDRON, a);
}

/// Cylinders and boxes of which two or one of the measures are given.
Body drawnWithMeasures(Random& random, double scale)
{
  Body body;
  const double given = scale * random.uniform(0.02, 0.2), other = scale * random.uniform(0.02, 0.2);
  body.wish.name = "cylinder";
  body.kind = Body::Kind::ROUND;
  switch (random.integer(0, 2))
  {
    case 0:
      body.wish.radius = given;
      body.fixed.x() = given;
      body.per_size.z() = 1.0;
      return body;
    case 1:
      body.wish.height = given;
      body.fixed.z() = given;
      body.per_size.x() = 1.0;
      return body;
    default:
      body.wish.name = "box";
      body.wish.footprint = std::array<double, 2>{ given, other };
      body.kind = Body::Kind::BOX;
      body.fixed = Vector3d(given, other, 0.0);
      body.per_size.z() = 1.0;
      return body;
  }
}
}  // namespace

bool Body::holds(const Vector3d& point, const Vector3d& center, double size) const
{
  Offset k, a;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto i = static_cast<int>(axis);
    k[axis] = Number(point[i]) - center[i];
    a[axis] = Number(size) * per_size[i] + fixed[i];
  }
  if (angle != 0.0)
  {
    const Number c = cos(Number(angle)), s = sin(Number(angle)), x = k[0];
    k[0] = c * x + s * k[1];
    k[1] = c * k[1] - s * x;
  }
  switch (kind)
  {
    case Kind::BOX:
      return isWithin(k[0], a[0]) && isWithin(k[1], a[1]) && isWithinHeight(k[2], a[2], stands);
    case Kind::ROUND:
      return k[0] * k[0] + k[1] * k[1] <= a[0] * a[0] && isWithinHeight(k[2], a[2], stands);
    case Kind::BALL:
      return k[0] * k[0] + k[1] * k[1] + k[2] * k[2] <= a[0] * a[0];
    case Kind::OCTAHEDRON:
      return shareOf(abs(k[0]), a[0]) + shareOf(abs(k[1]), a[1]) + shareOf(abs(k[2]), a[2]) <= 1;
    case Kind::CORNER:
      return k[0] >= 0 && k[1] >= 0 && k[2] >= 0 && k[0] / a[0] + k[1] / a[1] + k[2] / a[2] <= 1;
  }
  return false;
}

Vector3d Body::place(const Vector3d& u, const Vector3d& center, double size) const
{
  const Vector3d a = fixed + size * per_size;
  const double upright = stands ? 0.5 * (u.z() + 1.0) : 0.5 * u.z();
  Vector3d k;
  switch (kind)
  {
    case Kind::BOX:
      k = { 0.5 * u.x() * a.x(), 0.5 * u.y() * a.y(), upright * a.z() };
      break;
    case Kind::ROUND:
    {
      const double share = a.x() / std::max(1.0, std::hypot(u.x(), u.y()));
      k = { share * u.x(), share * u.y(), upright * a.z() };
      break;
    }
    case Kind::BALL:
      k = a.x() / std::max(1.0, u.norm()) * u;
      break;
    case Kind::OCTAHEDRON:
      k = a.cwiseProduct(u) / std::max(1.0, u.lpNorm<1>());
      break;
    case Kind::CORNER:
    {
      const Vector3d v = 0.5 * (u + Vector3d::Ones());
      k = a.cwiseProduct(v) / std::max(1.0, v.sum());
      break;
    }
  }
  return center + (angle == 0.0 ? k : turned(k, angle));
}

std::optional<Vector3d> Body::pointAt(const Vector3d& u, const Vector3d& center, double size) const
{
  for (const double inward : { 0.0, 1e-15, 1e-13, 1e-11, 1e-9 })
  {
    const Vector3d middle = kind == Kind::CORNER ? Vector3d::Constant(-0.7) : Vector3d::Zero();
    const Vector3d point = place((1.0 - inward) * u + inward * middle, center, size);
    if (holds(point, center, size))
      return point;
  }
  return std::nullopt;
}

Body drawnBody(Random& random, double scale)
{
  const auto side = [&] { return random.once(6) ? 0.0 : random.uniform(0.2, 2.0); };
  using Kind = Body::Kind;
  switch (random.integer(0, 9))
  {
    case 0:
      return scaling({ "square" }, Kind::BOX, { 1.0, 1.0, 0.0 });
    case 1:
    {
      const Vector3d sides(random.uniform(0.2, 2.0), side(), side());
      return scaling({ "box", sides }, Kind::BOX, sides);
    }
    case 2:
      return scaling({ "sphere" }, Kind::BALL, Vector3d::UnitX());
    case 3:
      return scaling({ "disc" }, Kind::ROUND, Vector3d::UnitX());
    case 4:
    {
      const double ratio = random.uniform(0.2, 2.0);
      return scaling({ "cylinder", {}, RatioRange{ ratio, ratio } }, Kind::ROUND, { ratio, 0.0, 1.0 });
    }
    case 5:
    case 6:
      return drawnWithMeasures(random, scale);
    case 7:
      return drawnHull(random, random.once(2));
    default:
      return scaling({ "cube" }, Kind::BOX, Vector3d::Ones());
  }
}
}  // namespace test
}  // namespace pkm_workspace
