// SPDX-License-Identifier: BSD-3-Clause
// Joint limits that the rest of the criterion implies are left out: here by points that an oracle finds.
#include <gtest/gtest.h>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

Machine withLimit(const Machine& machine, int leg, int side, double limit)
{
  Machine::Legs legs = machine.legs();
  legs[static_cast<std::size_t>(leg)].limits = side == 0 ? Interval(limit, INF) : Interval(-INF, limit);
  return Machine(machine.name(), legs, machine.zero());
}

bool isImplied(const Machine& machine, const Criterion& criterion, int leg, int side, double limit)
{
  return limitsThatBind(withLimit(machine, leg, side, limit), criterion)[static_cast<std::size_t>(leg)] ==
         Interval::entire();
}

/// The tightest limit that is left out, up to a thousandth of a strut [m].
double tightestImplied(const Machine& machine, const Criterion& criterion, int leg, int side)
{
  const double sign = side == 0 ? -1.0 : 1.0;
  const double middle = (*configurationAt(machine, machine.zero())).rho[static_cast<std::size_t>(leg)].mid();
  double binds = 0.0;
  double implied = 8.0 * machine.scale();
  while (implied - binds > 1e-3 * machine.scale())
  {
    const double travel = 0.5 * (binds + implied);
    (isImplied(machine, criterion, leg, side, middle + sign * travel) ? implied : binds) = travel;
  }
  return middle + sign * implied;
}

/// A point of the set at which rho is as far on one side as a random walk gets.
Vector3d climb(const Machine& machine, const Oracle& oracle, int leg, double sign, RandomBoxes& random)
{
  Vector3d best = machine.zero();
  double step = 0.5 * machine.scale();
  for (int k = 0; k < 400; ++k)
  {
    const Vector3d next = random.pointIn({ best.array() - step, best.array() + step });
    const auto rho = inverseKinematics(machine, next);
    if (rho && sign * (*rho)[leg] > sign * (*inverseKinematics(machine, best))[leg] && oracle.isGood(next))
      best = next;
    else
      step = std::max(0.97 * step, 1e-6 * machine.scale());
  }
  return best;
}

std::vector<Criterion> criteria()
{
  std::vector<Criterion> criteria(4);
  criteria[1].psi_min = 0.2;
  criteria[1].psi_max = 5.0;
  criteria[2].set = Criterion::Set::REACHABLE;
  criteria[3].set = Criterion::Set::REACHABLE;
  criteria[3].force_min = 0.4;
  return criteria;
}
}  // namespace

TEST(JointLimits, noPointBreaksALimitThatIsLeftOut)
{
  std::vector<Machine> machines = { orthoglide(), cone(), crooked(3, 1.0, Vector3d(1000.0, -20.0, 3.0)) };
  for (unsigned seed = 1; seed <= 5; ++seed)
    machines.push_back(crooked(SEED + seed));
  RandomBoxes random(SEED);
  for (const Machine& machine : machines)
    for (const Criterion& free : criteria())
    {
      Criterion criterion = free;
      criterion.joint_limits = true;
      const Oracle oracle(machine, free);
      for (int leg = 0; leg < 3; ++leg)
        for (const int side : { 0, 1 })
        {
          const double limit = tightestImplied(machine, criterion, leg, side);
          const Vector3d point = climb(machine, oracle, leg, side == 0 ? -1.0 : 1.0, random);
          const Oracle with_limit(withLimit(machine, leg, side, limit), criterion);
          EXPECT_TRUE(with_limit.isGood(point))
              << machine.name() << ", seed " << SEED << ", leg " << leg << ", " << describe(criterion) << ", limit "
              << limit << ", point " << point.transpose();
          // not far from what the set really needs: a law about limits of a kilometre would say nothing
          const double needed = (*inverseKinematics(machine, point))[leg];
          EXPECT_LE(std::abs(limit - needed), 2.0 * machine.scale()) << machine.name() << ", " << describe(criterion);
        }
    }
}

TEST(JointLimits, thatBindStay)
{
  Criterion criterion;
  criterion.joint_limits = true;
  for (const Machine& machine : { orthoglidePrototype(), limited(orthoglide()), limited(crooked(4)) })
    for (int leg = 0; leg < 3; ++leg)
      EXPECT_EQ(limitsThatBind(machine, criterion)[static_cast<std::size_t>(leg)], machine.leg(leg).limits);
}

TEST(JointLimits, thatNobodyAsksForBindNothing)
{
  for (const Interval& limits : limitsThatBind(limited(orthoglide()), Criterion()))
    EXPECT_EQ(limits, Interval::entire());
}

/// Of parallel rails nothing but a limit bounds the joint values.
TEST(JointLimits, ofParallelRailsAreNeverImplied)
{
  Criterion criterion;
  criterion.joint_limits = true;
  Machine::Legs legs = uranesx().legs();
  legs[0].limits = Interval(-1e6, 1e6);
  legs[1].limits = Interval(-INF, 1e6);
  const auto binding = limitsThatBind(Machine("far", legs, uranesx().zero()), criterion);
  for (std::size_t leg = 0; leg < 3; ++leg)
    EXPECT_EQ(binding[leg], legs[leg].limits);
}

TEST(JointLimits, leftOutAreNoFormOfTheModel)
{
  Criterion criterion;
  criterion.joint_limits = true;
  Machine::Legs legs = orthoglide().legs();
  legs[0].limits = Interval(-1.3, 2.3);
  legs[1].limits = Interval(-0.2, 2.3);
  const MachineModel<double> model(Machine("one limit binds", legs, Vector3d::Zero()), criterion);
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (const int side : { 0, 1 })
      EXPECT_EQ(model.condition<JointLimits>().limited(leg, side), leg == 1 && side == 0)
          << "leg " << leg << ", side " << side;
  EXPECT_TRUE(model.criterion().joint_limits);
}
}  // namespace test
}  // namespace pkm_workspace
