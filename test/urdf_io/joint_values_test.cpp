// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/joint_values.h"

#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/random.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Values = std::map<std::string, double>;

Isometry3d motionOf(const urdf::Joint& joint, double value)
{
  const Vector3d axis = Vector3d(joint.axis.x, joint.axis.y, joint.axis.z).normalized();
  if (joint.type == urdf::Joint::FIXED)
    return Isometry3d::Identity();
  if (joint.type == urdf::Joint::PRISMATIC)
    return Isometry3d(Eigen::Translation3d(value * axis));
  return Isometry3d(Eigen::AngleAxisd(value, axis));
}

/// Where a link is, in the root's frame, as robot_state_publisher would have it.
Isometry3d poseOf(const std::string& link, const urdf::ModelInterface& model, const Values& values)
{
  const auto& joint = model.getLink(link)->parent_joint;
  if (!joint)
    return Isometry3d::Identity();
  const auto& origin = joint->parent_to_joint_origin_transform;
  const auto& turn = origin.rotation;
  const Isometry3d at = Eigen::Translation3d(origin.position.x, origin.position.y, origin.position.z) *
                        Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z);
  const double value = joint->type == urdf::Joint::FIXED ? 0.0 : values.at(joint->name);
  return poseOf(joint->parent_link_name, model, values) * at * motionOf(*joint, value);
}

/// Expects the model to close at p: its three tool points there, none of them turned.
void expectClosed(const UrdfMachine& urdf, const urdf::ModelInterface& model, const Vector3d& p)
{
  const Values values = jointValues(urdf, p);
  const Values zero = jointValues(urdf, urdf.machine.zero());
  const double tolerance = 1e-9 * urdf.machine.scale() + 1e-15 * p.norm();
  for (const std::string& link : urdf.tcp_links)
  {
    const Isometry3d pose = poseOf(link, model, values);
    EXPECT_LE((pose.translation() - p).norm(), tolerance) << link << " at " << p.transpose();
    EXPECT_TRUE(pose.linear().isApprox(poseOf(link, model, zero).linear(), 1e-9)) << link << " at " << p.transpose();
  }
}

void expectClosedAround(const std::string& xml)
{
  const UrdfMachine urdf = readUrdf(xml);
  const auto model = urdf::parseURDF(xml);
  ASSERT_TRUE(model);
  const std::uint64_t seed = 7;
  SCOPED_TRACE(urdf.machine.name() + ", seed " + std::to_string(seed));
  Random random(seed);
  expectClosed(urdf, *model, urdf.machine.zero());
  for (int run = 0; run < cases(20); ++run)
  {
    const double size = 0.3 * urdf.machine.scale();
    const Vector3d offset(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    if (inverseKinematics(urdf.machine, urdf.machine.zero() + offset))
      expectClosed(urdf, *model, urdf.machine.zero() + offset);
  }
}

std::string orthoglideUrdf()
{
  return writeUrdf(orthoglide());
}
}  // namespace

TEST(JointValues, closeTheLoopsOfEveryKindOfMachine)
{
  for (const Machine& machine : slidingKinds())
    expectClosedAround(writeUrdf(machine));
}

TEST(JointValues, closeTheLoopsOfEveryFormOfLeg)
{
  for (const char* name : { "delta", "tripod", "mixed_legs" })
    expectClosedAround(readWholeFile(PKM_WORKSPACE_SOURCE_DIR "/urdf/" + std::string(name) + ".urdf", 1000000));
  for (unsigned seed = 1; seed < 20; ++seed)
  {
    Machine::Legs legs = crookedMix(seed).legs();
    std::get<Crank>(legs[2].kind).drive_scale = 0.0;
    expectClosedAround(writeUrdf(Machine("mix", legs, crookedMix(seed).zero())));
  }
}

TEST(JointValues, closeTheLoopsOfMeasuredLegsOfEveryForm)
{
  MachineDescription machine;
  for (std::size_t i = 0; i < 3; ++i)
  {
    LegDescription& leg = machine.legs[i];
    leg.kind = static_cast<LegDescription::Kind>(i);
    leg.joint = "drive_" + std::to_string(i);
    leg.angle = 2.1 * static_cast<double>(i);
    leg.radius = i == 2 ? 0.05 : 0.13;
    leg.height = 0.01 * static_cast<double>(i);
    leg.length = 0.27;
    leg.platform_joint = { 0.03, 0.01, -0.02 };
    leg.lower = -0.1;
    leg.upper = 0.1;
  }
  machine.legs[2].crank = 0.1;
  for (const double lean : { 0.0, 0.3 })
  {
    machine.legs[2].axis_lean = lean;
    machine.legs[2].crank_zero = 2.0 * lean;
    expectClosedAround(writeUrdf(machine));
  }
}

TEST(JointValues, closeTheLoopsOnATurnedMount)
{
  expectClosedAround(mounted(orthoglideUrdf(), "xyz=\"1 2 3\" rpy=\"0.3 -1.2 2\""));
}

TEST(JointValues, closeTheLoopsOfWristsThatAreFlippedOrLead)
{
  auto urdf = withJoint(orthoglideUrdf(), "revolute_back_1", "xyz=\"0 1 0\"", "xyz=\"0 -1 0\"");
  urdf = withJoint(urdf, "revolute_back_1", "multiplier=\"-1\"", "multiplier=\"1\"");
  urdf = withJoint(urdf, "bar_joint_a_2", "<mimic joint=\"parallelogram_2\" multiplier=\"1\"/>", "");
  urdf = withJoint(urdf, "parallelogram_2", "<axis", "<mimic joint=\"bar_joint_a_2\" multiplier=\"2\"/><axis");
  expectClosedAround(urdf);
}

TEST(JointValues, closeTheLoopsOfSphericalAndSlantedJoints)
{
  auto urdf =
      withJoint(orthoglideUrdf(), "parallelogram_back_1", "<parent link=\"strut_1\"/>", "<parent link=\"spun\"/>");
  urdf = withJoint(urdf, "parallelogram_back_1", "xyz=\"1 0 0\"", "xyz=\"0 0 0\"");
  urdf = withElements(urdf, branch("spin", "continuous", "strut_1", "<axis xyz=\"1 0 0\"/>"));
  urdf = withElements(urdf, branch("spun", "continuous", "spin",
                                   "<origin xyz=\"1 0 0\"/><axis xyz=\"1 0 0\"/>"
                                   "<mimic joint=\"spin\" multiplier=\"-1\"/>"));
  urdf = withJoint(urdf, "parallelogram_2", "axis xyz=\"1 0 0\"", "axis xyz=\"1 0.1 0.2\"");
  urdf = withJoint(urdf, "parallelogram_back_2", "axis xyz=\"1 0 0\"", "axis xyz=\"1 0.1 0.2\"");
  expectClosedAround(urdf);
}

TEST(JointValues, areZeroAtZero)
{
  for (const auto& value : jointValues(readUrdf(orthoglideUrdf()), Vector3d::Zero()))
    EXPECT_EQ(value.second, 0.0) << value.first;
}

TEST(JointValues, moveTheBarsAlongWithTheirStruts)
{
  for (const Machine& machine : slidingKinds())
  {
    const std::string xml = writeUrdf(machine);
    const UrdfMachine urdf = readUrdf(xml);
    const auto model = urdf::parseURDF(xml);
    const Vector3d p = urdf.machine.zero() + 0.2 * urdf.machine.scale() * Vector3d(1.0, -0.7, 0.4);
    const Values values = jointValues(urdf, p);
    for (const std::string n : { "1", "2", "3" })
      for (const std::string& bar : { "bar_a_" + n, "bar_b_" + n })
      {
        const auto& half_width = model->getLink(bar)->parent_joint->parent_to_joint_origin_transform.position;
        const auto& strut = model->getLink("wrist_" + n)->parent_joint->parent_to_joint_origin_transform.position;
        const Vector3d end = poseOf(bar, *model, values) * Vector3d(strut.x, strut.y, strut.z);
        const Vector3d hinge =
            poseOf("wrist_" + n, *model, values) * Vector3d(half_width.x, half_width.y, half_width.z);
        EXPECT_LE((end - hinge).norm(), 1e-9 * machine.scale()) << machine.name() << " " << bar;
      }
  }
}

TEST(JointValues, holdEveryJointThatMovesWithTheMachineAndNoOther)
{
  const auto urdf = withElements(orthoglideUrdf(), branch("pan", "continuous", "base_link", "<axis xyz=\"0 0 1\"/>"));
  const Values values = jointValues(readUrdf(urdf), Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(values.size(), 3u * 7u);
  EXPECT_EQ(values.count("pan"), 0u);
  EXPECT_EQ(values.at("bar_joint_a_1"), values.at("parallelogram_1"));
  EXPECT_EQ(values.at("revolute_back_1"), -values.at("revolute_1"));
}

TEST(JointValues, refuseWhatIsOutOfReach)
{
  const UrdfMachine urdf = readUrdf(orthoglideUrdf());
  expectThrow<std::invalid_argument>([&] { jointValues(urdf, Vector3d(0.5, 0.9, 0.9)); },
                                     "tool point \\(0.5 0.9 0.9\\) m: a strut does not reach it");
  auto slanted = withJoint(orthoglideUrdf(), "parallelogram_1", "axis xyz=\"0 0 1\"", "axis xyz=\"1 0 1\"");
  slanted = withJoint(slanted, "parallelogram_back_1", "axis xyz=\"0 0 1\"", "axis xyz=\"1 0 1\"");
  expectThrow<std::invalid_argument>([&] { jointValues(readUrdf(slanted), Vector3d(0.0, 0.8, 0.0)); },
                                     "'revolute_1' and 'parallelogram_1' cannot turn the strut that far");
}
}  // namespace test
}  // namespace pkm_workspace
