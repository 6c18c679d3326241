// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/fitting_bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

Machine calibratedDelta()
{
  return readUrdfFile(PKM_WORKSPACE_SOURCE_DIR "/test/data/equal_homes.urdf").machine;
}
}  // namespace

// The factors are 1 where its struts are at right angles: the paper's bounds are twice as wide.
TEST(FittingBounds, ofTheOrthoglideAreThePapers)
{
  const auto bounds = fittingBounds(orthoglide(), defaultCriterion());
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->psi_min, 0.5);
  EXPECT_EQ(bounds->psi_max, 2.0);
  EXPECT_LT(bounds->point.norm(), 1e-12);
  EXPECT_EQ(remarkOnDefaultBounds(orthoglide(), defaultCriterion(), "--psi auto"), "");
}

// A vertical move takes all three sliders: psi_3 is never below the square root of 3.
TEST(FittingBounds, ofALinearDeltaHoldInItsMiddle)
{
  const Machine delta = calibratedDelta();
  const auto bounds = fittingBounds(delta, defaultCriterion());
  ASSERT_TRUE(bounds);
  EXPECT_GT(bounds->psi[2], std::sqrt(3.0) - 1e-9);
  EXPECT_NEAR(bounds->psi_max, 2.0 * std::max(bounds->psi[2], 1.0 / bounds->psi[0]), 0.1);
  EXPECT_LE(bounds->psi_min * bounds->psi_max, 1.0 + 1e-12);
  EXPECT_GT(bounds->psi_min * bounds->psi_max, 0.95);
  Criterion fitting = defaultCriterion();
  EXPECT_EQ(chooseBounds(delta, fitting).psi_max, fitting.psi_max);
  EXPECT_EQ(remarkOnDefaultBounds(delta, fitting, "--psi auto"), "");
  const std::string remark = remarkOnDefaultBounds(delta, defaultCriterion(), "--psi auto");
  EXPECT_NE(remark.find("the default bounds of psi, [0.5, 2], suit the paper's machines; the middle of this one, "),
            std::string::npos)
      << remark;
  EXPECT_NE(remark.find("its factors are 0.489 to 1.73 there. --psi auto asks for [0.25, 3.9]"), std::string::npos)
      << remark;
}

// Where zones leave the middle out, the bounds are those of what is left.
TEST(FittingBounds, heedZones)
{
  Criterion criterion = defaultCriterion();
  const double anywhere = fittingBounds(uranesx(), criterion)->psi_max;
  Zone zone;
  zone.use = Zone::Use::KEEP_IN;
  zone.kind = ZoneKind::HALF_SPACE;
  zone.pose.translation = Vector3d(0.35, 0.0, 0.0);
  zone.normal = Vector3d(1.0, 0.0, 0.0);
  criterion.zones = { zone };
  const auto there = fittingBounds(uranesx(), criterion);
  ASSERT_TRUE(there);
  EXPECT_GE(there->point.x(), 0.35 - 1e-9);
  EXPECT_GT(there->psi_max, anywhere);
  criterion.zones[0].pose.translation.x() = 9.0;
  EXPECT_FALSE(fittingBounds(uranesx(), criterion));
  test::expectThrow<std::invalid_argument>([&] { chooseBounds(uranesx(), criterion); }, "all other conditions, zones");
}

// No point of a crowd has factors nearer to 1 than the best point, but for the last steps of its search.
TEST(FittingBounds, ofTheBestPointThereIs)
{
  Random random(SEED);
  SCOPED_TRACE(SEED);
  for (const Machine& machine : { calibratedDelta(), uranesx(), orthoglidePrototype() })
  {
    const auto bounds = fittingBounds(machine, defaultCriterion());
    ASSERT_TRUE(bounds);
    const double least = std::max(bounds->psi[2], 1.0 / bounds->psi[0]);
    for (int k = 0; k < cases(2000); ++k)
    {
      const auto some = [&] { return random.uniform(-machine.scale(), machine.scale()); };
      const Vector3d p = machine.zero() + Vector3d(some(), some(), some());
      const auto joints = inverseKinematics(machine, p);
      const auto at = jacobians(machine, p);
      bool counts = joints && at && machine.aspect() * at->a.determinant() > 0.0;
      for (int i = 0; counts && i < 3; ++i)
        counts = machine.leg(i).limits.contains((*joints)[i]);
      if (!counts)
        continue;
      const Vector3d psi = transmissionFactors(*at);
      EXPECT_GT(std::max(psi[2], 1.0 / psi[0]), 0.98 * least) << machine.name() << " at " << p.transpose();
    }
  }
}
}  // namespace test
}  // namespace pkm_workspace
