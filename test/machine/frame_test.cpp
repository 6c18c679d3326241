// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/frame.h"

#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "support/exact_machines.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

/// Mostly any orientation, sometimes a half or a quarter turn about an axis, sometimes none.
Pose randomPose(Random& random, double reach)
{
  Pose pose;
  do
    for (double& entry : pose.orientation)
      entry = random.once(3) ? random.integer(-1, 1) : random.uniform(-1.0, 1.0);
  while (Eigen::Vector4d(pose.orientation.data()).norm() < 0.1);
  const double norm = Eigen::Vector4d(pose.orientation.data()).norm() * random.uniform(0.9995, 1.0005);
  for (double& entry : pose.orientation)
    entry /= norm;
  for (int k = 0; k < 3; ++k)
    pose.translation[k] = random.once(4) ? 0.0 : random.uniform(-reach, reach);
  return pose;
}

/// q v q* / (q q*) by the product of quaternions, to 90 digits.
ExactVector turned(const Pose& pose, const ExactVector& v)
{
  const ExactVector u = { pose.orientation[0], pose.orientation[1], pose.orientation[2] };
  const Exact w = pose.orientation[3];
  const auto cross = [](const ExactVector& a, const ExactVector& b) {
    return ExactVector{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  };
  const ExactVector product = w * v + cross(u, v);  // the vector part of q v; the other part is -u . v
  const Exact n = dot(u, u) + w * w;
  return (Exact(1.0) / n) * (dot(u, v) * u + w * product + cross(u, product));
}

ExactVector moved(const Pose& pose, const ExactVector& p)
{
  return turned(pose, p) + exact(pose.translation);
}

void expectHolds(const IntervalVector& set, const ExactVector& v)
{
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(v[k].mayLieIn(set[k])) << v[k] << " is not in " << set[k];
}

std::array<ExactLeg, 3> moved(const Pose& pose, std::array<ExactLeg, 3> legs)
{
  for (ExactLeg& leg : legs)
  {
    leg.origin = moved(pose, leg.origin);
    leg.axis = turned(pose, leg.axis);
    leg.platform = turned(pose, leg.platform);
  }
  return legs;
}

bool isSubset(const IntervalVector& a, const IntervalVector& b)
{
  return a[0].isSubsetOf(b[0]) && a[1].isSubsetOf(b[1]) && a[2].isSubsetOf(b[2]);
}

/// Calls @p check(machine, pose, random) with every machine and many poses.
template <class Check>
void forEachPose(int count, const Check& check)
{
  for (const ExactMachine& machine : exactMachines())
    for (int seed = 0; seed < cases(count) && !testing::Test::HasFailure(); ++seed)
    {
      SCOPED_TRACE(machine.name + ", seed " + std::to_string(seed));
      Random random(static_cast<std::uint64_t>(seed));
      const Pose pose = randomPose(random, 3.0 * machine.machine.scale());
      check(machine, pose, random);
    }
}
}  // namespace

TEST(MachineInFrame, enclosesTheTurnedGeometry)
{
  forEachPose(30, [](const ExactMachine& machine, const Pose& pose, Random&) {
    const Machine there = machineInFrame(machine.machine, pose);
    const auto legs = moved(pose, machine.legs);
    for (std::size_t i = 0; i < 3; ++i)
    {
      expectHolds(slidingStrut(there.legs()[i]).origin, legs[i].origin);
      expectHolds(slidingStrut(there.legs()[i]).axis, legs[i].axis);
      expectHolds(slidingStrut(there.legs()[i]).platform, legs[i].platform);
      EXPECT_LE(slidingStrut(there.legs()[i]).axis[0].width(), 1e-14);
      EXPECT_EQ(slidingStrut(there.legs()[i]).working_mode, slidingStrut(machine.machine.legs()[i]).working_mode);
      EXPECT_EQ(slidingStrut(there.legs()[i]).length, slidingStrut(machine.machine.legs()[i]).length);
      EXPECT_EQ(there.legs()[i].limits, machine.machine.legs()[i].limits);
    }
    EXPECT_EQ(there.aspect(), machine.machine.aspect());
    EXPECT_EQ(there.name(), machine.machine.name());
  });
}

TEST(MachineInFrame, jointsAndStrutsAreThoseOfTheSamePoint)
{
  int tried = 0;
  forEachPose(30, [&](const ExactMachine& machine, const Pose& pose, Random& random) {
    const double reach = 0.5 * machine.machine.scale();
    const Vector3d p = machine.machine.zero() + Vector3d(random.uniform(-reach, reach), random.uniform(-reach, reach),
                                                         random.uniform(-reach, reach));
    const ExactConfiguration here = exactConfiguration(machine.legs, exact(p));
    const auto found = configurationAt(machineInFrame(machine.machine, pose), transformed(pose, enclose(p)));
    if (!found || !here.isReached())
      return;
    ++tried;
    expectHolds(found->rho, here.rho);
    expectHolds(found->eta, here.eta);
    EXPECT_TRUE(here.det_a.mayLieIn(found->det_a));
    for (std::size_t i = 0; i < 3; ++i)
      expectHolds(found->strut[i], turned(pose, here.strut[i]));
  });
  EXPECT_GT(tried, cases(100));
}

TEST(MachineInFrame, transmissionFactorsStay)
{
  forEachPose(10, [](const ExactMachine& machine, const Pose& pose, Random&) {
    const Vector3d zero = machine.machine.zero();
    const Vector3d there = mid(transformed(pose, enclose(zero)));
    const Vector3d before = transmissionFactors(*jacobians(machine.machine, zero));
    const Vector3d after = transmissionFactors(*jacobians(machineInFrame(machine.machine, pose), there));
    EXPECT_LE((after - before).cwiseAbs().maxCoeff(), 1e-8) << before.transpose() << ", " << after.transpose();
  });
}

TEST(MachineInFrame, theIdentityGivesTheSameMachine)
{
  for (const double w : { 1.0, -1.0, 1.0 - 1e-4 })
    for (const ExactMachine& machine : exactMachines())
    {
      const Machine same = machineInFrame(machine.machine, Pose{ { 0.0, 0.0, 0.0, w }, Vector3d::Zero() });
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_EQ(slidingStrut(same.legs()[i]).origin, slidingStrut(machine.machine.legs()[i]).origin);
        EXPECT_EQ(slidingStrut(same.legs()[i]).axis, slidingStrut(machine.machine.legs()[i]).axis);
        EXPECT_EQ(slidingStrut(same.legs()[i]).platform, slidingStrut(machine.machine.legs()[i]).platform);
      }
      EXPECT_EQ(same.zero(), machine.machine.zero());
      EXPECT_EQ(same.geometryHash(), machine.machine.geometryHash()) << machine.name << ", w = " << w;
    }
}

TEST(MachineInFrame, turningBackEnclosesTheOriginal)
{
  forEachPose(30, [](const ExactMachine& machine, const Pose& pose, Random&) {
    Machine back = machineInFrame(machine.machine, pose);
    const auto& q = pose.orientation;
    back = machineInFrame(back, Pose{ { 0.0, 0.0, 0.0, 1.0 }, -pose.translation });
    back = machineInFrame(back, Pose{ { -q[0], -q[1], -q[2], q[3] }, Vector3d::Zero() });
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(isSubset(slidingStrut(machine.machine.legs()[i]).origin, slidingStrut(back.legs()[i]).origin));
      EXPECT_TRUE(isSubset(slidingStrut(machine.machine.legs()[i]).axis, slidingStrut(back.legs()[i]).axis));
      EXPECT_TRUE(isSubset(slidingStrut(machine.machine.legs()[i]).platform, slidingStrut(back.legs()[i]).platform));
    }
  });
}

TEST(MachineInFrame, anotherFrameMeansOtherNumbers)
{
  const Pose shifted{ { 0.0, 0.0, 0.0, 1.0 }, Vector3d(0x1p-40, 0.0, 0.0) };
  const Pose turned{ { 0x1p-40, 0.0, 0.0, 1.0 }, Vector3d::Zero() };
  for (const Pose& pose : { shifted, turned })
    EXPECT_NE(machineInFrame(orthoglide(), pose).geometryHash(), orthoglide().geometryHash());
}

TEST(MachineInFrame, railsAreParallelIffTheyWereBefore)
{
  const auto withLastAxis = [](const IntervalVector& axis) {
    Machine::Legs legs = uranesx().legs();
    slidingStrut(legs[2]).axis = axis;
    slidingStrut(legs[2]).working_mode = axis[2].certainlyPositive() ? -1 : 1;
    return Machine("uranesx", legs, uranesx().zero());
  };
  forEachPose(10, [&](const ExactMachine&, const Pose& pose, Random&) {
    EXPECT_TRUE(machineInFrame(uranesx(), pose).hasParallelRails());
    EXPECT_TRUE(machineInFrame(withLastAxis({ 0.0, 0.0, -1.0 }), pose).hasParallelRails());
    EXPECT_FALSE(machineInFrame(withLastAxis({ 0.0, 0x1p-1074, 1.0 }), pose).hasParallelRails());
    EXPECT_FALSE(machineInFrame(withLastAxis({ 1e-200, 0.0, -1.0 }), pose).hasParallelRails());
    EXPECT_FALSE(machineInFrame(orthoglide(), pose).hasParallelRails());
    const Machine nearly = machineInFrame(withLastAxis({ 0.0, 0x1p-1074, 1.0 }), pose);
    EXPECT_NE(nearly.geometryHash(), machineInFrame(uranesx(), pose).geometryHash());
    EXPECT_TRUE(machineInFrame(machineInFrame(uranesx(), pose), pose).hasParallelRails());
    EXPECT_FALSE(machineInFrame(nearly, pose).hasParallelRails());
  });
  const Pose about_z{ { 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5) }, Vector3d(1.0, 2.0, 3.0) };
  EXPECT_EQ(slidingStrut(machineInFrame(uranesx(), about_z).leg(1)).axis, slidingStrut(uranesx().leg(1)).axis)
      << "the rails are the axis of the turn";
}

TEST(MachineInFrame, refusesWhatIsNoPose)
{
  const auto attempt = [](const Pose& pose) { machineInFrame(orthoglide(), pose); };
  const double inf = std::numeric_limits<double>::infinity();
  using Bad = std::invalid_argument;
  expectThrow<Bad>([&] { attempt({ { 0.0, 0.0, 0.0, 0.0 }, Vector3d::Zero() }); }, "unit quaternion: its norm is 0,");
  expectThrow<Bad>([&] { attempt({ { 0.0, 0.0, 0.0, 1.0011 }, Vector3d::Zero() }); }, "norm is 1.0011.*0.001");
  expectThrow<Bad>([&] { attempt({ { 1e200, 0.0, 0.0, 1e200 }, Vector3d::Zero() }); }, "norm is 1.41.*e.200");
  expectThrow<Bad>(
      [&] {
        attempt({ { 0.0, std::nan(""), 0.0, inf }, Vector3d(0.0, 0.0, -inf) });
      },
      "orientation y = nan must be finite[^]*orientation w = inf[^]*translation z = -inf m must be");
}
}  // namespace test
}  // namespace pkm_workspace
