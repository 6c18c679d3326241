// SPDX-License-Identifier: BSD-3-Clause
#include "proved_solid.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// In edges of cubes: how far within the border the solid ends at first, and at most.
constexpr double FIRST_DEPTH = 1.0 / 256.0;
constexpr double LAST_DEPTH = 0.5;
/// In edges of cubes: how far apart the points are that tell how fast the margin changes.
constexpr double PROBE = 0.125;
}  // namespace

ProvedSolid::ProvedSolid(const BoxTest& test, const Box& box, const Lattice& lattice, BoxVerdict side, ThreadPool& pool,
                         const RunningBudget& budget)
  : test_(test)
  , box_(box)
  , lattice_(lattice)
  , side_(side)
  , pool_(pool)
  , budget_(budget)
  , in_(lattice.vertices(), 0)
  , sealed_(lattice.vertices(), 0)
  , listed_(lattice.vertices(), 0)
{}

bool ProvedSolid::prove(const Tell& tell)
{
  sort();
  lookAround();
  std::vector<Id> cubes = border_;
  while (!cubes.empty() && !budget_.isOver())
  {
    if (tell)
      tell({ side_ == BoxVerdict::OUTSIDE, border_.size(), cubes.size() });
    const std::vector<Id> bad = failing(cubes);
    if (budget_.isOver())
      break;
    retreat(bad);
    cubes.clear();
    for (const Id vertex : bad)
      lattice_.eachCubeAround(vertex, [&cubes](Id cube) { cubes.push_back(cube); });
    sortUnique(cubes);
  }
  return cubes.empty() && !budget_.isOver();
}

/// Finds the cubes that are known as a whole, many at a time where that goes.
void ProvedSolid::sort()
{
  std::vector<Block> blocks = { { { 0, 0, 0 }, lattice_.cubes() } };
  while (!blocks.empty() && !budget_.isOver())
  {
    const std::vector<BoxVerdict> verdicts = lookAt(blocks);
    std::vector<Block> next;
    for (std::size_t k = 0; k < blocks.size(); ++k)
    {
      const Block& block = blocks[k];
      std::size_t longest = 0;
      for (std::size_t axis = 1; axis < 3; ++axis)
        if (block.to[axis] - block.from[axis] > block.to[longest] - block.from[longest])
          longest = axis;
      const int length = block.to[longest] - block.from[longest];
      if (verdicts[k] != BoxVerdict::UNDECIDED || length == 1)
      {
        settle(block, verdicts[k]);
        continue;
      }
      next.insert(next.end(), 2, block);
      next[next.size() - 2].to[longest] = next.back().from[longest] = block.from[longest] + length / 2;
    }
    blocks = std::move(next);
  }
}

std::vector<BoxVerdict> ProvedSolid::lookAt(const std::vector<Block>& blocks) const
{
  std::vector<BoxVerdict> verdicts(blocks.size());
  inChunks(pool_, blocks.size(), [&](std::size_t first, std::size_t last) {
    std::array<Box, TOGETHER> boxes;
    for (std::size_t k = first; k < last; ++k)
      boxes[k - first] = lattice_.box(blocks[k].from, blocks[k].to);
    std::array<Box, TOGETHER> asked = boxes;
    for (std::size_t k = 0; k < last - first; ++k)
      if (const Box within = intersection(boxes[k], box_); within.isValid())
        asked[k] = within;
    test_.kernel().classify(asked.data(), last - first, &verdicts[first]);
    for (std::size_t k = first; k < last; ++k)
    {
      const Box& box = boxes[k - first];
      if (!intersection(box, box_).isValid())
        verdicts[k] = BoxVerdict::OUTSIDE;
      else if (verdicts[k] == BoxVerdict::INSIDE && !(box_.contains(box.lower) && box_.contains(box.upper)))
        verdicts[k] = BoxVerdict::UNDECIDED;
    }
  });
  return verdicts;
}

void ProvedSolid::settle(const Block& block, BoxVerdict verdict)
{
  if (verdict == BoxVerdict::UNDECIDED)
  {
    undecided_.push_back(lattice_.id(block.from));
    return;
  }
  if (verdict != side_)
    return;
  for (int z = block.from[2]; z <= block.to[2]; ++z)
    for (int y = block.from[1]; y <= block.to[1]; ++y)
      for (int x = block.from[0]; x <= block.to[0]; ++x)
      {
        const Id id = lattice_.id({ x, y, z });
        in_[id] = 1;
        if (x < block.to[0] && y < block.to[1] && z < block.to[2])
          sealed_[id] = 1;
      }
}

/// Of the set within the box, with the sign of the side that is to be proved. @param margin of the criterion
double ProvedSolid::marginAt(const Vector3d& point, double margin) const
{
  const double within = std::min((point - box_.lower).minCoeff(), (box_.upper - point).minCoeff());
  const double both = std::min(margin, within / box_.maxWidth());
  return side_ == BoxVerdict::INSIDE ? both : -both;
}

std::vector<double> ProvedSolid::margins(const std::vector<Vector3d>& points) const
{
  std::vector<double> found(points.size());
  inChunks(pool_, points.size(), [&](std::size_t first, std::size_t last) {
    if (!budget_.isOver())  // otherwise nothing comes of them
      marginsAt(&points[first], last - first, &found[first]);
  });
  return found;
}

/// The same within a piece of work.
void ProvedSolid::marginsAt(const Vector3d* points, std::size_t count, double* found) const
{
  test_.kernel().margins(points, count, found);
  for (std::size_t k = 0; k < count; ++k)
    found[k] = marginAt(points[k], found[k]);
}

/// Margins at the vertices of border cubes, and how fast they change there.
void ProvedSolid::lookAround()
{
  std::vector<Id> vertices;
  for (const Id cube : undecided_)
    for (unsigned axes = 0; axes < 8; ++axes)
      vertices.push_back(lattice_.beyond(cube, axes));
  sortUnique(vertices);
  std::vector<Vector3d> points;
  const double probe = PROBE * lattice_.step();
  for (const Id vertex : vertices)
  {
    const Vector3d point = lattice_.point(vertex);
    points.push_back(point);
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : { -1.0, 1.0 })
        points.push_back(point + side * probe * Vector3d::Unit(axis));
  }
  const std::vector<double> found = margins(points);
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    const double* at = &found[7 * k];
    const Vector3d slope(at[2] - at[1], at[4] - at[3], at[6] - at[5]);
    admit(vertices[k]) = { at[0], std::max(slope.norm() / (2.0 * probe), 1e-12), FIRST_DEPTH * lattice_.step() };
  }
  place(vertices);
}

ProvedSolid::Near& ProvedSolid::admit(Id vertex)
{
  const auto [place, is_new] = near_.emplace(vertex, Near{ INF, 1.0, FIRST_DEPTH * lattice_.step() });
  if (is_new)
    lattice_.eachCubeAround(vertex, [this](Id cube) {
      if (listed_[cube] == 0)
        border_.push_back(cube);
      listed_[cube] = 1;
    });
  return place->second;
}

/// Says which vertices are in, and where the solid ends on their edges.
void ProvedSolid::place(const std::vector<Id>& vertices)
{
  const double last = LAST_DEPTH * lattice_.step();
  std::vector<Edge> edges;
  for (const Id vertex : vertices)
  {
    const Near& near = near_.at(vertex);
    const double least = near.slope * (near.depth + LEAST_PART * lattice_.step());
    in_[vertex] = near.depth <= last && near.margin > least ? 1 : 0;
    lattice_.eachCubeAround(vertex, [&](Id cube) {
      lattice_.eachTetrahedron(cube, [&](const std::array<Id, 4>& tetrahedron) {
        if (std::find(tetrahedron.begin(), tetrahedron.end(), vertex) != tetrahedron.end())
          for (const Id other : tetrahedron)
            if (other != vertex)
              edges.push_back(lattice_.edge(vertex, other));
      });
    });
  }
  cross(std::move(edges));
}
}  // namespace pkm_workspace
