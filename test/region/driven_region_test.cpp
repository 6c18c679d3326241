// SPDX-License-Identifier: BSD-3-Clause
// Regions of machines with motors and tolerances, held against the definitions: the joint speeds and forces of many
// directions, how a force makes the tool give way, the errors of all signs. Not against the conditions' matrices.
#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/region/largest_region.h"
#include "support/driven_criteria.h"
#include "support/driven_tool.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Tool = DrivenToolOf<double>;

std::vector<Machine> threeMachines()
{
  return { orthoglide(), uranesx(), crooked(1) };
}

/// A machine at a point, by its geometry; nothing where a strut does not reach.
struct Standing
{
  Tool::Matrix strut;
  Tool::Vector eta;
  double det;
};

std::optional<Standing> standingAt(const Machine& machine, const Eigen::Vector3d& p)
{
  const auto rho = inverseKinematics(machine, p);
  if (!rho)
    return std::nullopt;
  Standing there;
  Eigen::Matrix3d rows;
  for (int i = 0; i < 3; ++i)
  {
    const SlidingStrut& leg = slidingStrut(machine.leg(i));
    const Eigen::Vector3d d = p + mid(leg.platform) - drivenPoint(machine.leg(i), (*rho)[i]);
    rows.row(i) = d;
    there.strut[static_cast<std::size_t>(i)] = { d.x(), d.y(), d.z() };
    there.eta[static_cast<std::size_t>(i)] = d.dot(mid(leg.axis));
  }
  there.det = rows.determinant();
  return there;
}

double length(const Tool::Vector& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// By how much the worst of what is asked is kept, as a share of it: negative where something is not.
class Slack
{
public:
  Slack(const Machine& machine, const Criterion& criterion) : machine_(machine), criterion_(criterion)
  {
    const Standing zero = *standingAt(machine, machine.zero());
    zero_ = zero.strut;
  }

  double operator()(const Eigen::Vector3d& p) const
  {
    const auto there = standingAt(machine_, p);
    if (!there || there->det * machine_.aspect() <= 0.0)
      return -1.0;
    const Tool tool(criterion_, there->strut, there->eta);
    double least = 1e3;
    const auto atLeast = [&](ConditionKind kind, double bound) {
      if (bound > 0.0)
        least = std::min(least, tool.valueOf(kind) / bound - 1.0);
    };
    const auto atMost = [&](double value, double bound) {
      if (bound > 0.0)
        least = std::min(least, 1.0 - value / bound);
    };
    atLeast(ConditionKind::TOOL_SPEED_MIN, criterion_.tool_speed_min);
    atLeast(ConditionKind::TOOL_FORCE_MIN, criterion_.tool_force_min);
    atLeast(ConditionKind::STIFFNESS_MIN, criterion_.stiffness_min);
    atLeast(ConditionKind::STRUT_ANGLE_MIN, criterion_.strut_angle_min);
    if (criterion_.position_error_max > 0.0)
      atMost(tool.valueOf(ConditionKind::POSITION_ERROR_MAX), criterion_.position_error_max);
    atMost(tool.valueOf(ConditionKind::STRUT_ANGLE_MAX), criterion_.strut_angle_max);
    for (std::size_t i = 0; i < 3; ++i)
    {
      atMost(tilt(*there, i), criterion_.ball_tilt_max);
      atMost(tilt(*there, i), criterion_.ball_tilt_max > 0.0 ? criterion_.strut_tilt_max[i] : 0.0);
    }
    if (criterion_.set == Criterion::Set::DEXTROUS)
    {
      const auto psi = transmissionFactors(*jacobians(machine_, p));
      least = std::min({ least, psi[0] / criterion_.psi_min - 1.0, 1.0 - psi[2] / criterion_.psi_max });
    }
    return least;
  }

private:
  double tilt(const Standing& there, std::size_t i) const
  {
    const Tool::Vector &a = zero_[i], &b = there.strut[i];
    const double cosine = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / (length(a) * length(b));
    return std::acos(std::min(1.0, cosine));
  }

  const Machine& machine_;
  const Criterion& criterion_;
  Tool::Matrix zero_;
};

LargestRegion largestCube(const Machine& machine, const Criterion& criterion, double accuracy)
{
  RegionQuery query;
  query.shape = makeShape("cube", std::nullopt);
  query.criterion = criterion;
  query.accuracy = accuracy * machine.scale();
  if (machine.hasParallelRails())
    query.shape = makeShape("square", std::nullopt);
  return findLargestRegion(machine, query);
}

Eigen::Vector3d unitVector(Random& random)
{
  Eigen::Vector3d v;
  do
    v = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0) };
  while (v.norm() > 1.0 || v.norm() < 0.1);
  return v.normalized();
}

Tool::Vector scaled(double factor, const Eigen::Vector3d& v)
{
  return { factor * v.x(), factor * v.y(), factor * v.z() };
}

/// Whether one direction at one point breaks nothing, up to the rounding of this check.
void expectHeld(const Tool& tool, const Criterion& criterion, const Eigen::Vector3d& direction)
{
  constexpr double ROUNDING = 1.0 + 1e-12;
  const auto speeds = tool.jointSpeeds(scaled(criterion.tool_speed_min, direction));
  const auto forces = tool.jointForces(scaled(criterion.tool_force_min, direction));
  for (std::size_t i = 0; i < 3; ++i)
  {
    ASSERT_LE(std::abs(speeds[i]), criterion.joint_speed_max[i] * ROUNDING);
    ASSERT_LE(std::abs(forces[i]), criterion.joint_effort_max[i] * ROUNDING);
  }
  if (criterion.stiffness_min > 0.0)  // compliance: the part of the way along the force
  {
    const auto way = tool.deflection(scaled(1.0, direction));
    ASSERT_LE(way[0] * direction.x() + way[1] * direction.y() + way[2] * direction.z(),
              ROUNDING / criterion.stiffness_min);
  }
}

void expectErrorsHeld(const Tool& tool, const Criterion& criterion)
{
  for (int signs = 0; criterion.position_error_max > 0.0 && signs < 8; ++signs)
  {
    Tool::Vector joints;
    for (std::size_t i = 0; i < 3; ++i)
      joints[i] = ((signs >> i) & 1) != 0 ? criterion.joint_error_max[i] : -criterion.joint_error_max[i];
    ASSERT_LE(length(tool.error(joints)), criterion.position_error_max * (1.0 + 1e-12));
  }
}

/// Where a strut lies along its rail: within the region, as shares of its half sides.
std::vector<Eigen::Vector3d> alongRails(const Machine& machine, const Eigen::Vector3d& center,
                                        const Eigen::Vector3d& half)
{
  std::vector<Eigen::Vector3d> shares;
  for (int leg = 0; leg < 3; ++leg)
    for (int step = -20; step <= 20; ++step)
    {
      const Eigen::Vector3d foot = mid(machine.center(leg));
      const Eigen::Vector3d e = mid(slidingStrut(machine.leg(leg)).axis);
      const Eigen::Vector3d p = foot + (e.dot(center - foot) + 0.05 * step * 2.0 * half.maxCoeff()) * e;
      const Eigen::Vector3d share = (p - center).cwiseQuotient(half.cwiseMax(1e-300));
      shares.push_back(share.cwiseMax(-1.0).cwiseMin(1.0));
    }
  return shares;
}

/// The worst point of a region that is looked for from its corners, where struts lie along rails, and from anywhere,
/// downhill.
double worstOf(const Machine& machine, const Shape& shape, double size, const Eigen::Vector3d& center,
               const Slack& slack, Random& random)
{
  const Eigen::Vector3d half = shape.halfExtents().per_size * size;
  double worst = 1e4;
  const auto look = [&](const Eigen::Vector3d& share) {
    const double value = slack(center + half.cwiseProduct(share));
    const bool is_worse = value < worst;
    worst = std::min(worst, value);
    return is_worse;
  };
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (const double x : { -1.0, 1.0 })
    for (const double y : { -1.0, 1.0 })
      for (const double z : { -1.0, 1.0 })
        if (look({ x, y, z }))
          at = { x, y, z };
  for (const Eigen::Vector3d& share : alongRails(machine, center, half))
    if (look(share))
      at = share;
  double step = 0.5;
  for (int k = 0; worst > 0.0 && k < 400; ++k)
  {
    const Eigen::Vector3d next = (at + step * unitVector(random)).cwiseMax(-1.0).cwiseMin(1.0);
    if (look(next))
      at = next;
    else
      step = std::max(1e-6, 0.98 * step);
  }
  return worst;
}
}  // namespace

TEST(DrivenRegion, holdsAtItsPointsInEveryDirection)
{
  for (const Machine& machine : threeMachines())
    for (const auto& [name, criterion] : drivenCriteria(machine))
    {
      SCOPED_TRACE(machine.name() + ", " + name + ", seed " + std::to_string(SEED));
      const LargestRegion region = largestCube(machine, criterion, 1e-3);
      if (region.size == 0.0)
        continue;
      const Slack slack(machine, criterion);
      Random random(SEED);
      const Eigen::Vector3d half = region.shape->halfExtents().per_size * region.size;
      for (int k = 0; k < cases(2000) && !testing::Test::HasFailure(); ++k)
      {
        const Eigen::Vector3d share(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        const Eigen::Vector3d p =
            region.center + half.cwiseProduct(k % 8 == 0 ? Eigen::Vector3d(share.cwiseSign()) : share);
        ASSERT_GE(slack(p), -1e-12) << p.transpose();
        const Standing there = *standingAt(machine, p);
        const Tool tool(criterion, there.strut, there.eta);
        for (int n = 0; n < 100; ++n)
          expectHeld(tool, criterion, unitVector(random));
        expectErrorsHeld(tool, criterion);
      }
    }
}

TEST(DrivenRegion, noneIsLargerThanItsUpperBound)
{
  int found = 0;
  for (const Machine& machine : threeMachines())
    for (const auto& [name, criterion] : drivenCriteria(machine))
    {
      SCOPED_TRACE(machine.name() + ", " + name + ", seed " + std::to_string(SEED));
      const LargestRegion region = largestCube(machine, criterion, 1e-3);
      ASSERT_LE(region.size_upper_bound - region.size, 1e-3 * machine.scale()) << region.message;
      found += region.size > 0.0;
      const Slack slack(machine, criterion);
      Random random(SEED);
      for (int k = 0; k < cases(100); ++k)
      {
        const double away = machine.scale() * std::pow(10.0, random.uniform(-5.0, -0.3));
        Eigen::Vector3d center = region.center;
        for (int axis = 0; axis < 3; ++axis)
          center[axis] += random.uniform(-away, away);
        ASSERT_LT(worstOf(machine, *region.shape, 1.000001 * region.size_upper_bound, center, slack, random), 1e-9)
            << center.transpose();
      }
    }
  EXPECT_GE(found, 22) << "most of the criteria have a region";
}
}  // namespace test
}  // namespace pkm_workspace
