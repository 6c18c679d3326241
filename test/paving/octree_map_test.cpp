// SPDX-License-Identifier: BSD-3-Clause
// Maps for planners, read by OctoMap's own library, against the definitions.
#include "pkm_workspace/paving/octree_map.h"

#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "pkm_workspace/machine/catalogue.h"
#include "support/cases.h"
#include "support/every_criterion.h"
#include "support/expect_throw.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using test::SEED;

PavingQuery asked(const Criterion& criterion, double resolution, const std::optional<Box>& box = {})
{
  PavingQuery query;
  query.criterion = criterion;
  query.resolution = resolution;
  query.box = box;
  return query;
}

/// As a planner gets it.
class Read
{
public:
  explicit Read(const OctreeMap& map) : tree_(1.0)
  {
    const std::string path = testing::TempDir() + "octree_map_test.bt";
    saveOctree(path, map, "a\ntitle");
    EXPECT_TRUE(tree_.readBinary(path)) << path;
    std::ifstream file(path, std::ios::binary);
    std::stringstream content;
    content << file.rdbuf();
    EXPECT_NE(std::string::npos, content.str().find("# a title\n"));
    std::remove(path.c_str());
  }

  const octomap::OcTree& tree() const { return tree_; }
  bool isKnown(const Vector3d& at) const { return tree_.search(at.x(), at.y(), at.z()) != nullptr; }
  bool isFree(const Vector3d& at) const
  {
    const octomap::OcTreeNode* const node = tree_.search(at.x(), at.y(), at.z());
    return node && !tree_.isNodeOccupied(node);
  }

private:
  octomap::OcTree tree_;
};

/// A cube of voxels that are alike.
struct Leaf
{
  octomap::OcTreeKey key;
  int voxels;  ///< along an edge
};

/// A point of it, also the last one before the next cube. @return whether the library takes it for one of its points
bool pointIn(const octomap::OcTree& tree, const Leaf& leaf, test::RandomBoxes& random, Vector3d& point)
{
  const double edge = tree.getResolution();
  const auto first = [&leaf](const octomap::OcTreeKey& key, unsigned k) { return key[k] / leaf.voxels * leaf.voxels; };
  for (int k = 0; k < 3; ++k)
  {
    const int low = first(leaf.key, static_cast<unsigned>(k)) - 32768;
    const double choice = random.between(0.0, 1.0);
    point[k] = choice < 0.3   ? low * edge
               : choice < 0.6 ? std::nextafter((low + leaf.voxels) * edge, -INF)
                              : random.between(low * edge, (low + leaf.voxels) * edge);
  }
  const octomap::OcTreeKey found = tree.coordToKey(point.x(), point.y(), point.z());
  return first(found, 0) == first(leaf.key, 0) && first(found, 1) == first(leaf.key, 1) &&
         first(found, 2) == first(leaf.key, 2);
}

/// @return points of free voxels that were tried
int expectFreeIsGood(const test::MachineCase& each, const octomap::OcTree& tree, int most)
{
  const test::Oracle oracle(each.machine, each.criterion);
  test::RandomBoxes random(SEED);
  std::vector<Leaf> leaves;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
    if (!tree.isNodeOccupied(*leaf))
      leaves.push_back({ leaf.getKey(), 1 << (16 - leaf.getDepth()) });
  int tried = 0;
  for (int k = 0; k < most && !leaves.empty(); ++k)
  {
    const double share = random.between(0.0, 1.0) * static_cast<double>(leaves.size() - 1);
    const Leaf& leaf = leaves[static_cast<std::size_t>(share)];
    Vector3d point;
    if (!pointIn(tree, leaf, random, point))
      continue;
    ++tried;
    EXPECT_TRUE(oracle.isGood(point)) << each.name << ", seed " << SEED << ", " << point.transpose();
  }
  return tried;
}
}  // namespace

TEST(OctreeMap, isWhatTheLibraryReads)
{
  const test::MachineCase each{ "dextrous", orthoglide(), Criterion() };
  const OctreeMap map = octreeMap(each.machine, asked(each.criterion, 0.05));
  ASSERT_TRUE(map.complete);
  const Read read(map);
  EXPECT_EQ(map.resolution, read.tree().getResolution());
  EXPECT_EQ(static_cast<std::size_t>(map.nodes), read.tree().size());
  std::int64_t free_voxels = 0, occupied = 0;
  for (auto leaf = read.tree().begin_leafs(); leaf != read.tree().end_leafs(); ++leaf)
    (read.tree().isNodeOccupied(*leaf) ? occupied : free_voxels) += std::int64_t(1) << (3 * (16 - leaf.getDepth()));
  EXPECT_EQ(map.free_voxels, free_voxels);
  EXPECT_EQ(map.occupied_voxels, occupied);
  EXPECT_LT(map.freeVolume().upper(), 1.6317);  // docs/volumes.md
  EXPECT_GT(map.freeVolume().lower(), 0.8 * 1.6315);
  EXPECT_GT(expectFreeIsGood(each, read.tree(), test::cases(2000)), 1000);
}

// What the definitions say of points far from the border; all others may be either.
TEST(OctreeMap, everyCondition)
{
  for (const test::MachineCase& each : test::everyCondition(test::crooked(1)))
  {
    SCOPED_TRACE(each.name);
    const OctreeMap map = octreeMap(each.machine, asked(each.criterion, 0.1));
    ASSERT_TRUE(map.complete);
    const Read read(map);
    expectFreeIsGood(each, read.tree(), test::cases(100));
    const test::Oracle oracle(each.machine, each.criterion);
    test::RandomBoxes random(SEED);
    const Box box = defaultBox(each.machine, each.criterion);
    for (int k = 0; k < test::cases(50); ++k)
    {
      const Vector3d point = random.pointIn(box);
      EXPECT_TRUE(read.isKnown(point)) << point.transpose();
      EXPECT_TRUE(oracle.isGood(point) || !read.isFree(point)) << point.transpose();
    }
  }
}

// Free within the box only, occupied for one to nine voxels around it, unknown beyond.
TEST(OctreeMap, endsBeyondTheBox)
{
  const Box box{ { -0.1, -0.2, -0.15 }, { 0.21, 0.1, 0.13 } };  // all of it is good
  const double edge = 0.04;
  const OctreeMap map = octreeMap(orthoglide(), asked(Criterion(), edge, box));
  const Read read(map);
  test::RandomBoxes random(SEED);
  const Vector3d around = Vector3d::Constant(12.0 * edge);
  int found[3] = {};
  for (int k = 0; k < test::cases(20000); ++k)
  {
    const Vector3d point = random.pointIn({ box.lower - around, box.upper + around });
    const double beyond = std::max((box.lower - point).maxCoeff(), (point - box.upper).maxCoeff());
    EXPECT_TRUE(!read.isFree(point) || beyond <= 0.0) << point.transpose();
    EXPECT_TRUE(read.isFree(point) || beyond > -edge) << point.transpose();
    EXPECT_TRUE(read.isKnown(point) || beyond > edge) << point.transpose();
    EXPECT_TRUE(!read.isKnown(point) || beyond < 9.0 * edge + 1e-12) << point.transpose();
    ++found[read.isFree(point) ? 0 : read.isKnown(point) ? 1 : 2];
  }
  for (const int points : found)
    EXPECT_GT(points, 100);
}

// The library multiplies a coordinate by a rounded reciprocal: a point just below a voxel's face may count for the
// voxel above it. A box that begins at that face leaves such points out.
TEST(OctreeMap, whatTheLibraryRoundsIntoAVoxelIsAskedFor)
{
  int tried = 0;
  for (int hundredth = 300; hundredth < 900 && tried < 20; ++hundredth)
  {
    const double edge = 1e-4 * hundredth;
    const octomap::OcTree tree(edge);
    for (int voxel = 1; voxel < 8; ++voxel)
    {
      const long double exact = static_cast<long double>(voxel) * static_cast<long double>(edge);  // 56 bits at most
      double face = voxel * edge;
      face = static_cast<long double>(face) > exact ? std::nextafter(face, 0.0) : face;
      const double below = std::nextafter(face, 0.0);
      if (tree.coordToKey(below) != tree.coordToKey(face + 0.5 * edge))
        continue;
      const Box box{ { face, 0.0, 0.0 }, { face + 4.0 * edge, 0.2, 0.2 } };
      const Read read(octreeMap(orthoglide(), asked(Criterion(), edge, box)));
      if (read.tree().getResolution() != edge)
        continue;
      EXPECT_FALSE(read.isFree({ below, 0.1, 0.1 })) << voxel << " of " << edge;
      EXPECT_TRUE(read.isFree({ face + 1.5 * edge, 0.1, 0.1 }));
      ++tried;
    }
  }
  EXPECT_GT(tried, 5);
}

TEST(OctreeMap, resolutionIsWhatTheFileHolds)
{
  const Box box{ { -0.1, -0.2, -0.15 }, { 0.21, 0.1, 0.13 } };
  for (const double wanted : { 0.0123456789, 0.05, 0.0155, 0.1 / 3.0 })
  {
    const OctreeMap map = octreeMap(orthoglide(), asked(Criterion(), wanted, box));
    EXPECT_LE(map.resolution, wanted);
    EXPECT_GT(map.resolution, wanted * (1.0 - 1e-5));
    EXPECT_EQ(map.resolution, Read(map).tree().getResolution());
  }
}

TEST(OctreeMap, doesNotDependOnThreads)
{
  PavingQuery query = asked(Criterion(), 0.1);
  query.budget.threads = 1;
  const OctreeMap one = octreeMap(orthoglide(), query);
  query.budget.threads = 3;
  EXPECT_EQ(one.tree, octreeMap(orthoglide(), query).tree);
}

TEST(OctreeMap, refusesWhatIsNoMap)
{
  using test::expectThrow;
  expectThrow<std::invalid_argument>([] { octreeMap(orthoglide(), asked(Criterion(), 1e-4)); }, "1/400");
  expectThrow<std::invalid_argument>([] { octreeMap(orthoglide(), asked(Criterion(), -1.0)); }, "resolution");
  const Box flat{ { 0, 0, 0 }, { 1, 1, 0 } };
  expectThrow<std::invalid_argument>([&] { octreeMap(orthoglide(), asked(Criterion(), 0.1, flat)); }, "flat");
  const Box far{ { 1000, 0, 0 }, { 1000.1, 0.1, 0.1 } };
  expectThrow<std::invalid_argument>([&] { octreeMap(orthoglide(), asked(Criterion(), 0.01, far)); }, "origin");
  expectThrow<std::invalid_argument>([] { saveOctree("set.ot", {}, ""); }, "must end in .bt");
  std::atomic<bool> stop(true);
  PavingQuery query = asked(Criterion(), 0.1);
  query.budget.stop = &stop;
  EXPECT_FALSE(octreeMap(orthoglide(), query).complete);
}
}  // namespace pkm_workspace
