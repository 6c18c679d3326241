// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/characteristic_polynomial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/dexterity/region_check.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

Box cubeAt(const Eigen::Vector3d& center, double edge)
{
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(edge / 2);
  return { center - half, center + half };
}

/// A little more than the reachable points.
Box spaceOf(const Machine& machine)
{
  return cubeAt(machine.zero(), 2.6 * machine.scale());
}

std::vector<Criterion> everyCriterion()
{
  std::vector<Criterion> criteria(4);
  criteria[1].psi_min = 0.05;
  criteria[1].psi_max = 8.0;
  criteria[2].aspect = Criterion::Aspect::OTHER;
  criteria[3].aspect = Criterion::Aspect::BOTH;
  return criteria;
}

/// Every kind of machine, and the Orthoglide on the other side of its parallel singularity.
std::vector<Machine> machines()
{
  std::vector<Machine> machines = test::slidingKinds();
  machines.emplace_back("other aspect", orthoglide().legs(), Eigen::Vector3d::Constant(-0.546));
  return machines;
}

/// Draws boxes of all sizes, and hunts in a box for the point that contradicts a verdict most.
class Adversary
{
public:
  Adversary(const Machine& machine, const Criterion& criterion, unsigned seed)
    : model_(machine, criterion)
    , space_(spaceOf(machine))
    , zero_(machine.zero())
    , scale_(machine.scale())
    , random_(seed)
  {}

  /// Half of the boxes are anywhere, the others near the border of the set; some are flat.
  Box box()
  {
    Box box = random_.boxIn(space_, scale_);
    if (random_.between(0.0, 1.0) < 0.5)
      return box;
    const Eigen::Vector3d half_widths = 0.5 * (box.upper - box.lower);
    const Eigen::Vector3d center = borderPoint(random_.pointIn(space_)) + random_.between(-1.0, 1.0) * half_widths;
    box = { center - half_widths, center + half_widths };
    if (random_.between(0.0, 1.0) < 0.2)
      box.upper.x() = box.lower.x();
    return box;
  }

  /// Where the line from the zero configuration to anywhere leaves the set, or a point near there, to some ulps.
  Eigen::Vector3d borderPoint() { return borderPoint(random_.pointIn(space_)); }

  /// A point of the box where the margin is small (for INSIDE) or large, by corners and by random descent.
  Eigen::Vector3d suspect(const Box& box, BoxVerdict verdict)
  {
    const double sign = verdict == BoxVerdict::INSIDE ? 1.0 : -1.0;
    Eigen::Vector3d worst = box.center();
    const auto look = [&](const Eigen::Vector3d& anywhere) {
      const Eigen::Vector3d point = anywhere.cwiseMax(box.lower).cwiseMin(box.upper);
      if (sign * model_.margin(point) < sign * model_.margin(worst))
        worst = point;
    };
    for (int corner = 0; corner < 8; ++corner)
      look({ (corner & 1 ? box.upper : box.lower).x(), (corner & 2 ? box.upper : box.lower).y(),
             (corner & 4 ? box.upper : box.lower).z() });
    for (int step = 0; step < 10; ++step)
    {
      look(random_.pointIn(box));
      look(worst + 0.2 * (random_.pointIn(box) - box.center()));
    }
    return worst;
  }

private:
  Eigen::Vector3d borderPoint(Eigen::Vector3d far) const
  {
    Eigen::Vector3d near = zero_;
    const bool is_good = model_.margin(near) > 0.0;
    for (int step = 0; step < 60; ++step)
    {
      const Eigen::Vector3d middle = 0.5 * (near + far);
      ((model_.margin(middle) > 0.0) == is_good ? near : far) = middle;
    }
    return near;
  }

  BoxTest model_;
  Box space_;
  Eigen::Vector3d zero_;
  double scale_;
  test::RandomBoxes random_;
};

/// @return how many boxes were INSIDE
int expectVerdictsHold(const Machine& machine, const Criterion& criterion, unsigned seed)
{
  const CharacteristicTest test(machine, criterion);
  const BoxTest other_way(machine, criterion);
  const test::Oracle oracle(machine, criterion);
  Adversary adversary(machine, criterion, seed);
  int inside = 0;
  for (int k = 0; k < test::cases(100); ++k)
  {
    const Box box = adversary.box();
    const BoxVerdict verdict = test.classify(box);
    if (verdict == BoxVerdict::UNDECIDED)
      continue;
    inside += verdict == BoxVerdict::INSIDE;
    const Eigen::Vector3d point = adversary.suspect(box, verdict);
    const BoxVerdict opposite = verdict == BoxVerdict::INSIDE ? BoxVerdict::OUTSIDE : BoxVerdict::INSIDE;
    EXPECT_EQ(oracle.isGood(point), verdict == BoxVerdict::INSIDE)
        << machine.name() << ", seed " << seed << ", box " << k << ", point " << point.transpose();
    EXPECT_NE(other_way.classify(box), opposite) << machine.name() << ", seed " << seed << ", box " << k;
  }
  return inside;
}
}  // namespace

TEST(CharacteristicTest, verdictsHoldAtEveryPointOfTheBox)
{
  for (const Machine& machine : machines())
  {
    int inside = 0;
    for (const Criterion& criterion : everyCriterion())
      inside += expectVerdictsHold(machine, criterion, SEED);
    EXPECT_GT(inside, 5) << machine.name() << ": the law was hardly tried";
  }
}

TEST(CharacteristicTest, pointsOnTheBorderAreNotDecidedWrongly)
{
  for (const Machine& machine : machines())
  {
    const CharacteristicTest test(machine, Criterion());
    const test::Oracle oracle(machine, Criterion());
    Adversary adversary(machine, Criterion(), SEED);
    for (int k = 0; k < test::cases(100); ++k)
    {
      const Eigen::Vector3d point = adversary.borderPoint();
      const BoxVerdict wrong = oracle.isGood(point) ? BoxVerdict::OUTSIDE : BoxVerdict::INSIDE;
      EXPECT_NE(test.classify({ point, point }), wrong) << machine.name() << ", seed " << SEED << ", point " << k;
    }
  }
}

TEST(CharacteristicTest, pointsAreDecided)
{
  for (const Machine& machine : machines())
  {
    const CharacteristicTest test(machine, Criterion());
    const test::Oracle oracle(machine, Criterion());
    test::RandomBoxes random(SEED);
    for (int k = 0; k < test::cases(300); ++k)
    {
      const Eigen::Vector3d point = random.pointIn(spaceOf(machine));
      EXPECT_EQ(test.classify({ point, point }), oracle.isGood(point) ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE)
          << machine.name() << ", seed " << SEED << ", point " << point.transpose();
    }
  }
}

// docs/values.md: the diagonal of the Orthoglide is dextrous from k = -1/4 to k = 1/2, t = k / sqrt(1 + 2 k^2). At k =
// 1/2 sigma_min is a double eigenvalue: P has a double zero and its derivatives vanish.
TEST(CharacteristicTest, diagonalOfTheOrthoglideEndsWhereItIsKnownTo)
{
  const CharacteristicTest test(orthoglide(), Criterion());
  for (const double k : { -0.25, 0.5 })
  {
    const double outward = k > 0.0 ? 1e-7 : -1e-7;
    const Eigen::Vector3d end = Eigen::Vector3d::Constant(k / std::sqrt(1.0 + 2.0 * k * k));
    const Eigen::Vector3d in = end.array() - outward;
    const Eigen::Vector3d out = end.array() + outward;
    EXPECT_EQ(test.classify({ in, in }), BoxVerdict::INSIDE) << k;
    EXPECT_EQ(test.classify({ out, out }), BoxVerdict::OUTSIDE) << k;
    EXPECT_EQ(test.classify({ in.cwiseMin(out), in.cwiseMax(out) }), BoxVerdict::UNDECIDED) << k;
  }
}

// P alone would call boxes valid through which a strut ceases to reach.
TEST(CharacteristicTest, reachIsPartOfTheVerdict)
{
  Criterion almost_anything;
  almost_anything.psi_min = 1e-8;
  almost_anything.psi_max = 1e8;
  const CharacteristicTest test(orthoglide(), almost_anything);
  test::RandomBoxes random(SEED);
  for (int k = 0; k < test::cases(200); ++k)
  {
    const double angle = random.between(0.0, 6.3);
    const Eigen::Vector3d border(0.05, std::cos(angle), std::sin(angle));
    EXPECT_NE(test.classify(cubeAt(border, std::pow(10.0, random.between(-12.0, -1.0)))), BoxVerdict::INSIDE) << angle;
  }
}

// docs/values.md: another piece of the set, with det A < 0, around -0.546 on the diagonal.
TEST(CharacteristicTest, otherAspectIsNotMixedIn)
{
  const Box box = cubeAt(Eigen::Vector3d::Constant(-0.545923012), 0.06);
  const auto share = [&box](Criterion::Aspect aspect) {
    Criterion criterion;
    criterion.aspect = aspect;
    return verifyBox(CharacteristicTest(orthoglide(), criterion), box, 1e-4, 100000);
  };
  EXPECT_EQ(share(Criterion::Aspect::OWN), Share::NONE);
  EXPECT_EQ(share(Criterion::Aspect::OTHER), Share::ALL);
  EXPECT_EQ(share(Criterion::Aspect::BOTH), Share::ALL);
}

TEST(CharacteristicTest, verifiesTheLargestCubeByItsParts)
{
  int looks = 0;
  const CharacteristicTest test(orthoglide(), Criterion());
  const auto share = [&](double edge) {
    looks = 0;
    const auto classify = [&](const Box& box) {
      ++looks;
      return test.classify(box);
    };
    return verifyBox(classify, cubeAt(Eigen::Vector3d::Constant(0.086273015), edge), 1e-6, 100000);
  };
  EXPECT_EQ(share(0.6), Share::ALL);
  EXPECT_LT(looks, 3000) << "derivatives make the ranges of P sharp";
  EXPECT_EQ(share(0.6439), Share::ALL);
  EXPECT_EQ(share(0.644), Share::SOME);
  EXPECT_EQ(share(1.8), Share::SOME);
}

TEST(CharacteristicTest, refusesWhatThePolynomialDoesNotKnow)
{
  Criterion criterion;
  criterion.joint_limits = true;
  const auto construct = [&criterion] { CharacteristicTest(orthoglide(), criterion); };
  test::expectThrow<std::invalid_argument>(construct, "knows neither joint limits nor condition");
  criterion = Criterion();
  criterion.set = Criterion::Set::REACHABLE;
  test::expectThrow<std::invalid_argument>(construct, "bounded from both sides");
  criterion.psi_min = -1.0;
  test::expectThrow<std::invalid_argument>(construct, "psi_min = -1 .*must be positive");
}
}  // namespace pkm_workspace
