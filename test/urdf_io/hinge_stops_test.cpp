// SPDX-License-Identifier: BSD-3-Clause
// What the limits of passive joints are for the struts, held against the joints' own values in floating point.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/urdf_io/joint_values.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/random.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
std::string shipped(const std::string& name)
{
  std::ifstream file(PKM_WORKSPACE_SOURCE_DIR "/urdf/" + name + ".urdf");
  return { std::istreambuf_iterator<char>(file), {} };
}

struct Limited
{
  std::string joint;
  double lower;
  double upper;
};

std::string withLimits(std::string urdf, const std::vector<Limited>& all)
{
  for (const Limited& limited : all)
    urdf = withJoint(withJoint(urdf, limited.joint, "type=\"continuous\"", "type=\"revolute\""), limited.joint, "<axis",
                     "<limit lower=\"" + std::to_string(limited.lower) + "\" upper=\"" + std::to_string(limited.upper) +
                         "\" effort=\"1\" velocity=\"1\"/><axis");
  return urdf;
}

Criterion hingesOnly()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  criterion.hinge_limits = true;
  return criterion;
}

/// Whether the joints are all within their limits; nothing within rounding of one, or where the hinges do not reach.
std::optional<bool> isWithin(const UrdfMachine& urdf, const std::vector<Limited>& all, const Eigen::Vector3d& p)
{
  constexpr double ROUNDING = 1e-9;
  try
  {
    const auto values = jointValues(urdf, p);
    bool within = true;
    for (const Limited& limited : all)
    {
      const double beyond =
          std::max(limited.lower - values.at(limited.joint), values.at(limited.joint) - limited.upper);
      if (std::abs(beyond) < ROUNDING)
        return std::nullopt;
      within = within && beyond < 0.0;
    }
    return within;
  }
  catch (const std::invalid_argument&)
  {
    return std::nullopt;
  }
}

void expectStopsAreTheLimits(const std::string& name, const std::vector<Limited>& all)
{
  SCOPED_TRACE(name + ", " + all.front().joint + ", seed " + std::to_string(SEED));
  const UrdfMachine urdf = readUrdf(withLimits(shipped(name), all));
  const BoxTest test(urdf.machine, hingesOnly());
  RandomBoxes random(SEED);
  int inside = 0, outside = 0;
  for (int k = 0; k < cases(2000); ++k)
  {
    const Eigen::Vector3d p = random.pointIn(spaceOf(urdf.machine));
    const auto is_within = isWithin(urdf, all, p);
    if (!is_within)
      continue;
    const BoxVerdict verdict = test.classify(p);
    if (verdict == BoxVerdict::UNDECIDED)
      continue;
    ASSERT_EQ(verdict == BoxVerdict::INSIDE, *is_within) << p.transpose();
    (*is_within ? inside : outside)++;
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 20);
}
}  // namespace

TEST(HingeStops, areTheLimitsOfHingesWristsAndBars)
{
  for (const char* const name : { "orthoglide", "orthoglide_prototype", "uranesx" })
  {
    expectStopsAreTheLimits(name, { { "revolute_1", -0.4, 0.5 } });
    expectStopsAreTheLimits(name, { { "parallelogram_2", -0.3, 0.35 } });
    expectStopsAreTheLimits(name, { { "parallelogram_back_3", -0.2, 0.5 } });
    expectStopsAreTheLimits(name, { { "revolute_back_2", -0.5, 0.25 } });
    expectStopsAreTheLimits(name, { { "bar_joint_a_1", -0.4, 0.3 } });
    expectStopsAreTheLimits(name, { { "revolute_1", -0.5, 0.5 },
                                    { "revolute_2", -0.4, 0.6 },
                                    { "revolute_3", -0.5, 0.3 },
                                    { "parallelogram_1", -0.5, 0.5 },
                                    { "parallelogram_2", -0.4, 0.4 } });
  }
}

TEST(HingeStops, areCountedOnlyWhereAskedFor)
{
  const Machine free = readUrdf(shipped("orthoglide")).machine;
  const Machine hinged = readUrdf(withLimits(shipped("orthoglide"), { { "revolute_1", -0.4, 0.5 } })).machine;
  EXPECT_FALSE(free.hasHingeLimits());
  ASSERT_EQ(slidingStrut(hinged.leg(0)).stops.size(), 2U);
  EXPECT_NE(free.geometryHash(), hinged.geometryHash());
  const PointEvaluation there = evaluatePoint(hinged, hingesOnly(), { 0.0, 0.0, 0.6 });
  EXPECT_EQ(there.verdict, BoxVerdict::OUTSIDE);
  EXPECT_EQ(name(there.binding().kind), "hinge_lower");
  EXPECT_EQ(describe(there.binding(), hinged)
                .find("passive joint 'revolute_1' would be beyond its lower limit of -0.4 "
                      "rad, by "),
            0U)
      << describe(there.binding(), hinged);
  Criterion without = hingesOnly();
  without.hinge_limits = false;
  EXPECT_EQ(evaluatePoint(hinged, without, { 0.0, 0.0, 0.6 }).verdict, BoxVerdict::INSIDE);
}

TEST(HingeStops, turnWithTheFrame)
{
  const Machine hinged = readUrdf(withLimits(shipped("orthoglide"), { { "revolute_1", -0.4, 0.5 } })).machine;
  const Pose pose{ { 0.0, 0.28, 0.0, 0.96 }, { 1.0, -2.0, 0.5 } };
  const Machine moved = machineInFrame(hinged, pose);
  const BoxTest here(hinged, hingesOnly()), there(moved, hingesOnly());
  RandomBoxes random(SEED);
  for (int k = 0; k < cases(300); ++k)
  {
    const Eigen::Vector3d p = random.pointIn(spaceOf(hinged));
    const IntervalVector q = transformed(pose, enclose(p));
    const BoxVerdict one = here.classify(p), other = there.classify(mid(q));
    EXPECT_FALSE((one == BoxVerdict::INSIDE && other == BoxVerdict::OUTSIDE) ||
                 (one == BoxVerdict::OUTSIDE && other == BoxVerdict::INSIDE))
        << p.transpose();
  }
}

TEST(HingeStops, areRefusedByNameWhereTheyAreNone)
{
  const auto expectOpen = [](const Limited& limited, const std::string& reason) {
    const Machine machine = readUrdf(withLimits(shipped("orthoglide"), { limited })).machine;
    Problems problems;
    requireProvable(machine, hingesOnly(), problems);
    ASSERT_FALSE(problems.empty()) << reason;
    EXPECT_NE(problems[0].find("joint '" + limited.joint + "'"), std::string::npos) << problems[0];
    EXPECT_NE(problems[0].find(reason), std::string::npos) << problems[0];
    EXPECT_THROW(BoxTest(machine, hingesOnly()), std::invalid_argument);
    Criterion without = hingesOnly();
    without.hinge_limits = false;
    EXPECT_NO_THROW(BoxTest(machine, without));
  };
  // a strut may turn through an axis that is not across its rail: to where both limits of that axis would be passed
  std::string tilted = shipped("orthoglide");
  for (const char* const joint : { "revolute_1", "revolute_back_1" })
    tilted = withJoint(tilted, joint, "axis xyz=\"0 1 0\"", "axis xyz=\"0.8 0.6 0\"");
  const Machine leaning = readUrdf(withLimits(tilted, { { "revolute_1", -0.2, 0.2 } })).machine;
  EXPECT_TRUE(slidingStrut(leaning.leg(0)).stops.empty());
  ASSERT_FALSE(slidingStrut(leaning.leg(0)).open_hinges.empty());
  EXPECT_NE(slidingStrut(leaning.leg(0)).open_hinges[0].find("'revolute_1' is not across the rail"), std::string::npos)
      << slidingStrut(leaning.leg(0)).open_hinges[0];
  const std::string bar =
      withJoint(shipped("orthoglide"), "bar_joint_a_1", "<mimic joint=\"parallelogram_1\" multiplier=\"1\"/>", "");
  const Machine loose = readUrdf(withLimits(bar, { { "bar_joint_a_1", -0.1, 0.1 } })).machine;
  ASSERT_EQ(slidingStrut(loose.leg(0)).open_hinges.size(), 1U);
  EXPECT_EQ(slidingStrut(loose.leg(0)).open_hinges[0],
            "joint 'bar_joint_a_1': it follows no hinge of the strut by <mimic>");
  expectOpen({ "revolute_1", 0.1, 0.5 }, "zero configuration is beyond it");
  expectOpen({ "revolute_1", -2.0, 0.5 }, "quarter of a turn");
  expectOpen({ "parallelogram_1", -0.5, -0.1 }, "zero configuration is beyond it");
  // beyond a quarter of a turn the second hinge does not get, and half a turn stops nothing
  const Machine wide = readUrdf(withLimits(shipped("orthoglide"), { { "parallelogram_1", -1.6, 3.0 } })).machine;
  EXPECT_TRUE(slidingStrut(wide.leg(0)).stops.empty());
  EXPECT_TRUE(slidingStrut(wide.leg(0)).open_hinges.empty());
  const Machine round = readUrdf(withLimits(shipped("orthoglide"), { { "revolute_1", -3.2, 3.2 } })).machine;
  EXPECT_TRUE(slidingStrut(round.leg(0)).stops.empty());
  EXPECT_TRUE(slidingStrut(round.leg(0)).open_hinges.empty());
}
}  // namespace test
}  // namespace pkm_workspace
