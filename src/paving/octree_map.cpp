// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/octree_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "chunks.h"
#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
/// A corner, in halves of voxels from the origin.
using HalfSteps = std::array<std::int32_t, 3>;

/// The library's tree is that deep: 2^16 voxels along each axis, as many below the origin as above.
constexpr int DEPTH = 16;
constexpr std::int32_t MOST_HALF_STEPS = 1 << DEPTH;
/// What is mapped ends at multiples of so many voxels, where eight are alike and take less room.
constexpr std::int32_t ALIGNED = 8;
/// More than all roundings with which the library finds the voxel of a point, relative.
constexpr double LOOSE = 0x1p-50;
/// And absolute, where they underflow [m].
constexpr double LOOSE_AT_0 = 0x1p-1000;

/// By the numbers that files have.
enum class Content : std::uint8_t
{
  UNKNOWN,
  FREE,
  OCCUPIED,
  SPLIT,  ///< its parts follow
};

struct OctreeNode
{
  Content content = Content::UNKNOWN;
  std::uint32_t children = 0;  ///< where SPLIT: the first of eight on the next level
};

/// The tree, level by level: cubes that are not decided are split, down to halves of voxels.
class OctreeBuilder
{
public:
  /// @param whole what is mapped
  OctreeBuilder(const Machine& machine, const PavingQuery& query, const Box& whole, double resolution)
    : test_(machine, query.criterion)
    , query_(query)
    , whole_(whole)
    , resolution_(resolution)
    , pool_(query.budget.threads)
    , budget_(query.budget)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto axis = static_cast<int>(k);
      const double edge = ALIGNED * resolution;
      first_[k] = 2 * ALIGNED * static_cast<std::int32_t>(std::floor((whole.lower[axis] - resolution) / edge));
      end_[k] = 2 * ALIGNED * static_cast<std::int32_t>(std::ceil((whole.upper[axis] + resolution) / edge));
    }
  }

  OctreeMap build()
  {
    OctreeMap map;
    map.resolution = resolution_;
    std::vector<HalfSteps> cubes = { { -MOST_HALF_STEPS, -MOST_HALF_STEPS, -MOST_HALF_STEPS } };
    for (int depth = 0; depth <= DEPTH + 1 && !budget_.isOver(); ++depth)
    {
      levels_.push_back(lookAt(cubes, 1 << (DEPTH + 1 - depth)));
      tell(depth);
      if (depth <= DEPTH)
        cubes = split(cubes, 1 << (DEPTH - depth));
    }
    map.complete = !budget_.isOver();
    if (map.complete)
    {
      unite();
      write(0, 0, map);
      ++map.nodes;  // the root
    }
    map.seconds = budget_.seconds();
    return map;
  }

private:
  using Level = std::vector<OctreeNode>;

  /// All points that the library may take for points of a cube.
  Box boxOf(const HalfSteps& corner, std::int32_t size) const
  {
    const Interval unit = Interval(0.5) * Interval(resolution_) * Interval(1.0 - LOOSE, 1.0 + LOOSE);
    const Interval beyond(-LOOSE_AT_0, LOOSE_AT_0);
    Box box;
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.lower[static_cast<int>(k)] = (Interval(corner[k]) * unit + beyond).lower();
      box.upper[static_cast<int>(k)] = (Interval(corner[k] + size) * unit + beyond).upper();
    }
    return box;
  }

  Content contentOf(const HalfSteps& corner, std::int32_t size, const Box& box, BoxVerdict verdict) const
  {
    bool is_within = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (corner[k] + size <= first_[k] || corner[k] >= end_[k])
        return Content::UNKNOWN;
      is_within = is_within && corner[k] >= first_[k] && corner[k] + size <= end_[k];
    }
    if (!is_within)
      return Content::SPLIT;
    if (query_.box && !intersection(box, *query_.box).isValid())
      return Content::OCCUPIED;
    const bool may_be_free = !query_.box || (query_.box->contains(box.lower) && query_.box->contains(box.upper));
    if (verdict == BoxVerdict::INSIDE && may_be_free)
      return Content::FREE;
    return verdict == BoxVerdict::OUTSIDE || size == 1 ? Content::OCCUPIED : Content::SPLIT;
  }

  Level lookAt(const std::vector<HalfSteps>& cubes, std::int32_t size)
  {
    Level level(cubes.size());
    inChunks(pool_, cubes.size(), [&](std::size_t first, std::size_t last) {
      std::array<Box, TOGETHER> boxes;
      std::array<BoxVerdict, TOGETHER> verdicts;
      if (budget_.isOver())
        return;
      for (std::size_t k = first; k < last; ++k)
        boxes[k - first] = boxOf(cubes[k], size);
      test_.kernel().classify(boxes.data(), last - first, verdicts.data());
      for (std::size_t k = first; k < last; ++k)
        level[k].content = contentOf(cubes[k], size, boxes[k - first], verdicts[k - first]);
    });
    return level;
  }

  /// Counts the level, once it is known.
  void tell(int depth)
  {
    const double edge = std::ldexp(resolution_, DEPTH - depth);
    so_far_.boxes += static_cast<std::int64_t>(levels_.back().size());
    for (const OctreeNode& node : levels_.back())
      so_far_.volume_inside += node.content == Content::FREE ? edge * edge * edge : 0.0;
    so_far_.seconds = budget_.seconds();
    if (query_.progress)
      query_.progress(so_far_);
  }

  /// @param size of the halves
  std::vector<HalfSteps> split(const std::vector<HalfSteps>& cubes, std::int32_t size)
  {
    std::vector<HalfSteps> parts;
    for (std::size_t n = 0; n < cubes.size(); ++n)
      if (OctreeNode& node = levels_.back()[n]; node.content == Content::SPLIT)
      {
        node.children = static_cast<std::uint32_t>(parts.size());
        for (int k = 0; k < 8; ++k)
          parts.push_back(
              { cubes[n][0] + (k & 1) * size, cubes[n][1] + (k >> 1 & 1) * size, cubes[n][2] + (k >> 2 & 1) * size });
      }
    return parts;
  }

  /// Makes one of eight that are alike, and voxels of their parts: free where all of them are.
  void unite()
  {
    for (int depth = DEPTH; depth >= 0; --depth)
      for (OctreeNode& node : levels_[static_cast<std::size_t>(depth)])
      {
        if (node.content != Content::SPLIT)
          continue;
        const OctreeNode* const parts = &levels_[static_cast<std::size_t>(depth) + 1][node.children];
        const bool are_alike = std::all_of(parts, parts + 8, [parts](const OctreeNode& part) {
          return part.content != Content::SPLIT && part.content == parts->content;
        });
        if (are_alike)
          node.content = parts->content;
        else if (depth == DEPTH)
          node.content = Content::OCCUPIED;
      }
    levels_.pop_back();
  }

  /// Two bits for each part, then those of its own parts where it is split.
  void write(int depth, std::uint32_t number, OctreeMap& map) const
  {
    const auto below = static_cast<std::size_t>(depth) + 1;
    const OctreeNode* const parts = &levels_[below][levels_[below - 1][number].children];
    unsigned bits = 0;
    for (unsigned k = 0; k < 8; ++k)
    {
      bits |= static_cast<unsigned>(parts[k].content) << (2 * k);
      const std::int64_t voxels = std::int64_t(1) << (3 * (DEPTH - depth - 1));
      map.free_voxels += parts[k].content == Content::FREE ? voxels : 0;
      map.occupied_voxels += parts[k].content == Content::OCCUPIED ? voxels : 0;
      map.nodes += parts[k].content == Content::UNKNOWN ? 0 : 1;
    }
    map.tree += static_cast<char>(bits & 0xffU);
    map.tree += static_cast<char>(bits >> 8);
    for (std::uint32_t k = 0; k < 8; ++k)
      if (parts[k].content == Content::SPLIT)
        write(depth + 1, levels_[below - 1][number].children + k, map);
  }

  const BoxTest test_;
  const PavingQuery& query_;
  const Box whole_;
  const double resolution_;
  ThreadPool pool_;
  const RunningBudget budget_;
  HalfSteps first_{}, end_{};  ///< of what is mapped
  std::vector<Level> levels_;
  PavingProgress so_far_;
};

void validateMap(const Box& box, double resolution)
{
  TextStream text;
  text << "resolution = " << resolution << " m must be at least 1/";
  if (!((box.upper - box.lower).array() > 0.0).all())
    throw std::invalid_argument("a map needs a box with three sides: this one is flat");
  if (box.maxWidth() > OctreeMap::MOST_STEPS * resolution)
    text << OctreeMap::MOST_STEPS << " of the longest side of the box, " << box.maxWidth() << " m, for a map";
  else if (const double far = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
           far > (MOST_HALF_STEPS / 2 - 2 * ALIGNED) * resolution)
    text << MOST_HALF_STEPS / 2 - 2 * ALIGNED << " of how far the box is from the origin, " << far << " m, for a map";
  else
    return;
  throw std::invalid_argument(text.str());
}
}  // namespace

Interval OctreeMap::freeVolume() const
{
  const Interval edge(resolution);
  return Interval(static_cast<double>(free_voxels)) * edge * edge * edge;
}

OctreeMap octreeMap(const Machine& machine, const PavingQuery& query)
{
  validated(query);
  const Box whole = query.box ? *query.box : defaultBox(machine, query.criterion);
  const double resolution = parseNumber(significantBelow(query.resolution, 6)).value_or(0.0);
  validateMap(whole, resolution);
  return OctreeBuilder(machine, query, whole, resolution).build();
}

bool isOctreeFile(const std::string& path)
{
  return hasEnding(path, ".bt");
}

void saveOctree(const std::string& path, const OctreeMap& map, std::string title)
{
  if (!isOctreeFile(path))
    throw std::invalid_argument(path + ": the name of a map's file must end in .bt");
  std::replace(title.begin(), title.end(), '\n', ' ');
  writeWholeFile(path, "# Octomap OcTree binary file\n# " + title + "\nid OcTree\nsize " + std::to_string(map.nodes) +
                           "\nres " + exact(map.resolution) + "\ndata\n" + map.tree);
}
}  // namespace pkm_workspace
