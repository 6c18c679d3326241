// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pkm_workspace/interval/box.h"

namespace pkm_workspace
{
/// The vertices and cubes of a lattice, by their numbers along each axis.
using LatticePoint = std::array<int, 3>;

/// Cubes that cover a box and one row more on each side. Each is cut into the six tetrahedra of its diagonal (Kuhn), so
/// that neighbours share faces; all edges go from a vertex to one that is no lower along any axis.
class Lattice
{
public:
  using Id = std::uint32_t;
  /// A vertex and, by its bits, the axes along which the edge goes on.
  using Edge = std::uint64_t;

  /// Cubes of that edge, which reach beyond the box.
  Lattice(const Box& box, double step)
    : origin_(box.lower - Eigen::Vector3d::Constant(step)), steps_(Eigen::Vector3d::Constant(step))
  {
    for (int k = 0; k < 3; ++k)
      cubes_[static_cast<std::size_t>(k)] = 2 + static_cast<int>(std::ceil(box.width(k) / step));
  }
  /// Edges of at most that length and, but for a box that is shorter, half of it at least, so that vertices lie in all
  /// faces of the box; and within it, if it is no shorter.
  static Lattice fitted(const Box& box, double step)
  {
    Lattice lattice(box, step);
    for (int k = 0; k < 3; ++k)
    {
      const double steps = std::max(std::ceil(box.width(k) / step), box.width(k) < step ? 1.0 : 2.0);
      lattice.steps_[k] = box.width(k) / steps;
      lattice.cubes_[static_cast<std::size_t>(k)] = 2 + static_cast<int>(steps);
    }
    lattice.origin_ = box.lower - lattice.steps_;
    return lattice;
  }

  /// The longest edge along an axis.
  double step() const { return steps_.maxCoeff(); }
  const LatticePoint& cubes() const { return cubes_; }
  std::size_t vertices() const
  {
    return std::size_t(1) * static_cast<std::size_t>(cubes_[0] + 1) * static_cast<std::size_t>(cubes_[1] + 1) *
           static_cast<std::size_t>(cubes_[2] + 1);
  }

  /// Of a vertex; a cube has that of its lowest one.
  Id id(const LatticePoint& at) const
  {
    return static_cast<Id>((at[2] * (cubes_[1] + 1) + at[1]) * (cubes_[0] + 1) + at[0]);
  }
  LatticePoint place(Id id) const
  {
    const int row = static_cast<int>(id) / (cubes_[0] + 1);
    return { static_cast<int>(id) % (cubes_[0] + 1), row % (cubes_[1] + 1), row / (cubes_[1] + 1) };
  }
  Eigen::Vector3d point(const LatticePoint& at) const
  {
    return origin_ + steps_.cwiseProduct(Eigen::Vector3d(at[0], at[1], at[2]));
  }
  Eigen::Vector3d point(Id id) const { return point(place(id)); }
  /// The cube that a point lies in, or is nearest to.
  Id cubeOf(const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d at = (point - origin_).cwiseQuotient(steps_);
    LatticePoint place;
    for (std::size_t k = 0; k < 3; ++k)
      place[k] = std::clamp(static_cast<int>(std::floor(at[static_cast<int>(k)])), 0, cubes_[k] - 1);
    return id(place);
  }
  /// The vertex of a cube, or end of an edge, by the axes along which it is beyond the lowest one.
  Id beyond(Id id, unsigned axes) const
  {
    const LatticePoint at = place(id);
    return this->id({ at[0] + int(axes & 1U), at[1] + int(axes >> 1 & 1U), at[2] + int(axes >> 2 & 1U) });
  }
  bool isCube(const LatticePoint& at) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (at[k] < 0 || at[k] >= cubes_[k])
        return false;
    return true;
  }
  Box box(const LatticePoint& from, const LatticePoint& to) const { return { point(from), point(to) }; }

  /// The edge between two vertices of a cube, of which one is no lower along any axis.
  Edge edge(Id a, Id b) const
  {
    const Id low = std::min(a, b);
    const LatticePoint from = place(low), to = place(std::max(a, b));
    unsigned axes = 0;
    for (std::size_t k = 0; k < 3; ++k)
      axes |= from[k] != to[k] ? 1U << k : 0U;
    return Edge(low) * 8 + axes;
  }
  std::array<Id, 2> ends(Edge edge) const
  {
    const Id low = static_cast<Id>(edge / 8);
    return { low, beyond(low, static_cast<unsigned>(edge % 8)) };
  }

  /// Calls @p take with the vertices of each tetrahedron of a cube, positively oriented.
  template <class Take>
  void eachTetrahedron(Id cube, const Take& take) const
  {
    constexpr unsigned ORDERS[6][3] = { { 1, 2, 4 }, { 2, 4, 1 }, { 4, 1, 2 }, { 1, 4, 2 }, { 4, 2, 1 }, { 2, 1, 4 } };
    for (int k = 0; k < 6; ++k)
    {
      const unsigned first = ORDERS[k][0], second = first + ORDERS[k][1];
      const bool is_even = k < 3;
      take(std::array<Id, 4>{ cube, beyond(cube, is_even ? first : second), beyond(cube, is_even ? second : first),
                              beyond(cube, 7) });
    }
  }
  /// Calls @p take with each cube that has the vertex.
  template <class Take>
  void eachCubeAround(Id vertex, const Take& take) const
  {
    const LatticePoint at = place(vertex);
    for (int x = -1; x <= 0; ++x)
      for (int y = -1; y <= 0; ++y)
        for (int z = -1; z <= 0; ++z)
          if (const LatticePoint cube{ at[0] + x, at[1] + y, at[2] + z }; isCube(cube))
            take(id(cube));
  }

private:
  Eigen::Vector3d origin_;
  Eigen::Vector3d steps_;
  LatticePoint cubes_{};
};
}  // namespace pkm_workspace
