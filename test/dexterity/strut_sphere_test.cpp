// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/strut_sphere.h"

#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Number = test::Oracle::Number;
using Vector = test::Oracle::Vector;

constexpr unsigned SEED = 20261126;

/// The unit Orthoglide with the signs of eta of the bits of @p modes.
Machine withModes(int modes)
{
  Machine::Legs legs = orthoglide().legs();
  for (int i = 0; i < 3; ++i)
    if (modes >> i & 1)
    {
      legs[static_cast<std::size_t>(i)].working_mode = -1;
      legs[static_cast<std::size_t>(i)].origin = -1.0 * legs[static_cast<std::size_t>(i)].origin;
    }
  return Machine("modes", legs, Vector3d::Zero());
}

/// The point of the sphere in a direction, to 100 digits.
Vector pointOn(const StrutSphere& sphere, const Vector3d& direction)
{
  Vector point = { direction.x(), direction.y(), direction.z() };
  const Number length = sqrt(point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = sphere.center()[static_cast<int>(k)] + sphere.radius() * point[k] / length;
  return point;
}

Criterion reachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  return criterion;
}
}  // namespace

// By the definition: in the cone of a sphere det A is 0 on it, whatever the working modes; in other directions it is
// not.
TEST(StrutSphere, theDeterminantIsZeroOnItInTheCone)
{
  test::RandomBoxes random(SEED);
  for (int modes = 0; modes < 8; ++modes)
  {
    const Machine machine = withModes(modes);
    const test::Oracle oracle(machine, reachable());
    const auto spheres = strutSpheres(machine);
    ASSERT_EQ(spheres.size(), 3u);
    for (int k = 0; k < test::cases(200); ++k)
    {
      const Vector3d direction = random.pointIn({ -Vector3d::Ones(), Vector3d::Ones() });
      bool in_cone = false;
      for (const StrutSphere& sphere : spheres)
        in_cone = in_cone || sphere.hasInCone(CenteredBox<double>(Box{ direction, direction }));
      int towards = 0;
      for (int i = 0; i < 3; ++i)
        towards += (modes >> i & 1 ? -direction[i] : direction[i]) >= 0.0;
      EXPECT_EQ(in_cone, towards >= 2) << "seed " << SEED << ", modes " << modes << ", " << direction.transpose();
      const Number det = oracle.determinant(pointOn(spheres[0], direction));
      EXPECT_EQ(abs(det) < 1e-80, in_cone) << "seed " << SEED << ", modes " << modes << ", " << direction.transpose();
    }
  }
}

// Why it takes a rule of its own: within all three cones det A is positive on both sides.
TEST(StrutSphere, theSignDoesNotChangeWhereThreeLinesMeet)
{
  const test::Oracle oracle(orthoglide(), reachable());
  for (const double length : { 0.4, 0.57, 0.58, 0.7 })
    EXPECT_TRUE(oracle.isGood(Vector3d::Constant(length))) << length;
}

TEST(StrutSphere, excessTellsTheSides)
{
  const StrutSphere sphere = strutSpheres(orthoglide(2.0)).front();
  EXPECT_EQ(sphere.center(), Vector3d::Zero());
  EXPECT_EQ(sphere.radius(), 2.0);
  for (const double half_width : { 0.0, 0.01 })
  {
    const auto around = [&](double x) {
      const Vector3d point(x, 0.3, 0.4);
      return CenteredBox<double>(Box{ point - Vector3d::Constant(half_width), point + Vector3d::Constant(half_width) });
    };
    EXPECT_LT(sphere.excess(around(1.9)).upper(), 0.0);
    EXPECT_GT(sphere.excess(around(2.0)).lower(), 0.0);
  }
}

TEST(StrutSphere, machinesThatOnlyNearlyHaveOneHaveNone)
{
  Machine::Legs longer = orthoglide().legs();
  longer[0].length = 1.0 + 0x1p-52;
  Machine::Legs aside = orthoglide().legs();
  aside[0].platform = enclose(Vector3d(0.0, 0x1p-60, 0x1p-60));
  for (const auto& legs : { longer, aside })
    EXPECT_EQ(strutSpheres(Machine("nearly", legs, Vector3d::Zero())).size(), 1u) << "of the other two legs";
  Machine::Legs uncertain = orthoglide().legs();
  for (Leg& leg : uncertain)
    leg.length = Interval(1.0, 1.0 + 0x1p-52);
  EXPECT_TRUE(strutSpheres(Machine("uncertain", uncertain, Vector3d::Zero())).empty());
  EXPECT_TRUE(strutSpheres(uranesx()).empty());
  EXPECT_TRUE(strutSpheres(test::crooked(1)).empty());
}

TEST(StrutSphere, onlyTheSignOfTheDeterminantMakesItBad)
{
  Criterion both = reachable();
  both.aspect = Criterion::Aspect::BOTH;
  Criterion other = reachable();
  other.aspect = Criterion::Aspect::OTHER;
  EXPECT_TRUE(BoxTest(orthoglide(), both).spheres().empty());
  EXPECT_EQ(BoxTest(orthoglide(), reachable()).spheres().size(), 3u);
  EXPECT_EQ(BoxTest(orthoglide(), other).spheres().size(), 3u);
  EXPECT_TRUE(BoxTest(orthoglide(), Criterion()).spheres().empty()) << "psi_min keeps away from it";
}
}  // namespace pkm_workspace
