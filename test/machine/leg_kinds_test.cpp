// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "pkm_workspace/interval/angle_form.h"
#include "support/closed_leg.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;
using Number = ClosedLeg::Number;

/// Seeded points near the zero configuration that all legs reach away from singularities.
template <class Check>
void forEachReachedPoint(const Machine& machine, const Check& check)
{
  int found = 0;
  for (int seed = 0; found < cases(1000) && seed < cases(40000) && !testing::Test::HasFailure(); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const double reach = machine.scale();
    const Vector3d p = machine.zero() + Vector3d(random.uniform(-reach, reach), random.uniform(-reach, reach),
                                                 random.uniform(-reach, reach));
    const auto matrices = jacobians(machine, p);
    if (!matrices || singularityMeasures(*matrices).serial < 0.05 || singularityMeasures(*matrices).parallel < 0.05)
      continue;
    ++found;
    SCOPED_TRACE(machine.name() + ", seed " + std::to_string(seed));
    check(p, *matrices, random);
  }
  EXPECT_EQ(found, cases(1000)) << machine.name() << ": too few points are regular";
}

std::array<ClosedLeg, 3> closedAt(const Machine& machine, const ClosedLeg::Vector& p)
{
  return { legAt(machine.leg(0), p), legAt(machine.leg(1), p), legAt(machine.leg(2), p) };
}

ClosedLeg::Vector exactly(const Vector3d& p)
{
  return { p.x(), p.y(), p.z() };
}

bool holds(const Interval& x, const Number& value)
{
  return x.lower() <= value && value <= x.upper();
}
}  // namespace

TEST(LegKinds, enclosuresHoldTheLoopsThatAreClosedByTriangles)
{
  for (const Machine& machine : otherLegs())
    forEachReachedPoint(machine, [&](const Vector3d& p, const Jacobians&, Random&) {
      const auto there = configurationAt(machine, p);
      ASSERT_TRUE(there);
      const auto legs = closedAt(machine, exactly(p));
      for (std::size_t i = 0; i < 3; ++i)
      {
        // directions are enclosures of unit vectors, of which the oracle takes one: all within some roundings
        const double slack = 1e-14 * machine.scale();
        const auto isNear = [&](const Interval& x, const Number& value) {
          return holds(x + Interval(-slack, slack), value) && x.width() < 1e-11 * machine.scale();
        };
        EXPECT_TRUE(legs[i].reaches);
        EXPECT_TRUE(isNear(there->rho[i], legs[i].joint)) << there->rho[i] << ' ' << legs[i].joint;
        EXPECT_TRUE(isNear(there->eta[i], legs[i].drive)) << there->eta[i] << ' ' << legs[i].drive;
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_TRUE(isNear(there->strut[i][k], legs[i].row[k])) << there->strut[i][k] << ' ' << legs[i].row[k];
      }
    });
}

namespace
{
/// x of a forearm that is within an angle of the way of the tip, drawn from the definition.
Vector3d drawn(const Crank& crank, double angle, double least_cosine, Random& random)
{
  const Vector3d u = mid(crank.along), v = mid(crank.across);
  const Vector3d tip = std::cos(angle) * u + std::sin(angle) * v;
  const Vector3d way = crank.working_mode * (std::cos(angle) * v - std::sin(angle) * u);
  const double cosine = random.once(2) ? least_cosine : random.uniform(least_cosine, 1.0);
  const double turn = random.uniform(-M_PI, M_PI);
  const Vector3d forearm =
      cosine * way + std::sqrt(1.0 - cosine * cosine) * (std::cos(turn) * tip + std::sin(turn) * u.cross(v));
  return crank.radius.mid() * tip + crank.length.mid() * forearm;
}

void expectBoundsOfWhatItReaches(const Leg& leg, const std::optional<Interval>& steepest, const Interval& joints)
{
  const auto& crank = std::get<Crank>(leg.kind);
  const IntervalVector bounds = pointsWithin(enclosed(crank), joints, steepest);
  const double reach = outerBound(enclosed(crank), steepest).radius.upper();
  const double least_cosine = steepest ? std::min(1.0, 1.0 / (steepest->mid() * gearOf(leg).mid())) : 0.0;
  Box seen{ Vector3d::Constant(INF), Vector3d::Constant(-INF) };
  double farthest = 0.0;
  Random random(1);
  for (int sample = 0; sample < cases(5000); ++sample)
  {
    const double angle = joints.isBounded() ? random.uniform(joints.lower(), joints.upper())
                                            : random.uniform(-M_PI, M_PI) + crank.reference;
    const Vector3d x = drawn(crank, angle, least_cosine, random);
    const Vector3d point = mid(crank.pivot) - mid(crank.platform) + x;
    seen = { seen.lower.cwiseMin(point), seen.upper.cwiseMax(point) };
    farthest = std::max(farthest, x.norm());
  }
  EXPECT_LE(farthest, reach + 1e-12);
  EXPECT_GE(farthest, reach - 0.05);
  for (int k = 0; k < 3; ++k)
  {
    const Interval& bound = bounds[static_cast<std::size_t>(k)];
    EXPECT_LE(bound.lower(), seen.lower[k] + 1e-12);
    EXPECT_GE(bound.upper(), seen.upper[k] - 1e-12);
    EXPECT_NEAR(bound.lower(), seen.lower[k], 0.25);
    EXPECT_NEAR(bound.upper(), seen.upper[k], 0.25);
  }
}
}  // namespace

TEST(LegKinds, boundsOfCranksHoldWhatTheyReach)
{
  for (const Machine& machine : { delta(), crookedMix(4), crookedMix(7) })
    for (const int mode : { 1, -1 })
      for (const double steepest : { 0.0, 2.0, 1.01 })
        for (const Interval& joints : { Interval::entire(), Interval(-0.6, 1.5), Interval(0.3) })
        {
          SCOPED_TRACE(machine.name() + ", mode " + std::to_string(mode) + ", steepest " + std::to_string(steepest));
          Leg leg = machine.leg(2);
          std::get<Crank>(leg.kind).working_mode = mode;
          expectBoundsOfWhatItReaches(leg, steepest > 0.0 ? std::make_optional(Interval(steepest)) : std::nullopt,
                                      joints);
        }
}

// A pdot = B qdot, and J qdot = pdot: by differences of the inverse and of the forward kinematics.
TEST(LegKinds, jacobiansAreDerivativesBothWays)
{
  for (const Machine& machine : otherLegs())
    forEachReachedPoint(machine, [&](const Vector3d& p, const Jacobians& matrices, Random& random) {
      const Vector3d velocity(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const Number step = 1e-30;
      const auto moved = [&](const Number& by) {
        ClosedLeg::Vector q = exactly(p);
        for (std::size_t k = 0; k < 3; ++k)
          q[k] += by * velocity[static_cast<Eigen::Index>(k)];
        return closedAt(machine, q);
      };
      const auto ahead = moved(step), behind = moved(-step);
      Vector3d drives;
      for (std::size_t i = 0; i < 3; ++i)
        drives[static_cast<Eigen::Index>(i)] =
            Number(scaleOf(machine.legs()[i]) * (ahead[i].joint - behind[i].joint) / (2 * step)).convert_to<double>();
      const Vector3d wanted = matrices.j_inverse * velocity;
      ASSERT_LE((wanted - drives).norm(), 1e-9 * (1.0 + wanted.norm()));
      ASSERT_LE((matrices.j * drives - velocity).norm(), 1e-8 * (1.0 + matrices.j.norm() * drives.norm()));
      const auto joints = inverseKinematics(machine, p);
      ASSERT_TRUE(joints);
      Vector3d turned = *joints;
      const double small = 1e-6;
      for (int i = 0; i < 3; ++i)
        turned[i] += small * drives[i] / driveScale(machine.leg(i)).mid();
      const auto reached = forwardKinematics(machine, turned);
      if (reached && matrices.a.determinant() * machine.aspect() > 0.0)
      {
        ASSERT_LE((*reached - p - small * velocity).norm(),
                  1e-10 * machine.scale() * std::pow(matrices.j.norm() + 1, 3));
      }
    });
}

TEST(LegKinds, assembliesAreTheRightOneOrNone)
{
  for (const Machine& machine : otherLegs())
  {
    forEachReachedPoint(machine, [&](const Vector3d& p, const Jacobians& matrices, Random&) {
      const auto joints = inverseKinematics(machine, p);
      ASSERT_TRUE(joints);
      const auto back = forwardKinematics(machine, *joints);
      const bool is_own = matrices.a.determinant() * machine.aspect() > 0.0;
      if (!is_own)
        return;
      ASSERT_TRUE(back);
      ASSERT_LE((*back - p).norm(), 1e-10 * machine.scale());
    });
  }
  EXPECT_FALSE(forwardKinematics(tripod(), Vector3d(0.0, 0.0, 100.0))) << "its struts do not meet";
  EXPECT_FALSE(forwardKinematics(delta(), Vector3d::Constant(-M_PI / 2.0))) << "its cranks point upward";
}

TEST(LegKinds, whatIsNoLegIsRefused)
{
  const auto changed = [](const Machine& machine, const auto& change) {
    return [&machine, change] {
      Machine::Legs legs = machine.legs();
      change(legs[1]);
      return Machine(machine.name(), legs, machine.zero());
    };
  };
  const Machine rotary = delta(), standing = tripod();
  const auto crank = [&](const auto& change) {
    return changed(rotary, [change](Leg& leg) { change(std::get<Crank>(leg.kind), leg); });
  };
  using test::expectThrow;
  using Refused = std::invalid_argument;
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.radius = 0.0; }), "leg 'crank_2': crank radius .* from 1e-9 m");
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.length = -1.0; }),
                       "forearm length .* must be from 1e-9 m to 1e9 m");
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.along[2] = 0.5; }),
                       "directions of its crank must have unit length");
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.across = c.along; }), "must be across each other");
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.working_mode = 0; }), "working mode 0 must be \\+1 or -1");
  expectThrow<Refused>(crank([](Crank& c, Leg&) { c.drive_scale = -1.0; }), "drive scale -1 m must be");
  expectThrow<Refused>(crank([](Crank&, Leg& leg) { leg.limits = { 0.0, INF }; }), "must have both ends, or none");
  expectThrow<Refused>(crank([](Crank&, Leg& leg) { leg.limits = { -4.0, 1.0 }; }), "within pi of its reference 0 rad");
  expectThrow<Refused>(changed(standing,
                               [](Leg& leg) {
                                 leg.limits = { -0.9, 0.0 };
                               }),
                       "leg 'strut_2': at its lower joint limit -0.9 m its strut of 0.8 m has no length left");
  expectThrow<Refused>(changed(standing, [](Leg& leg) { std::get<TelescopicStrut>(leg.kind).length = 0.0; }),
                       "at joint value 0 must be from 1e-9 m");
  Machine::Legs legs = rotary.legs();
  StrutTolerance tolerance;
  tolerance.length = 1e-4;
  expectThrow<Refused>([&] { setTolerance(tolerance, legs[0]); },
                       "leg 'crank_1' is no strut of fixed length on a slider");
}

TEST(AngleForm, holdsTheArcTangentOfEveryMember)
{
  for (int seed = 0; seed < cases(1000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    AffineForm<double> f;
    f.gradient[0] = std::ldexp(1.0, random.integer(-20, 3));
    f.center = random.once(2) ? 0.0 : random.uniform(-1.0, 1.0) * f.gradient[0];
    const AffineForm<double> angle = arcTangent(f);
    for (const double delta : { -1.0, 1.0, random.uniform(-1.0, 1.0) })
    {
      const Number exact = atan(Number(f.center) + Number(f.gradient[0]) * delta);
      ASSERT_LE(abs(exact - angle.center - Number(angle.gradient[0]) * delta), Number(angle.radius)) << "seed " << seed;
    }
  }
}

// Angles of directions of boxes, against their corners in 100 digits.
TEST(AngleForm, holdsTheAngleOfEveryDirection)
{
  for (int seed = 0; seed < cases(4000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const auto form = [&](double center, double swing) {
      AffineForm<double> f;
      f.center = center;
      for (double& slope : f.gradient)
        slope = random.uniform(-swing, swing);
      f.radius = random.uniform(0.0, 0.1 * swing);
      return f;
    };
    const double swing = std::pow(10.0, random.uniform(-6.0, 0.0));
    const AffineForm<double> x = form(random.uniform(-1.0, 1.0), swing), y = form(random.uniform(-1.0, 1.0), swing);
    const AffineForm<double> angle = angleOf(x, y);
    for (int sample = 0; sample < 4; ++sample)
    {
      const std::array<double, 3> delta = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                            random.uniform(-1.0, 1.0) };
      const auto at = [&](const AffineForm<double>& f, double error) {
        Number value = Number(f.center) + Number(error) * f.radius;
        for (std::size_t j = 0; j < 3; ++j)
          value += Number(delta[j]) * f.gradient[j];
        return value;
      };
      const double error = random.uniform(-1.0, 1.0);
      const Number exact = atan2(at(y, error), at(x, -error));
      ASSERT_LE(abs(exact - at(angle, 0.0)), Number(angle.radius)) << "seed " << seed;
    }
    const double distance = std::hypot(x.center, y.center);
    const bool is_small = 10.0 * swing < distance && (x.center > 0.0 || std::abs(y.center) > 10.0 * swing);
    if (is_small)
    {
      ASSERT_LE(angle.radius, x.radius / distance + y.radius / distance + 40.0 * std::pow(swing / distance, 2) + 1e-14)
          << "seed " << seed;
    }
  }
}
}  // namespace test
}  // namespace pkm_workspace
