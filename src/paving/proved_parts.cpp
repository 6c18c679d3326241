// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "proved_solid.h"

namespace pkm_workspace
{
namespace
{
/// Points at which the border is looked for along an edge.
constexpr int STEPS = 8;
/// How often a part that is not proved at once is halved.
constexpr int HALVINGS = 8;
/// Parts of one that are looked at side by side, at most.
constexpr std::size_t MOST_OPEN = 256;

/// Where a margin that is positive at 0 and negative at 1 is zero: the method of false position (Illinois).
struct Root
{
  double low = 0.0, high = 1.0;
  double at_low, at_high;

  double next() const { return std::min(high, std::max(low, low + (high - low) * at_low / (at_low - at_high))); }
  void tell(double place, double margin)
  {
    if (margin >= 0.0)
    {
      low = place;
      at_low = margin;
      at_high *= 0.5;
    }
    else
    {
      high = place;
      at_high = margin;
      at_low *= 0.5;
    }
  }
};

SmallHull hullOf(const std::array<Eigen::Vector3d, 4>& points)
{
  return { points[0], points[1], points[2], points[3], points[3], points[3] };
}

/// Appends the halves of a tetrahedron. @return the middle of its longest edge
Eigen::Vector3d halve(const SmallHull& tetrahedron, std::vector<SmallHull>& halves)
{
  std::size_t from = 0, to = 1;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b)
      if ((tetrahedron[a] - tetrahedron[b]).squaredNorm() > (tetrahedron[from] - tetrahedron[to]).squaredNorm())
      {
        from = a;
        to = b;
      }
  const Eigen::Vector3d middle = 0.5 * (tetrahedron[from] + tetrahedron[to]);
  for (const std::size_t end : { from, to })
  {
    std::array<Eigen::Vector3d, 4> half = { tetrahedron[0], tetrahedron[1], tetrahedron[2], tetrahedron[3] };
    half[end] = middle;
    halves.push_back(hullOf(half));
  }
  return middle;
}
}  // namespace

/// Finds where the solid ends on these edges, if it does.
void ProvedSolid::cross(std::vector<Edge> edges)
{
  sortUnique(edges);
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [this](Edge edge) {
                               crossings_.erase(edge);
                               const auto ends = lattice_.ends(edge);
                               return has(ends[0]) == has(ends[1]);
                             }),
              edges.end());
  std::vector<Vector3d> from, to;
  std::vector<double> levels, depths;
  for (const Edge edge : edges)
  {
    auto ends = lattice_.ends(edge);
    if (!has(ends[0]))
      std::swap(ends[0], ends[1]);
    from.push_back(lattice_.point(ends[0]));
    to.push_back(lattice_.point(ends[1]));
    double level = 0.0, depth = 0.0;
    for (const Id end : ends)
      if (const auto near = near_.find(end); near != near_.end())
      {
        level = std::max(level, near->second.slope * near->second.depth);
        depth = std::max(depth, near->second.depth);
      }
    levels.push_back(level);
    depths.push_back(depth / lattice_.step());
  }
  const std::vector<double> shares = sharesOf(from, to, levels);
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const double share = std::min(1.0 - LEAST_PART, std::max(LEAST_PART, std::min(shares[k], 1.0 - depths[k])));
    crossings_[edges[k]] = (from[k] + share * (to[k] - from[k])).cast<float>();
  }
}

/// How far from their first ends margins on lines fall to levels, as shares of the lines.
std::vector<double> ProvedSolid::sharesOf(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to,
                                          const std::vector<double>& levels) const
{
  std::vector<Root> roots(from.size());
  const std::vector<double> first = margins(from), last = margins(to);
  for (std::size_t k = 0; k < from.size(); ++k)
  {
    roots[k].at_low = first[k] - levels[k];
    roots[k].at_high = last[k] - levels[k];
    // in, or out, for another reason
    if (!(roots[k].at_low > 0.0))
      roots[k].high = 0.0;
    else if (!(roots[k].at_high < 0.0))
      roots[k].low = 1.0;
  }
  std::vector<Vector3d> points(from.size());
  for (int step = 0; step < STEPS; ++step)
  {
    for (std::size_t k = 0; k < from.size(); ++k)
      points[k] = from[k] + roots[k].next() * (to[k] - from[k]);
    const std::vector<double> found = margins(points);
    for (std::size_t k = 0; k < from.size(); ++k)
      if (roots[k].low < roots[k].high)
        roots[k].tell(roots[k].next(), found[k] - levels[k]);
  }
  std::vector<double> shares;
  for (const Root& root : roots)
    shares.push_back(root.low);
  return shares;
}

std::size_t ProvedSolid::part(const std::array<Id, 4>& tetrahedron, SmallHull& corners) const
{
  corners.fill(lattice_.point(tetrahedron[0]));
  std::size_t count = 0;
  for (const Id vertex : tetrahedron)
    if (has(vertex))
      corners[count++] = lattice_.point(vertex);
  if (count == 0)
    return 0;
  for (const Id a : tetrahedron)
    for (const Id b : tetrahedron)
      if (has(a) && !has(b))
        corners[count++] = crossing(lattice_.edge(a, b)).cast<double>();
  std::fill(corners.begin() + static_cast<std::ptrdiff_t>(count), corners.end(), corners[count - 1]);
  return count;
}

/// @return of parts that are not proved the vertex in the solid that is nearest to the border, and those out of it
std::vector<ProvedSolid::Id> ProvedSolid::failing(const std::vector<Id>& cubes) const
{
  std::vector<std::array<Id, 4>> tetrahedra;
  for (const Id cube : cubes)
  {
    std::size_t in = 0;
    for (unsigned axes = 0; axes < 8; ++axes)
      in += has(lattice_.beyond(cube, axes)) ? 1 : 0;
    if (in > 0 && !(in == 8 && sealed_[cube] != 0))
      lattice_.eachTetrahedron(cube, [&](const std::array<Id, 4>& each) { tetrahedra.push_back(each); });
  }
  std::vector<std::uint8_t> proved(tetrahedra.size());
  inChunks(pool_, tetrahedra.size(), [&](std::size_t first, std::size_t last) {
    std::vector<SmallHull> hulls(last - first);
    std::array<std::size_t, TOGETHER> corners;
    std::array<BoxVerdict, TOGETHER> verdicts;
    if (budget_.isOver())
      return;
    for (std::size_t k = first; k < last; ++k)
      corners[k - first] = part(tetrahedra[k], hulls[k - first]);
    test_.kernel().classify(hulls.data(), last - first, verdicts.data());
    for (std::size_t k = 0; k < last - first; ++k)
      proved[first + k] = corners[k] == 0 || verdict(hulls[k], verdicts[k]) == side_ || isProved(hulls[k], corners[k]);
  });
  std::vector<Id> vertices;
  const auto distance = [this](Id vertex) {
    const auto near = near_.find(vertex);
    return near == near_.end() ? INF : near->second.margin / near->second.slope;
  };
  for (std::size_t k = 0; k < tetrahedra.size(); ++k)
  {
    std::array<Id, 4>& each = tetrahedra[k];
    if (proved[k] != 0)
      continue;
    const auto out = std::partition(each.begin(), each.end(), [this](Id vertex) { return has(vertex); });
    vertices.push_back(*std::min_element(each.begin(), out, [&](Id a, Id b) { return distance(a) < distance(b); }));
    vertices.insert(vertices.end(), out, each.end());
  }
  sortUnique(vertices);
  return vertices;
}

/// Of the part of the criterion's set that is in the box.
BoxVerdict ProvedSolid::verdict(const SmallHull& hull, BoxVerdict by_the_criterion) const
{
  bool is_within = true, is_beyond = false;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : { -1.0, 1.0 })
    {
      const double face = side * (side < 0.0 ? box_.lower : box_.upper)[axis];
      const double over = face + 16.0 * rounding::roundoff<double>() * std::abs(face);  // as the criterion's verdicts
      const auto isOver = [&](const Vector3d& corner) { return side * corner[axis] > over; };
      const auto isOut = [&](const Vector3d& corner) { return side * corner[axis] > face; };
      is_within = is_within && std::none_of(hull.begin(), hull.end(), isOut);
      is_beyond = is_beyond || std::all_of(hull.begin(), hull.end(), isOver);
    }
  if (is_beyond)
    return BoxVerdict::OUTSIDE;
  return by_the_criterion == BoxVerdict::INSIDE && !is_within ? BoxVerdict::UNDECIDED : by_the_criterion;
}

/// By tetrahedra with the first corner: a line from there through a point of the hull leaves it in a triangle of
/// others. Those that are not proved are halved.
bool ProvedSolid::isProved(const SmallHull& hull, std::size_t corners) const
{
  std::vector<SmallHull> open;
  for (std::size_t a = 1; a < corners; ++a)
    for (std::size_t b = a + 1; b < corners; ++b)
      for (std::size_t c = b + 1; c < corners; ++c)
        open.push_back(hullOf({ hull[0], hull[a], hull[b], hull[c] }));
  for (int halving = 0; halving < HALVINGS && open.size() < MOST_OPEN; ++halving)
  {
    std::vector<BoxVerdict> verdicts(open.size());
    test_.kernel().classify(open.data(), open.size(), verdicts.data());
    std::vector<SmallHull> halves;
    std::vector<Vector3d> middles;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      const BoxVerdict found = verdict(open[k], verdicts[k]);
      if (found == side_)
        continue;
      if (found != BoxVerdict::UNDECIDED)
        return false;
      middles.push_back(halve(open[k], halves));
    }
    if (halves.empty())
      return true;
    std::vector<double> margins(middles.size());
    marginsAt(middles.data(), middles.size(), margins.data());
    if (*std::min_element(margins.begin(), margins.end()) < 0.0)
      return false;
    open = std::move(halves);
  }
  return false;
}

void ProvedSolid::retreat(const std::vector<Id>& vertices)
{
  for (const Id vertex : vertices)
    admit(vertex).depth *= 2.0;
  place(vertices);
}

Mesh ProvedSolid::surface() const
{
  Mesh mesh;
  std::unordered_map<Edge, std::uint32_t> numbers;
  const auto number = [&](Id a, Id b) {
    const Edge edge = lattice_.edge(a, b);
    const auto [place, is_new] = numbers.emplace(edge, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.push_back(crossing(edge));
    return place->second;
  };
  for (const Id cube : border_)
    lattice_.eachTetrahedron(cube, [&](std::array<Id, 4> v) {
      // those in the solid first; two swaps keep the orientation
      int swaps = 0;
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t n = 0; n < 3; ++n)
          if (!has(v[n]) && has(v[n + 1]))
          {
            std::swap(v[n], v[n + 1]);
            ++swaps;
          }
      const std::ptrdiff_t in = std::count_if(v.begin(), v.end(), [this](Id id) { return has(id); });
      if (swaps % 2 == 1)
        in == 3 ? std::swap(v[0], v[1]) : std::swap(v[2], v[3]);
      const auto& [a, b, c, d] = v;
      if (in == 1)
        mesh.triangles.push_back({ number(a, b), number(a, c), number(a, d) });
      if (in == 2)
      {
        mesh.triangles.push_back({ number(a, c), number(a, d), number(b, d) });
        mesh.triangles.push_back({ number(a, c), number(b, d), number(b, c) });
      }
      if (in == 3)
        mesh.triangles.push_back({ number(a, d), number(b, d), number(c, d) });
    });
  return mesh;
}
}  // namespace pkm_workspace
