// SPDX-License-Identifier: BSD-3-Clause
// The canonical bytes of premises: whatever makes a difference changes them, and nothing else does.
#include "pkm_workspace/dexterity/premises.h"

#include <gtest/gtest.h>

#include <functional>
#include <regex>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/version.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
Criterion anyCriterion(Random& random)
{
  Criterion criterion;
  criterion.set = static_cast<Criterion::Set>(random.integer(0, 1));
  criterion.aspect = static_cast<Criterion::Aspect>(random.integer(0, 2));
  criterion.joint_limits = random.once(2);
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (!bound.is_optional || random.once(2))
      criterion.*bound.value = random.uniform(1.0, 3.0);
  return criterion;
}

/// Turned and moved, along an axis or along any.
Pose anyPose(Random& random)
{
  Pose pose;
  for (std::size_t part = 0; part < 4; ++part)
    pose.orientation[part] = random.once(3) ? 0.0 : random.uniform(-1.0, 1.0);
  pose.orientation[static_cast<std::size_t>(random.integer(0, 2))] = random.uniform(0.1, 1.0);
  for (int axis = 0; axis < 3; ++axis)
    pose.translation[axis] = random.uniform(-1.0, 1.0);
  return pose;
}

Premises anyPremises(Random& random)
{
  const Machine machine = random.once(2) ? orthoglide(random.uniform(0.5, 2.0)) : uranesx();
  Premises premises = premisesOf(limited(machine), anyCriterion(random));
  if (random.once(2))
    premises.root = anyPose(random);
  return premises;
}

/// How to say the same otherwise.
Premises sameAs(const Premises& premises)
{
  Premises same = premises;
  same.machine += " by another name";
  same.version = "another";
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (!bound.isAskedBy(premises.criterion))
      same.criterion.*bound.value = bound.is_optional ? 0.0 : 17.0;
  for (double& part : same.root.orientation)
    part = -part;
  for (int axis = 0; axis < 3; ++axis)
    if (same.root.translation[axis] == 0.0)
      same.root.translation[axis] = -0.0;
  return same;
}

using Change = std::function<void(Premises& premises)>;

/// Changes of one thing each, with its name.
std::vector<std::pair<std::string, Change>> changesOf(const Premises& premises)
{
  const auto nextAfter = [](double& value) { value = std::nextafter(value, 10.0); };
  std::vector<std::pair<std::string, Change>> changes = {
    { "geometry hash", [](Premises& other) { other.geometry_hash = orthoglide(3.0).geometryHash(); } },
    { "criterion",
      [](Premises& other) {
        const bool is_dextrous = other.criterion.set == Criterion::Set::DEXTROUS;
        other.criterion.set = is_dextrous ? Criterion::Set::REACHABLE : Criterion::Set::DEXTROUS;
      } },
    { "criterion", [](Premises& other) { other.criterion.joint_limits = !other.criterion.joint_limits; } },
    { "frame", [nextAfter](Premises& other) { nextAfter(other.root.translation.y()); } },
    { "frame", [nextAfter](Premises& other) { nextAfter(other.root.orientation[2]); } },
  };
  for (const int way : { 1, 2 })
    changes.emplace_back("criterion", [way](Premises& other) {
      other.criterion.aspect = static_cast<Criterion::Aspect>((static_cast<int>(other.criterion.aspect) + way) % 3);
    });
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.isAskedBy(premises.criterion))
      changes.emplace_back("criterion", [&, nextAfter](Premises& other) { nextAfter(other.criterion.*bound.value); });
    else if (bound.is_optional)
      changes.emplace_back("criterion", [&](Premises& other) { other.criterion.*bound.value = 2.5; });
  return changes;
}
}  // namespace

TEST(Premises, thatMeanTheSameHaveTheSameBytes)
{
  Random random(SEED);
  for (int k = 0; k < cases(200); ++k)
  {
    SCOPED_TRACE("case " + std::to_string(k) + ", seed " + std::to_string(SEED));
    const Premises premises = anyPremises(random), same = sameAs(premises);
    ASSERT_EQ(premises.bytes(), same.bytes());
    ASSERT_EQ(premises.hash(), same.hash());
    ASSERT_TRUE(premises == same);
    ASSERT_TRUE(differences(premises, same).empty());
  }
}

TEST(Premises, differByEachPartAndAreToldByIt)
{
  Random random(SEED);
  for (int k = 0; k < cases(200); ++k)
  {
    SCOPED_TRACE("case " + std::to_string(k) + ", seed " + std::to_string(SEED));
    const Premises premises = anyPremises(random);
    for (const auto& [what, change] : changesOf(premises))
    {
      Premises other = premises;
      change(other);
      ASSERT_NE(premises.bytes(), other.bytes()) << what;
      ASSERT_NE(premises.hash(), other.hash()) << what;
      ASSERT_FALSE(premises == other) << what;
      const std::vector<Difference> found = differences(premises, other);
      ASSERT_EQ(found.size(), 1U) << what;
      EXPECT_EQ(found[0].what, what);
      EXPECT_NE(found[0].one, found[0].other);
    }
  }
}

TEST(Premises, ofAMachineWithoutLimitsAreTheSameWithinThem)
{
  Criterion within, beyond;
  within.joint_limits = true;
  EXPECT_TRUE(premisesOf(orthoglide(), within) == premisesOf(orthoglide(), beyond));
  EXPECT_FALSE(premisesOf(limited(orthoglide()), within) == premisesOf(limited(orthoglide()), beyond));
}

TEST(Premises, comeBackFromTheirBytes)
{
  Random random(SEED);
  for (int k = 0; k < cases(); ++k)
  {
    Premises premises = anyPremises(random);
    premises.root = Pose();
    const std::string bytes = premises.bytes();
    ByteReader reader(bytes, bytes.size());
    EXPECT_TRUE(takePremises(reader) == premises) << "case " << k << ", seed " << SEED;
    EXPECT_EQ(reader.left(), 0U);
  }
}

// A frame that does not turn is the root link's, whatever the quaternion's norm and signs of zeros.
TEST(Premises, nameTheRootFrameInOneWay)
{
  const Premises premises = premisesOf(orthoglide(), Criterion());
  for (const double w : { 1.0, -1.0, 0.9995 })
  {
    Premises same = premises;
    same.root.orientation = { 0.0, -0.0, 0.0, w };
    EXPECT_EQ(premises.bytes(), same.bytes()) << w;
  }
  Premises other = premises;
  other.root = { { 0.0, 0.0, 0.6, -0.8 }, { 1.0, 0.0, -0.0 } };
  EXPECT_EQ(other.bytes().size(), premises.bytes().size() + 7 * sizeof(double));
  EXPECT_EQ(differences(premises, other)[0].other,
            "root link at (1, 0, 0) m, turned by the quaternion (0, 0, -0.6, 0.8)");
}

TEST(Premises, areNamedByUuidsAndToldInTwoLines)
{
  const Premises premises = premisesOf(orthoglide(), Criterion());
  EXPECT_TRUE(std::regex_match(premises.hash(),
                               std::regex("[0-9a-f]{8}-[0-9a-f]{4}-5[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")));
  EXPECT_EQ(describe(premises), "orthoglide, geometry 85bd3fa7, pkm_workspace " + std::string(version()) +
                                    "\ndextrous with psi in [0.5, 2], own aspect, joint limits off");
}
}  // namespace test
}  // namespace pkm_workspace
