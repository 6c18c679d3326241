// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/sphere_crossing.h"

#include <gtest/gtest.h>

#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/largest_region.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Number = test::Oracle::Number;
using Vector = test::Oracle::Vector;
using Aspect = Criterion::Aspect;

using test::SEED;

Criterion reachable(Aspect aspect)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = aspect;
  return criterion;
}

Vector between(const Vector3d& a, const Vector3d& b, const Number& t)
{
  return { a.x() + t * (Number(b.x()) - a.x()), a.y() + t * (Number(b.y()) - a.y()),
           a.z() + t * (Number(b.z()) - a.z()) };
}

/// By the definition: whether det A, times the sign that is asked for, is not positive somewhere on the line from a to
/// b, or a strut does not reach. Samples it, and goes down to the least value between samples by golden sections.
bool hasBadPoint(const test::Oracle& oracle, int sign, const Vector3d& a, const Vector3d& b)
{
  constexpr int SAMPLES = 32;
  const auto value = [&](const Number& t) { return Number(sign * oracle.determinant(between(a, b, t))); };
  std::vector<Number> values;
  for (int k = 0; k <= SAMPLES; ++k)
  {
    if (!oracle.isGood(between(a, b, Number(k) / SAMPLES)))
      return true;
    values.push_back(value(Number(k) / SAMPLES));
  }
  const Number golden = (sqrt(Number(5)) - 1) / 2;
  for (int k = 0; k <= SAMPLES; ++k)
  {
    const int before = std::max(k - 1, 0);
    const int after = std::min(k + 1, SAMPLES);
    const auto valueAt = [&values](int index) { return values[static_cast<std::size_t>(index)]; };
    if (valueAt(k) > valueAt(before) || valueAt(k) > valueAt(after))
      continue;
    Number low = Number(before) / SAMPLES;
    Number high = Number(after) / SAMPLES;
    while (high - low > 1e-30)
    {
      const Number width = golden * (high - low);
      if (value(high - width) < value(low + width))
        high = low + width;
      else
        low = high - width;
    }
    if (value(low) < 1e-50)
      return true;
  }
  return false;
}

ContainmentResult check(const Machine& machine, Aspect aspect, const Vector3d& center, double edge)
{
  return checkContainment(BoxTest(machine, reachable(aspect)), *makeCube(), center, edge, 20000);
}
}  // namespace

// Of the cube's points, det A is least on the diagonal, where it is 0 at p = (1, 1, 1) / sqrt 3 and positive beside it.
TEST(SphereCrossing, aCubeOnBothSidesIsOutside)
{
  const double on_sphere = 1.0 / std::sqrt(3.0);
  for (const double edge : { 1e-3, 0.01, 0.1 })
  {
    const ContainmentResult found = check(orthoglide(), Aspect::OWN, Vector3d::Constant(on_sphere), edge);
    ASSERT_EQ(found.verdict, Containment::OUTSIDE) << edge;
    EXPECT_GT(found.bad_within, 0.0);
    EXPECT_LT(found.bad_within, 1e-14);
    EXPECT_NEAR(found.bad_point->norm(), 1.0, found.bad_within + 1e-15);
    EXPECT_LE((*found.bad_point - Vector3d::Constant(on_sphere)).cwiseAbs().maxCoeff(), 0.5 * edge + 1e-15);
    EXPECT_EQ(check(orthoglide(), Aspect::BOTH, Vector3d::Constant(on_sphere), edge).verdict, Containment::INSIDE);
  }
}

TEST(SphereCrossing, aCubeOnOneSideIsInside)
{
  const double on_sphere = 1.0 / std::sqrt(3.0);
  EXPECT_EQ(check(orthoglide(), Aspect::OWN, Vector3d::Constant(on_sphere - 0.0501), 0.1).verdict, Containment::INSIDE);
  EXPECT_EQ(check(orthoglide(), Aspect::OWN, Vector3d::Constant(on_sphere + 0.0501), 0.1).verdict, Containment::INSIDE);
}

// A machine without the identity may pass: with one strut a little longer det A stays positive on the way.
TEST(SphereCrossing, whatIsNotExactlyZeroMayBePassed)
{
  Machine::Legs legs = orthoglide().legs();
  int passed = 0;
  for (const double longer : { -0.02, 0.02 })
  {
    for (Leg& leg : legs)
      slidingStrut(leg).length = 1.0;
    slidingStrut(legs[0]).platform = enclose(Vector3d(0.0, longer, 0.0));
    slidingStrut(legs[1]).platform = enclose(Vector3d(0.0, 0.0, longer));
    slidingStrut(legs[2]).platform = enclose(Vector3d(longer, 0.0, 0.0));
    const Machine machine("shifted", legs, Vector3d::Zero());
    const Vector3d low = Vector3d::Constant(0.55);
    const Vector3d high = Vector3d::Constant(0.6);
    const bool is_bad = hasBadPoint(test::Oracle(machine, reachable(Aspect::OWN)), machine.aspect(), low, high);
    const ContainmentResult found = checkContainment(BoxTest(machine, reachable(Aspect::OWN)),
                                                     *makeBox({ 0.05, 0.05, 0.05 }), 0.5 * (low + high), 1.0);
    passed += found.verdict == Containment::INSIDE;
    EXPECT_FALSE(is_bad && found.verdict == Containment::INSIDE) << longer;
  }
  EXPECT_EQ(passed, 2);
}

// Verdicts against the definition, for random cubes and aspects.
TEST(SphereCrossing, verdictsHoldByTheDefinition)
{
  test::RandomBoxes random(SEED);
  int crossings = 0;
  for (int k = 0; k < test::cases(60); ++k)
  {
    const Aspect aspect = k % 3 == 2 ? Aspect::OTHER : Aspect::OWN;
    const Vector3d center = random.pointIn({ Vector3d::Constant(k % 2 ? 0.45 : -0.2), Vector3d::Constant(0.65) });
    const double edge = 0.4 * std::abs(random.pointIn({ Vector3d::Zero(), Vector3d::Ones() }).x()) + 0.01;
    const ContainmentResult found = check(orthoglide(), aspect, center, edge);
    if (found.verdict == Containment::UNDECIDED)
      continue;
    const test::Oracle oracle(orthoglide(), reachable(aspect));
    const int sign = aspect == Aspect::OTHER ? -1 : 1;
    SCOPED_TRACE("seed " + std::to_string(SEED) + ", cube " + std::to_string(k));
    if (found.verdict == Containment::OUTSIDE)
    {
      crossings += found.bad_within > 0.0;
      const Number det = abs(oracle.determinant(between(*found.bad_point, *found.bad_point, 0)));
      EXPECT_TRUE(found.bad_within == 0.0 ? !oracle.isGood(*found.bad_point) : det < 1e-20);
      continue;
    }
    const Vector3d half = Vector3d::Constant(0.5 * edge * (1.0 - 1e-12));
    const Box cube{ center - half, center + half };
    for (int line = 0; line < 3; ++line)
      EXPECT_FALSE(hasBadPoint(oracle, sign, random.pointIn(cube), random.pointIn(cube)));
    EXPECT_FALSE(hasBadPoint(oracle, sign, cube.lower, cube.upper));
  }
  EXPECT_GT(crossings, 0);
}

// The largest reachable cube of one aspect: closed on both sides, and no larger cube is good by the definition.
TEST(SphereCrossing, theLargestReachableCubeIsProved)
{
  for (const Aspect aspect : { Aspect::OWN, Aspect::OTHER })
  {
    RegionQuery query;
    query.criterion = reachable(aspect);
    query.budget.max_boxes = 100000;
    const LargestRegion found = findLargestRegion(orthoglide(), query);
    ASSERT_EQ(found.status, LargestRegion::Status::PROVEN) << found.message;
    const test::Oracle oracle(orthoglide(), query.criterion);
    const int sign = aspect == Aspect::OTHER ? -1 : 1;
    const auto corner = [](const Vector3d& center, double edge, int k) {
      return Vector3d(center + 0.5 * edge * Vector3d(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
    };
    for (int k = 0; k < 8; ++k)
      EXPECT_FALSE(hasBadPoint(oracle, sign, found.center, corner(found.center, found.size * (1.0 - 1e-12), k)));
    test::RandomBoxes random(SEED);
    for (int k = 0; k < test::cases(60); ++k)
    {
      const Vector3d away = random.pointIn({ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) });
      const Vector3d center = k == 0 ? found.center : Vector3d(found.center + (k % 2 ? 0.01 : 1.0) * away);
      bool is_bad = false;
      for (int c = 0; c < 8 && !is_bad; ++c)
        is_bad = hasBadPoint(oracle, sign, center, corner(center, found.size_upper_bound * (1.0 + 1e-12), c));
      EXPECT_TRUE(is_bad) << "seed " << SEED << ", center " << center.transpose();
    }
  }
}
}  // namespace pkm_workspace
