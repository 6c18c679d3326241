// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "chunks.h"
#include "lattice.h"
#include "pkm_workspace/paving/set_mesh.h"

namespace pkm_workspace
{
/// The least part of an edge that belongs to the solid, or does not.
constexpr double LEAST_PART = 1.0 / 64.0;
template <class T>
void sortUnique(std::vector<T>& all)
{
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

/// A union of convex parts of a lattice's tetrahedra, each of which is proved to lie in the set, or out of it. Starts a
/// little within the border as floating point has it; where a proof fails, the border moves in, and at last the vertex
/// that the part is about goes out.
class ProvedSolid
{
public:
  using Id = Lattice::Id;
  using Edge = Lattice::Edge;
  using Vector3d = Eigen::Vector3d;

  /// @param side INSIDE or OUTSIDE: what is to be proved of the points. All four have to outlive this object.
  ProvedSolid(const BoxTest& test, const Box& box, const Lattice& lattice, BoxVerdict side, ThreadPool& pool,
              const RunningBudget& budget);

  using Tell = std::function<void(const MeshProgress&)>;
  /// @param tell called now and then, if given @return whether the budget sufficed
  bool prove(const Tell& tell);

  const Lattice& lattice() const { return lattice_; }
  bool has(Id vertex) const { return in_[vertex] != 0; }
  /// Where the solid ends on an edge with one end in it, as files have it.
  Eigen::Vector3f crossing(Edge edge) const { return crossings_.at(edge); }
  /// Cubes in which it may end; in all others all vertices are in, or none.
  const std::vector<Id>& borderCubes() const { return border_; }
  /// The convex part of a tetrahedron that belongs to it, by its corners. @return how many corners
  std::size_t part(const std::array<Id, 4>& tetrahedron, SmallHull& corners) const;
  /// The surface; seen from outside the solid its triangles turn to the left.
  Mesh surface() const;

private:
  struct Block
  {
    LatticePoint from, to;
  };
  struct Near
  {
    double margin = 0.0;  ///< positive on the side that is proved
    double slope = 1.0;   ///< how fast it changes [1/m]
    double depth = 0.0;   ///< how far within the border the solid ends [m]
  };

  void sort();
  std::vector<BoxVerdict> lookAt(const std::vector<Block>& blocks) const;
  void settle(const Block& block, BoxVerdict verdict);
  double marginAt(const Vector3d& point, double margin) const;
  std::vector<double> margins(const std::vector<Vector3d>& points) const;
  void marginsAt(const Vector3d* points, std::size_t count, double* found) const;
  void lookAround();
  Near& admit(Id vertex);
  void place(const std::vector<Id>& vertices);
  void cross(std::vector<Edge> edges);
  std::vector<double> sharesOf(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to,
                               const std::vector<double>& levels) const;
  std::vector<Id> failing(const std::vector<Id>& cubes) const;
  bool isProved(const SmallHull& hull, std::size_t corners) const;
  BoxVerdict verdict(const SmallHull& hull, BoxVerdict by_the_criterion) const;
  void retreat(const std::vector<Id>& vertices);

  const BoxTest& test_;
  const Box& box_;
  const Lattice& lattice_;
  const BoxVerdict side_;
  ThreadPool& pool_;
  const RunningBudget& budget_;
  std::vector<std::uint8_t> in_;       ///< of each vertex
  std::vector<std::uint8_t> sealed_;   ///< of each cube: proved as a whole
  std::vector<std::uint8_t> listed_;   ///< of each cube: it is in border_
  std::vector<Id> undecided_;          ///< cubes that are not known as a whole
  std::unordered_map<Id, Near> near_;  ///< their vertices, and where proofs failed others
  std::vector<Id> border_;             ///< cubes around these
  std::unordered_map<Edge, Eigen::Vector3f> crossings_;
};
}  // namespace pkm_workspace
