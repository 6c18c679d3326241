// SPDX-License-Identifier: BSD-3-Clause
// Paths between points, against the definition along them, and points that no path joins.
#include "pkm_workspace/tasks/connection.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "pkm_workspace/machine/frame.h"
#include "region/parallel_rails.h"
#include "support/cases.h"
#include "support/definition.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Verdict = ConnectionReport::Verdict;

ConnectionTask between(const Vector3d& from, const Vector3d& to)
{
  ConnectionTask task;
  task.query.criterion.psi_min = 0.2;
  task.query.criterion.psi_max = 5.0;
  task.from = from;
  task.to = to;
  return task;
}

/// The path begins and ends where it should, and is good wherever it is looked at.
void expectGoodPath(const Machine& machine, const ConnectionTask& task, const ConnectionReport& report)
{
  ASSERT_EQ(report.verdict, Verdict::CONNECTED) << report.message;
  ASSERT_GE(report.path.size(), 2U);
  EXPECT_EQ(report.path.front(), task.from);
  EXPECT_EQ(report.path.back(), task.to);
  const test::Oracle oracle(machine, task.query.criterion);
  for (std::size_t k = 1; k < report.path.size(); ++k)
    for (int i = 0; i <= 20; ++i)
    {
      const Vector3d point = report.path[k - 1] + i / 20.0 * (report.path[k] - report.path[k - 1]);
      ASSERT_TRUE(oracle.isGood(point)) << machine.name() << " (" << point.transpose() << ")";
    }
}
}  // namespace

TEST(Connection, isAPathOfGoodPoints)
{
  const Machine machine = test::crooked(3);
  test::Random random(test::SEED);
  const auto any = [&] {
    return Vector3d(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
  };
  for (int pairs = 0; pairs < test::cases(8);)
  {
    ConnectionTask task = between(any(), any());
    task.query.criterion.psi_min = 0.6;
    task.query.criterion.psi_max = 1.6;
    const auto isGood = [&](const Vector3d& p) { return test::violatedAt(machine, task.query.criterion, p).empty(); };
    if (!isGood(task.from) || !isGood(task.to) || isGood(0.5 * (task.from + task.to)))
      continue;  // points that a straight line does not join
    ++pairs;
    const ConnectionReport report = connect(machine, task);
    expectGoodPath(machine, task, report);
    EXPECT_GT(report.path.size(), 2U) << "seed " << test::SEED;
  }
}

TEST(Connection, isNoneBetweenPiecesOfOneAspect)
{
  const Machine machine = orthoglide();
  ConnectionTask task = between(machine.zero(), Vector3d::Constant(0.65));
  ConnectionReport report = connect(machine, task);
  EXPECT_EQ(report.verdict, Verdict::APART);
  EXPECT_EQ(report.message,
            "Proved: the points are apart. Both are dextrous in the machine's own aspect, and no path "
            "in the set joins them.");
  EXPECT_TRUE(report.path.empty());
  task.query.box = Box{ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) };
  report = connect(machine, task);
  EXPECT_EQ(report.verdict, Verdict::APART);
  EXPECT_NE(report.message.find("no path in the part of the set in the box joins them"), std::string::npos);
}

TEST(Connection, goesAroundAZoneToKeepOutOf)
{
  const Machine machine = orthoglide();
  ConnectionTask task = between(Vector3d::Zero(), Vector3d(0.4, 0.0, 0.0));
  task.query.criterion.psi_min = 0.5;
  task.query.criterion.psi_max = 2.0;
  Zone wall;
  wall.pose.translation = Vector3d(0.2, -1.9, 0.0);
  wall.sides = Vector3d(0.05, 4.0, 4.0);  // up to y = 0.1
  task.query.criterion.zones = { wall };
  const ConnectionReport around = connect(machine, task);
  expectGoodPath(machine, task, around);
  EXPECT_GT(around.path.size(), 2U);
  wall.pose.translation.y() = 0.0;
  task.query.criterion.zones = { wall };
  EXPECT_EQ(connect(machine, task).verdict, Verdict::APART);
}

TEST(Connection, isSettledByAFinerResolution)
{
  ConnectionTask task = between(Vector3d::Zero(), Vector3d::Constant(0.65));
  task.resolution = 0.2;
  const ConnectionReport coarse = connect(orthoglide(), task);
  EXPECT_EQ(coarse.verdict, Verdict::OPEN);
  EXPECT_NE(coarse.message.find("Not decided at the resolution of 0.2 m"), std::string::npos) << coarse.message;
  task.resolution.reset();
  task.query.budget.max_boxes = 1000;
  const ConnectionReport ended = connect(orthoglide(), task);
  EXPECT_EQ(ended.verdict, Verdict::OPEN);
  EXPECT_NE(ended.message.find("the limit of 1000 boxes ended"), std::string::npos) << ended.message;
}

TEST(Connection, namesThePointThatIsNotInTheSet)
{
  const ConnectionReport report = connect(orthoglide(), between(Vector3d::Zero(), Vector3d::Constant(0.57)));
  EXPECT_EQ(report.verdict, Verdict::OUTSIDE);
  EXPECT_EQ(*report.bad_point, Vector3d::Constant(0.57));
}

TEST(Connection, goesAlongParallelRails)
{
  const Pose leaning = { { 0.1, -0.2, 0.1, std::sqrt(0.94) }, Vector3d(0.1, -0.2, 0.3) };
  const Machine upright = test::withParallelRails(5);
  for (const Machine& machine : { uranesx(), upright, machineInFrame(upright, leaning) })
  {
    ConnectionTask task = between(machine.zero(), machine.zero());
    task.query.criterion.joint_limits = false;
    task.query.criterion.psi_min = 0.1;
    task.query.criterion.psi_max = 10.0;
    const Vector3d along = mid(slidingStrut(machine.leg(0)).axis);
    task.to += 3.0 * along + 0.05 * along.cross(Vector3d::UnitX()).normalized();
    const ConnectionReport report = connect(machine, task);
    expectGoodPath(machine, task, report);
    EXPECT_EQ(report.paving.tree.bisection().dimension(), 2);
  }
}

TEST(Connection, joinsAPointWithItself)
{
  const ConnectionReport report = connect(uranesx(), between(uranesx().zero(), uranesx().zero()));
  EXPECT_EQ(report.verdict, Verdict::CONNECTED) << report.message;
  EXPECT_EQ(report.path.size(), 2U);
}

TEST(Connection, refusesPointsOutOfTheBox)
{
  ConnectionTask task = between(Vector3d::Zero(), Vector3d::Constant(0.65));
  task.query.box = Box{ Vector3d::Constant(-0.5), Vector3d::Constant(0.5) };
  test::expectThrow<std::invalid_argument>([&] { connect(orthoglide(), task); },
                                           "the point .0.65 0.65 0.65. m is not in the box; give a box with both");
}
}  // namespace pkm_workspace
