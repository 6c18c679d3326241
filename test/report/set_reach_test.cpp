// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/set_reach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr int POINTS = 20000;

/// Limits from -2 to 1.5 tenths of a strut are left aside.
const Criterion LIMITLESS;

/// Least and largest joint values at points of a box that satisfy the criterion, in floating point.
std::array<std::array<double, 2>, 3> seen(const Machine& machine, const Criterion& criterion, const Box& box)
{
  std::mt19937_64 generator(SEED);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const BoxTest test(machine, criterion);
  std::array<std::array<double, 2>, 3> seen;
  seen.fill({ 1e9, -1e9 });
  for (int k = 0; k < POINTS; ++k)
  {
    const Eigen::Vector3d share(uniform(generator), uniform(generator), uniform(generator));
    const Eigen::Vector3d point = box.lower + share.cwiseProduct(box.upper - box.lower);
    const auto rho = inverseKinematics(machine, point);
    for (int i = 0; rho && test.classify(point) == BoxVerdict::INSIDE && i < 3; ++i)
    {
      auto& [least, largest] = seen[static_cast<std::size_t>(i)];
      least = std::min(least, (*rho)[i]);
      largest = std::max(largest, (*rho)[i]);
    }
  }
  return seen;
}

/// No point that was seen goes beyond, and some come near what is said to be reached [m].
void expectRight(const JointReaches& reaches, const std::array<std::array<double, 2>, 3>& seen, double near)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_GE(seen[i][0], reaches[i].least.lower() - 1e-9);
    EXPECT_LE(seen[i][0], reaches[i].least.upper() + near);
    EXPECT_LE(seen[i][1], reaches[i].largest.upper() + 1e-9);
    EXPECT_GE(seen[i][1], reaches[i].largest.lower() - near);
  }
}
}  // namespace

TEST(SetReach, isRightAtThePointsOfTheSet)
{
  for (const Machine& kind : { orthoglide(), crooked(1), crooked(2, 1000.0), cone() })
  {
    const Machine machine = limited(kind);
    for (const Criterion::Set set : { Criterion::Set::DEXTROUS, Criterion::Set::REACHABLE })
    {
      Criterion criterion;
      criterion.set = set;
      SCOPED_TRACE(machine.name() + ", " + describe(criterion));
      const auto reaches = reachOver(machine, criterion);
      ASSERT_TRUE(reaches);
      expectRight(*reaches, seen(machine, criterion, defaultBox(machine, criterion)), 0.15 * machine.scale());
      for (const JointReach& reach : *reaches)
      {
        EXPECT_LT(reach.least.width(), 0.5 * machine.scale());
        EXPECT_LT(reach.largest.width(), 0.5 * machine.scale());
      }
    }
  }
}

TEST(SetReach, saysWhichRailsWouldLeaveTheirLimits)
{
  const Machine machine = limited(orthoglide());
  const auto reaches = reachOver(machine, LIMITLESS);
  const std::string remark = remarkOnLimits(machine, LIMITLESS, reaches);
  for (const char* phrase : { "'rail_x' would leave its lower limit, -0.2 m, by at least 0.",
                              "'rail_z' would leave its upper limit, 0.15 m, by at least 0." })
    EXPECT_NE(std::string::npos, remark.find(phrase)) << remark;
  EXPECT_EQ(6U, beyondLimits(machine, reaches).size());
}

TEST(SetReach, saysNothingWhereThereIsNothingToSay)
{
  Criterion limits;
  limits.joint_limits = true;
  EXPECT_FALSE(reachOver(limited(orthoglide()), limits));
  EXPECT_FALSE(reachOver(orthoglide(), LIMITLESS));
  const Box far{ Eigen::Vector3d::Constant(5.0), Eigen::Vector3d::Constant(6.0) };
  EXPECT_FALSE(reachOver(limited(orthoglide()), LIMITLESS, far));
  EXPECT_EQ("", remarkOnLimits(limited(orthoglide()), LIMITLESS, std::nullopt));
}

TEST(SetReach, ofASetAlongParallelRailsIsWithoutEnd)
{
  const Machine machine = limited(uranesx());
  const std::string remark = remarkOnLimits(machine, LIMITLESS, reachOver(machine, LIMITLESS));
  EXPECT_NE(std::string::npos, remark.find("'rail_1' would leave its lower limit, -0.2 m, by any length;")) << remark;
  EXPECT_NE(std::string::npos, remark.find("'rail_3' would leave its upper limit, 0.15 m, by any length.")) << remark;
  const Box part{ { -0.1, -0.1, -0.1 }, { 0.1, 0.1, 0.1 } };
  const auto reaches = reachOver(machine, LIMITLESS, part);
  ASSERT_TRUE(reaches);
  expectRight(*reaches, seen(machine, LIMITLESS, part), 0.05);
}

TEST(SetReach, ofManyBoxesIsThatOfTheBoxTheyFill)
{
  const Machine machine = limited(orthoglide());
  const Box centers{ { -0.1, 0.0, -0.05 }, { 0.1, 0.0, 0.05 } };
  const Eigen::Vector3d sides(0.3, 0.2, 0.0);
  const JointReaches all = reachOverCenters(machine, LIMITLESS, centers, sides, Share::ALL, {});
  const JointReaches filled = reachOver(machine, *makeBox({ 0.5, 0.2, 0.1 }), Eigen::Vector3d::Zero(), 1.0);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(all[i].least.intersects(filled[i].least));
    EXPECT_TRUE(all[i].largest.intersects(filled[i].largest));
    EXPECT_LT(all[i].least.width() + all[i].largest.width(), 1e-12);
  }
}

TEST(SetReach, ofSomeBoxesIsKnownFromThoseThatAreGood)
{
  const Machine machine = limited(orthoglide());
  const Eigen::Vector3d sides(0.1, 0.1, 0.1);
  const Box centers{ Eigen::Vector3d::Constant(-2.0), Eigen::Vector3d::Constant(2.0) };
  const Box known{ Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.125) };
  const JointReaches some = reachOverCenters(machine, LIMITLESS, centers, sides, Share::SOME, { known });
  const JointReaches good = reachOverCenters(machine, LIMITLESS, known, sides, Share::ALL, {});
  const JointReaches none = reachOverCenters(machine, LIMITLESS, centers, sides, Share::SOME, {});
  EXPECT_TRUE(beyondLimits(machine, none).empty());
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(some[i].least.upper(), good[i].least.upper());
    EXPECT_EQ(some[i].largest.lower(), good[i].largest.lower());
    EXPECT_LT(some[i].least.lower(), -0.5);  // points of the set that a box may have
    EXPECT_GT(some[i].largest.upper(), 0.5);
    EXPECT_EQ(some[i].least.lower(), none[i].least.lower());
  }
}

TEST(SetReach, ofARegionIsKnownWhereAllOfItCounts)
{
  const Machine machine = limited(orthoglide());
  const ShapePtr sphere = makeSphere();
  const auto near = reachOver(machine, LIMITLESS, *sphere, Eigen::Vector3d::Zero(), 0.3);
  ASSERT_TRUE(near);
  EXPECT_EQ(6U, beyondLimits(machine, near).size());
  const auto partly = reachOver(machine, LIMITLESS, *sphere, Eigen::Vector3d::Zero(), 1.0);
  EXPECT_EQ("Joint limits are off: whether all rails stay within their limits is not proved.",
            remarkOnLimits(machine, LIMITLESS, partly));
}
}  // namespace test
}  // namespace pkm_workspace
