// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/machine_family.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "support/expect_throw.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
void expectEnclosed(const Machine& inner, const Machine& outer)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(slidingStrut(inner.leg(i)).length.isSubsetOf(slidingStrut(outer.leg(i)).length));
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(slidingStrut(inner.leg(i)).origin[k].isSubsetOf(slidingStrut(outer.leg(i)).origin[k]));
      EXPECT_TRUE(slidingStrut(inner.leg(i)).axis[k].isSubsetOf(slidingStrut(outer.leg(i)).axis[k]));
      EXPECT_TRUE(slidingStrut(inner.leg(i)).platform[k].isSubsetOf(slidingStrut(outer.leg(i)).platform[k]));
    }
  }
}
}  // namespace

TEST(MachineFamily, aSetOfParametersEnclosesItsMachines)
{
  for (const MachineFamily& family :
       { uranesxByRadius(), uranesxByLambda(), familyBetween(orthoglide(), test::crooked(1)) })
    for (const double lower : { 0.25, 0.3, 0.34 })
      for (const double share : { 0.0, 0.3, 1.0 })
        expectEnclosed(family.at(Interval(lower + share * 0.01)), family.at(Interval(lower, lower + 0.01)));
}

TEST(MachineFamily, uranesxIsThatOfTheCatalogue)
{
  EXPECT_EQ(uranesxByLambda().at(Interval(0.0)).geometryHash(), uranesx().geometryHash());
  const Machine by_radius = uranesxByRadius(2.0).at(Interval(0.75));
  EXPECT_EQ(by_radius.geometryHash(), uranesx(Interval(0.75), Interval(0.0), 2.0).geometryHash());
}

TEST(MachineFamily, bothEndsAreTheGivenMachines)
{
  const Machine first = orthoglide();
  const Machine last = test::crooked(2);
  const MachineFamily family = familyBetween(first, last);
  EXPECT_EQ(family.at(Interval(0.0)).geometryHash(), first.geometryHash());
  EXPECT_EQ(family.at(Interval(1.0)).geometryHash(), last.geometryHash());
  const Machine middle = family.at(Interval(0.5));
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(squaredNorm(slidingStrut(middle.leg(i)).axis).contains(1.0));
}

TEST(MachineFamily, whatHasNoWayBetweenIsRefused)
{
  test::expectThrow<std::invalid_argument>([] { familyBetween(orthoglide(), uranesx()); }, "opposite working modes");
  const Machine limited = test::limited(orthoglide());
  test::expectThrow<std::invalid_argument>([&] { familyBetween(orthoglide(), limited, true); },
                                           "rail_x(.|\n)*rail_y(.|\n)*rail_z.* different joint limits");
  EXPECT_FALSE(familyBetween(orthoglide(), limited).at(Interval(0.0, 1.0)).hasJointLimits());
  EXPECT_TRUE(familyBetween(limited, limited, true).at(Interval(0.0, 1.0)).hasJointLimits());
}

// Equal enclosures of different axes are not those of parallel rails.
TEST(MachineFamily, railsThatOnlyLookParallelTogetherAreKeptApart)
{
  const auto tilted = [](double x0, double x1) {
    Machine::Legs legs = uranesx(Interval(0.8), Interval(0.0)).legs();
    const double tilts[] = { x0, x1, x1 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double z = std::sqrt(1.0 - tilts[i] * tilts[i]);
      slidingStrut(legs[i]).axis = { Interval(tilts[i]), Interval(0.0), Interval(z, std::nextafter(z, 2.0)) };
    }
    return Machine("tilted", legs, uranesx().zero());
  };
  const double tilt = 0x1p-7;
  const MachineFamily family = familyBetween(tilted(tilt, -tilt), tilted(-tilt, tilt));
  EXPECT_FALSE(family.at(Interval(0.0)).hasParallelRails());
  EXPECT_FALSE(family.at(Interval(0.0, 1.0)).hasParallelRails());
}

TEST(MachineFamily, membersOfTheOtherAspectAreRefusedSoThatNoPartSpeaksForThem)
{
  const Machine first("first", orthoglide().legs(), { -0.6542, -0.0237, -0.6625 });
  const Machine last("last", orthoglide().legs(), { 0.0194, -0.8134, -0.3833 });
  EXPECT_EQ(first.aspect(), last.aspect());
  const MachineFamily family = familyBetween(first, last);
  EXPECT_EQ(family.at(Interval(0.0)).aspect(), first.aspect());
  for (const Interval& share : { Interval(0.5), Interval(0.0, 1.0) })
    test::expectThrow<std::invalid_argument>([&] { family.at(share); }, "share 0.5.* opposite aspect");
}

TEST(MachineFamily, membersMayStandForAllWithinTolerances)
{
  GivenTolerances given;
  given.set(*toleranceKind("tolerance_length"), { 1e-4 });
  const MachineFamily family = withinTolerances(uranesxByRadius(), given);
  EXPECT_EQ(tolerancesOf(family.at(Interval(0.3, 0.31)))[1].length, 1e-4);
  EXPECT_EQ(withinTolerances(uranesxByRadius(), {}).at(Interval(0.3)).geometryHash(),
            uranesxByRadius().at(Interval(0.3)).geometryHash());
  const Machine tolerated = withGivenTolerances(orthoglide(), given);
  EXPECT_EQ(tolerancesOf(familyBetween(tolerated, tolerated).at(Interval(0.5)))[2].length, 1e-4);
  test::expectThrow<std::invalid_argument>([&] { familyBetween(orthoglide(), tolerated); },
                                           "have different tolerances: give both the same");
}
}  // namespace pkm_workspace
