// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/strut_sphere.h"

#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Number = test::Oracle::Number;
using Vector = test::Oracle::Vector;

using test::SEED;

/// The unit Orthoglide with the signs of eta of the bits of @p modes.
Machine withModes(int modes)
{
  Machine::Legs legs = orthoglide().legs();
  for (int i = 0; i < 3; ++i)
    if (modes >> i & 1)
    {
      slidingStrut(legs[static_cast<std::size_t>(i)]).working_mode = -1;
      slidingStrut(legs[static_cast<std::size_t>(i)]).origin =
          -1.0 * slidingStrut(legs[static_cast<std::size_t>(i)]).origin;
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

/// Rails with any directions through one point, with struts of one length.
Machine meeting(unsigned seed)
{
  Machine::Legs legs = test::crooked(seed).legs();
  for (Leg& leg : legs)
  {
    slidingStrut(leg).origin = slidingStrut(leg).platform = enclose(Vector3d::Zero());
    slidingStrut(leg).length = 1.0;
  }
  return Machine("meeting_" + std::to_string(seed), legs, Vector3d::Zero());
}

std::vector<Machine> withMeetingRails()
{
  std::vector<Machine> machines;
  for (int modes = 0; modes < 8; ++modes)
    machines.push_back(withModes(modes));
  for (unsigned seed = 1; seed <= 4; ++seed)
    machines.push_back(meeting(seed));
  return machines;
}

/// A box next to the sphere, in its cone, with a half-space whose plane is next to the sphere too.
std::pair<Box, HalfSpace> nextToTheSphere(const Machine& machine, test::RandomBoxes& random)
{
  Vector3d direction(0.0, 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
    direction +=
        random.between(0.1, 1.0) * slidingStrut(machine.leg(i)).working_mode * mid(slidingStrut(machine.leg(i)).axis);
  direction.normalize();
  const double width = random.between(0.001, 0.1);
  const Vector3d center = (1.0 + random.between(-1.0, 1.0) * width) * direction;
  HalfSpace half;
  half.normal = random.between(0.0, 1.0) < 0.7 ? direction : Vector3d(-direction);
  half.offset = half.normal.dot(direction) + random.between(-0.5, 0.05) * width;
  return { Box{ center - Vector3d::Constant(0.5 * width), center + Vector3d::Constant(0.5 * width) }, half };
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
  slidingStrut(longer[0]).length = 1.0 + 0x1p-52;
  Machine::Legs aside = orthoglide().legs();
  slidingStrut(aside[0]).platform = enclose(Vector3d(0.0, 0x1p-60, 0x1p-60));
  for (const auto& legs : { longer, aside })
    EXPECT_EQ(strutSpheres(Machine("nearly", legs, Vector3d::Zero())).size(), 1u) << "of the other two legs";
  Machine::Legs uncertain = orthoglide().legs();
  for (Leg& leg : uncertain)
    slidingStrut(leg).length = Interval(1.0, 1.0 + 0x1p-52);
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

// det A h_1 h_2 h_3 = g^2 Q at points, and what is said of a box holds for its points.
TEST(StrutSphere, factorsOfTheDeterminant)
{
  test::RandomBoxes random(SEED);
  for (const Machine& machine : withMeetingRails())
  {
    const MachineModel<double> model(machine, reachable());
    ASSERT_TRUE(model.condition<AspectSign>().railsMeet()) << machine.name();
    Criterion within_reach = reachable();
    within_reach.aspect = Criterion::Aspect::BOTH;
    const test::Oracle oracle(machine, within_reach);
    int reached = 0;
    const auto factorsOver = [&model](const Box& box) {
      const CenteredBox<double> there(box);
      return model.condition<AspectSign>().factors(model.legs().evaluate(there), there);
    };
    for (int k = 0; k < test::cases(200); ++k)
    {
      const Box box = nextToTheSphere(machine, random).first;
      const Vector3d point = random.pointIn(box);
      const CenteredBox<double> there(Box{ point, point });
      if (!oracle.isGood(point))
        continue;
      ++reached;
      const auto wide = factorsOver(box);
      const auto f = factorsOver({ point, point });
      const double det = model.condition<AspectSign>().form(model.legs().evaluate(there)).center;
      EXPECT_NEAR(det * f[0].center * f[1].center * f[2].center, f[3].center * f[3].center * f[4].center, 1e-13)
          << machine.name() << ", seed " << SEED << ", point " << point.transpose();
      for (const std::size_t i : { 0U, 1U, 2U, 4U })
      {
        EXPECT_LE(wide[i].lower(), f[i].center + 1e-13) << machine.name() << ", factor " << i << ", case " << k;
        EXPECT_GE(wide[i].upper(), f[i].center - 1e-13) << machine.name() << ", factor " << i << ", case " << k;
      }
    }
    EXPECT_GT(reached, 20) << machine.name();
  }
}

// By the definition, at points of the box and the half-space, and not on both sides of the sphere, where det A has the
// same sign; where det A itself says nothing its factors do.
TEST(StrutSphere, insideNextToItHolds)
{
  test::RandomBoxes random(SEED);
  for (const Machine& machine : withMeetingRails())
    for (const Criterion::Aspect aspect : { Criterion::Aspect::OWN, Criterion::Aspect::OTHER })
    {
      Criterion criterion = reachable();
      criterion.aspect = aspect;
      const BoxTest test(machine, criterion);
      const test::Oracle oracle(machine, criterion);
      int by_factors = 0;
      for (int k = 0; k < test::cases(400); ++k)
      {
        const auto [box, half] = nextToTheSphere(machine, random);
        BoxVerdict verdict = BoxVerdict::UNDECIDED;
        test.kernel().classify(&box, 1, &verdict, nullptr, &half);
        by_factors += verdict == BoxVerdict::INSIDE && test.classify(box) == BoxVerdict::UNDECIDED ? 1 : 0;
        double least = 2.0;
        double farthest = 0.0;
        for (int sample = 0; verdict == BoxVerdict::INSIDE && sample < 10; ++sample)
        {
          const Vector3d point = random.pointIn(box);
          if (half.normal.dot(point) > half.offset)
            continue;
          EXPECT_TRUE(oracle.isGood(point))
              << machine.name() << ", seed " << SEED << ", case " << k << ", point " << point.transpose();
          least = std::min(least, point.norm());
          farthest = std::max(farthest, point.norm());
        }
        EXPECT_FALSE(least < 1.0 - 1e-12 && farthest > 1.0 + 1e-12)
            << machine.name() << ", seed " << SEED << ", case " << k << ": a point of the sphere is between";
      }
      EXPECT_TRUE(aspect == Criterion::Aspect::OTHER || by_factors > 40) << machine.name() << ": " << by_factors;
    }
}

TEST(StrutSphere, railsThatMissEachOtherHaveNone)
{
  EXPECT_FALSE(MachineModel<double>(uranesx(), reachable()).condition<AspectSign>().railsMeet());
  EXPECT_FALSE(MachineModel<double>(test::crooked(1), reachable()).condition<AspectSign>().railsMeet());
}
}  // namespace pkm_workspace
