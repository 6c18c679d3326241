// SPDX-License-Identifier: BSD-3-Clause
// Machines that do not change along their rails: areas in place of volumes.
#include <gtest/gtest.h>

#include "paving/pavings.h"

namespace pkm_workspace
{
namespace
{
PavingQuery wanted(double resolution, Criterion::Set set = Criterion::Set::DEXTROUS)
{
  PavingQuery wanted = test::query(resolution, set);
  wanted.box.reset();
  return wanted;
}
}  // namespace

TEST(PavingPlane, isTheOneThroughTheZeroConfiguration)
{
  const Paving paving = pave(uranesx(), wanted(0.01));
  EXPECT_EQ(paving.tree.bisection().dimension(), 2);
  EXPECT_EQ(paving.box.lower.z(), uranesx().zero().z());
  EXPECT_EQ(paving.box.upper.z(), uranesx().zero().z());
  EXPECT_TRUE(paving.complete);
  EXPECT_GT(paving.volumeLower(), 0.0);
}

// Three circles of radius L around the corners of an equilateral triangle at distance d = R - r from its middle meet in
// a Reuleaux-like triangle: with a its corner's angle seen from a circle's middle, the area follows from the chord.
TEST(PavingPlane, reachableAreaIsThatOfThreeCircles)
{
  const double d = 0.4, root3 = std::sqrt(3.0);
  PavingQuery query = wanted(0.002, Criterion::Set::REACHABLE);
  query.criterion.aspect = Criterion::Aspect::BOTH;
  const Paving paving = pave(uranesx(Interval(0.5), Interval(0.1)), query);
  // A corner is at distance t from the middle, opposite to one circle's: the other two circles have it at distance 1.
  const double t = (-d + std::sqrt(4.0 - 3.0 * d * d)) / 2.0;
  const double chord = root3 * t;
  const double angle = 2.0 * std::asin(chord / 2.0);
  const double area = root3 / 4.0 * chord * chord + 3.0 * 0.5 * (angle - std::sin(angle));
  EXPECT_LE(paving.volumeLower(), area);
  EXPECT_GE(paving.volumeUpper(), area);
  EXPECT_LT(paving.volumeUpper() - paving.volumeLower(), 0.02 * area);
}

// A prism on the plane's set has the area times its height for a volume.
TEST(PavingPlane, agreesWithAPrism)
{
  const Paving area = pave(uranesx(), wanted(0.02));
  PavingQuery prism = wanted(0.02);
  prism.box = area.box;
  prism.box->upper.z() += 0.5;
  const Paving volume = pave(uranesx(), prism);
  EXPECT_EQ(volume.tree.bisection().dimension(), 3);
  EXPECT_LE(volume.volumeLower(), 0.5 * area.volumeUpper());
  EXPECT_GE(volume.volumeUpper(), 0.5 * area.volumeLower());
}

TEST(PavingPlane, jointLimitsMakeItASolid)
{
  PavingQuery query = wanted(0.1);
  query.criterion.joint_limits = true;
  const Paving solid = pave(test::limited(uranesx()), query);
  EXPECT_EQ(solid.tree.bisection().dimension(), 3);
  ASSERT_FALSE(uranesx().hasJointLimits());
  EXPECT_EQ(pave(uranesx(), query).tree.bisection().dimension(), 2);
}

TEST(PavingPlane, holdsTheWholeSet)
{
  PavingQuery wider = wanted(0.01);
  const Paving own = pave(uranesx(), wider);
  const double z = uranesx().zero().z();
  wider.box = Box{ { -1.5, -1.5, z }, { 1.5, 1.5, z } };
  const Paving all = pave(uranesx(), wider);
  EXPECT_LE(all.volumeLower(), own.volumeUpper());
  EXPECT_GE(all.volumeUpper(), own.volumeLower());
  for (const std::vector<Box>& level : all.tree.boxes(CellState::INSIDE))
    for (const Box& box : level)
      EXPECT_TRUE(own.box.contains(box.lower) && own.box.contains(box.upper));
}
}  // namespace pkm_workspace
