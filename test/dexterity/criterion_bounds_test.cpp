// SPDX-License-Identifier: BSD-3-Clause
// Each bound has what it needs outside of its row: an oracle, messages, documentation. Options and parameters are held
// against the messages by cli/help_test.py and ros/startup_test.py.
#include "pkm_workspace/dexterity/criterion_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>

#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/machine/catalogue.h"
#include "support/driven_criteria.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// Asks for nothing but bounds; those that every dextrous set has let anything pass.
Criterion anything(Criterion::Set set)
{
  Criterion criterion = withMotors(orthoglide());
  criterion.set = set;
  criterion.aspect = Criterion::Aspect::BOTH;
  criterion.psi_min = 1e-3;
  criterion.psi_max = 1e3;
  return criterion;
}

Criterion anythingBut(const CriterionBound& bound)
{
  return anything(bound.is_optional ? Criterion::Set::REACHABLE : Criterion::Set::DEXTROUS);
}

std::string bytesOf(const Criterion& criterion)
{
  ByteWriter writer;
  put(criterion, writer);
  return writer.bytes();
}

std::string contentOf(const std::string& name)
{
  std::ifstream file(PKM_WORKSPACE_SOURCE_DIR "/" + name);
  return { std::istreambuf_iterator<char>(file), {} };
}
}  // namespace

TEST(CriterionBounds, areInTheOrderOfTheirLimits)
{
  int kind = static_cast<int>(Limit::Kind::ASPECT);
  EXPECT_EQ(boundOf(Limit::Kind::ASPECT), nullptr);
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    EXPECT_EQ(static_cast<int>(bound.kind), ++kind) << bound.name;
    EXPECT_EQ(boundOf(bound.kind), &bound) << bound.name;
    EXPECT_EQ(name(bound.kind), bound.name);
  }
}

// A point whose value is just within the bound, and just not: 100 digits, the verdict and the limits tell the same.
TEST(CriterionBounds, areKnownToTheOracle)
{
  const Eigen::Vector3d point(0.1, -0.2, 0.25);
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    SCOPED_TRACE(bound.name);
    Criterion criterion = anythingBut(bound);
    Limit limit;
    limit.kind = bound.kind;
    const Oracle::Number value =
        Oracle(orthoglide(), criterion).valueOf(limit, Oracle::Vector{ point.x(), point.y(), point.z() });
    for (const bool is_good : { true, false })
    {
      criterion.*bound.value = static_cast<double>(value) * (bound.is_lower == is_good ? 1.0 - 1e-6 : 1.0 + 1e-6);
      EXPECT_EQ(Oracle(orthoglide(), criterion).isGood(point), is_good);
      const PointEvaluation there = evaluatePoint(orthoglide(), criterion, point);
      EXPECT_EQ(there.verdict, is_good ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE);
      EXPECT_EQ(there.binding().kind, bound.kind);
      EXPECT_EQ(there.binding().isViolated(), !is_good);
    }
  }
}

TEST(CriterionBounds, areInMessagesAndDocumentation)
{
  const std::string limits = contentOf("msg/BindingLimit.msg"), node = contentOf("docs/node.md");
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    std::string constant = bound.name;
    std::transform(constant.begin(), constant.end(), constant.begin(), [](unsigned char c) { return std::toupper(c); });
    constant = "\nuint8 " + constant + " = " + std::to_string(static_cast<int>(bound.kind)) + "\n";
    EXPECT_NE(limits.find(constant), std::string::npos) << constant;
    for (const char* const message : { "msg/CriterionRequest.msg", "msg/Hypotheses.msg" })
      EXPECT_NE(contentOf(message).find(std::string("\nfloat64 ") + bound.name + "\n"), std::string::npos)
          << bound.name << " in " << message;
    for (const char* const page : { "docs/node.md", "docs/conditions.md" })
      EXPECT_NE(contentOf(page).find(std::string("`~") + bound.name + "`"), std::string::npos)
          << bound.name << " in " << page;
  }
  for (const JointDatum& datum : JOINT_DATA)
  {
    EXPECT_NE(contentOf("msg/CriterionRequest.msg").find(std::string("\nfloat64[] ") + datum.name + "\n"),
              std::string::npos);
    EXPECT_NE(contentOf("msg/Hypotheses.msg").find(std::string("\nfloat64[3] ") + datum.name + "\n"),
              std::string::npos);
    for (const char* const page : { "docs/node.md", "docs/conditions.md" })
      EXPECT_NE(contentOf(page).find(std::string("`~") + datum.name + "`"), std::string::npos)
          << datum.name << " in " << page;
  }
}

TEST(JointData, areNeededAndComeFromTheMachine)
{
  Machine::Legs legs = orthoglide().legs();
  legs[1].speed = 2.0;
  const Machine machine("half known", legs, orthoglide().zero());
  Criterion criterion;
  criterion.tool_speed_min = 0.5;
  Problems problems;
  requireProvable(machine, withJointData(machine, criterion), problems);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0],
            "tool_speed_min needs the largest speed [m/s] of joint 'rail_x', which its URDF does "
            "not tell: give joint_speed_max, one number or one for each joint");
  EXPECT_THROW(BoxTest(machine, withJointData(machine, criterion)), std::invalid_argument);
  criterion.joint_speed_max = { 1.0, 0.0, 3.0 };
  const Criterion filled = withJointData(machine, criterion);
  EXPECT_EQ(filled.joint_speed_max, (JointValues{ 1.0, 2.0, 3.0 }));
  EXPECT_NO_THROW(BoxTest(machine, filled));
  EXPECT_EQ(describe(filled),
            "dextrous with psi in [0.5, 2], tool speed at least 0.5 m/s by joints up to (1, 2, 3) m/s, "
            "own aspect, joint limits off");
  criterion.tool_speed_min = 0.0;
  EXPECT_EQ(withJointData(machine, criterion).joint_speed_max[1], 0.0) << "what is not asked for is not told";
}

TEST(JointData, areRefusedOutOfRange)
{
  for (const JointDatum& datum : JOINT_DATA)
    for (const double bad : { -1.0, 1e101, std::nan(""), INF })
    {
      Criterion criterion;
      (criterion.*datum.values)[2] = bad;
      Problems problems;
      criterion.validate(problems);
      ASSERT_EQ(problems.size(), 1U) << datum.name << " " << bad;
      EXPECT_EQ(problems[0].find(datum.name), 0U) << problems[0];
      EXPECT_NE(problems[0].find(std::string("[") + datum.unit + "]"), std::string::npos) << problems[0];
    }
}

// Each number counts where its bound is asked for, and only there.
TEST(JointData, makeADifferenceToTheBytesOfWhatNeedsThem)
{
  for (const JointDatum& datum : JOINT_DATA)
    for (const bool is_asked : { true, false })
    {
      Criterion one = anything(Criterion::Set::REACHABLE);
      one.*datum.bound = is_asked ? 0.5 : 0.0;
      (one.*datum.values)[1] = 2.0;
      Criterion other = one;
      (other.*datum.values)[1] = std::nextafter(2.0, 3.0);
      EXPECT_EQ(one == other, !is_asked) << datum.name;
      EXPECT_EQ(describe(one) == describe(other), !is_asked) << datum.name;
      const std::string bytes = bytesOf(one);
      ByteReader reader(bytes, bytes.size());
      EXPECT_TRUE(takeCriterion(reader) == one) << datum.name;
    }
}

TEST(CriterionBytes, comeBackAsTheSameCriterion)
{
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    SCOPED_TRACE(bound.name);
    Criterion criterion = anythingBut(bound);
    criterion.joint_limits = bound.is_lower;
    criterion.*bound.value = 1.2345678901234567;
    const std::string bytes = bytesOf(criterion);
    ByteReader reader(bytes, bytes.size());
    const Criterion read = takeCriterion(reader);
    EXPECT_EQ(reader.left(), 0U);
    EXPECT_TRUE(read == criterion);
    EXPECT_EQ(describe(read), describe(criterion));
    EXPECT_EQ(read.*bound.value, criterion.*bound.value);
  }
}

TEST(CriterionBytes, differByWhateverIsAskedForAndByNothingElse)
{
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    for (const Criterion::Set set : { Criterion::Set::DEXTROUS, Criterion::Set::REACHABLE })
    {
      SCOPED_TRACE(bound.name + (" of a " + name(set)) + " set");
      Criterion one = anything(set), other = one;
      one.*bound.value = 1.5;
      other.*bound.value = std::nextafter(1.5, 2.0);
      EXPECT_EQ(one == other, !bound.isAskedBy(one));
      EXPECT_EQ(describe(one) == describe(other), !bound.isAskedBy(one));
    }
  Criterion one, other;
  other.aspect = Criterion::Aspect::OTHER;
  EXPECT_FALSE(one == other);
  for (bool Criterion::*flag : { &Criterion::joint_limits, &Criterion::hinge_limits })
  {
    other = one;
    other.*flag = true;
    EXPECT_FALSE(one == other);
    EXPECT_NE(describe(one), describe(other));
    const std::string bytes = bytesOf(other);
    ByteReader reader(bytes, bytes.size());
    EXPECT_TRUE(takeCriterion(reader) == other);
  }
  other = one;
  other.set = Criterion::Set::REACHABLE;
  EXPECT_FALSE(one == other);
}

// Files of format 2 hold these: set, aspect, five doubles, joint limits.
TEST(CriterionBytes, areThoseOfEarlierFiles)
{
  Criterion criterion;
  criterion.aspect = Criterion::Aspect::OTHER;
  criterion.force_min = 0.25;
  criterion.force_max = 4.0;
  criterion.kappa_max = 3.0;
  criterion.joint_limits = true;
  const auto of = [](std::initializer_list<int> high_bytes) {
    std::string bytes;
    for (const int high : high_bytes)
      bytes += std::string(6, '\0') + static_cast<char>(high & 0xff) + static_cast<char>(high >> 8);
    return bytes;
  };
  EXPECT_EQ(bytesOf(criterion), std::string("\0\1", 2) + of({ 0x3fe0, 0x4000, 0x3fd0, 0x4010, 0x4008 }) + '\1');
  EXPECT_EQ(bytesOf(anything(Criterion::Set::REACHABLE)),
            std::string("\1\2", 2) + of({ 0x3fe0, 0x4000, 0, 0, 0 }) + '\0');
}
}  // namespace test
}  // namespace pkm_workspace
