// SPDX-License-Identifier: BSD-3-Clause
// The closed mechanism in tf: it follows poses, rails and the handle of rviz, and stays closed.
#include "mechanism.h"

#include "pkm_workspace/machine/assembly.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
TEST_F(Mechanism, followsPosesAndStaysClosed)
{
  for (const Eigen::Vector3d& p : { NEAR_ZERO, Eigen::Vector3d(-0.03, 0.05, 0.06), Eigen::Vector3d(0.1, 0.0, -0.04) })
  {
    publishPose(p);
    EXPECT_LE(gapOnceAt(p), 1e-9);
  }
}

TEST_F(Mechanism, followsItsRailsByForwardKinematics)
{
  const Machine machine = orthoglidePrototype();
  const auto rho = inverseKinematics(machine, NEAR_ZERO);
  ASSERT_TRUE(rho);
  publishRails(machine, *rho);
  EXPECT_LE(gapOnceAt(NEAR_ZERO), 1e-9);
}

// The same rails carry an assembly in each aspect: det A there has the sign that the node's criterion asks for.
TEST_F(Mechanism, isAssembledInTheAspectThatIsAskedFor)
{
  const Machine machine = orthoglidePrototype();
  const auto rho = inverseKinematics(machine, NEAR_ZERO);
  const auto other = assemble(machine, *rho, -machine.aspect());
  ASSERT_TRUE(other);
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  setAspect(CriterionRequest::OTHER);
  markers("tool_markers",
          [](const auto& found) { return hasText(found, "det A does not have the sign of the aspect"); });
  publishRails(machine, *rho);
  EXPECT_LE(gapOnceAt(*other), 1e-9);
  const auto there = configurationAt(machine, *other);
  ASSERT_TRUE(there);
  EXPECT_TRUE((Interval(machine.aspect()) * there->det_a).certainlyNegative());
  setAspect(CriterionRequest::OWN);
  publishRails(machine, *rho);
  EXPECT_LE(gapOnceAt(NEAR_ZERO), 1e-9);
}

TEST_F(Mechanism, followsTheHandleAndShowsItsMargin)
{
  drag("tool", NEAR_ZERO);
  EXPECT_LE(gapOnceAt(NEAR_ZERO), 1e-9);
  const auto shown = markers("tool_markers", [](const std::vector<Marker>& found) {
    return std::abs(named(found, "ellipsoid").pose.position.x - NEAR_ZERO.x()) < 1e-9;
  });
  EXPECT_GT(named(shown, "ellipsoid").color.g, named(shown, "ellipsoid").color.r) << "not green near the middle";
  EXPECT_GT(named(shown, "ellipsoid").scale.x, 0.0);
  EXPECT_EQ("", textOf(shown, "reason"));
  EXPECT_EQ(0U, textOf(shown, "nearest").find("nearest limit: ")) << textOf(shown, "nearest");
  const auto rho = inverseKinematics(orthoglidePrototype(), NEAR_ZERO);
  const auto slider = std::find_if(shown.begin(), shown.end(), [](const Marker& marker) {
    return marker.ns == "travel" && marker.type == Marker::SPHERE;
  });
  ASSERT_NE(shown.end(), slider);
  EXPECT_NEAR((*rho)[0] - 0.31058, slider->pose.position.x, 1e-9);
  EXPECT_NEAR(0.0, slider->pose.position.y, 1e-9);
  EXPECT_EQ(6, std::count_if(shown.begin(), shown.end(), [](const Marker& marker) { return marker.ns == "travel"; }));
}

TEST_F(Mechanism, stopsAtTheBorderTurnsRedAndSaysWhy)
{
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  drag("tool", Eigen::Vector3d(2.0, NEAR_ZERO.y(), NEAR_ZERO.z()));
  const auto shown =
      markers("tool_markers", [](const std::vector<Marker>& found) { return !textOf(found, "reason").empty(); });
  EXPECT_GT(named(shown, "ellipsoid").color.r, 2.0F * named(shown, "ellipsoid").color.g);
  EXPECT_NE(std::string::npos, textOf(shown, "reason").find("parallel singularity")) << textOf(shown, "reason");
  const Eigen::Vector3d border = placeOf(handle("tool"));
  EXPECT_GT(border.x(), NEAR_ZERO.x());
  EXPECT_LT(border.x(), 0.32);
  EXPECT_LE((border - NEAR_ZERO).tail<2>().norm(), 1e-9) << "not on the way";
  const Machine machine = orthoglidePrototype();
  const auto before = configurationAt(machine, Eigen::Vector3d(border - 1e-9 * Eigen::Vector3d::UnitX()));
  const auto beyond = configurationAt(machine, Eigen::Vector3d(border + 1e-9 * Eigen::Vector3d::UnitX()));
  ASSERT_TRUE(before && beyond);
  EXPECT_TRUE(before->det_a.certainlyPositive()) << "it stops too late";
  EXPECT_TRUE(beyond->det_a.certainlyNegative()) << "it stops too early";
}

TEST_F(Mechanism, saysWhichBoundDoesNotHold)
{
  const Eigen::Vector3d stretched(0.14, 0.14, 0.14);
  ASSERT_TRUE(inverseKinematics(orthoglidePrototype(), stretched));
  drag("tool", stretched);
  const auto shown = markers("tool_markers", [&](const std::vector<Marker>& found) {
    return std::abs(named(found, "ellipsoid").pose.position.x - stretched.x()) < 1e-9;
  });
  EXPECT_NE(std::string::npos, textOf(shown, "reason").find("velocity transmission factor")) << textOf(shown, "reason");
  EXPECT_EQ("", textOf(shown, "nearest"));
}

TEST_F(Mechanism, stopsWhereRailsHaveNoAssemblyAndSaysSo)
{
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  sensor_msgs::JointState rails;
  for (int leg = 0; leg < 3; ++leg)
  {
    rails.name.push_back(orthoglidePrototype().leg(leg).joint);
    rails.position.push_back(1.0);
  }
  rails_.publish(rails);
  const auto shown =
      markers("tool_markers", [](const std::vector<Marker>& found) { return !textOf(found, "reason").empty(); });
  EXPECT_NE(std::string::npos, textOf(shown, "reason").find("no assembly")) << textOf(shown, "reason");
  const Marker ellipsoid = named(shown, "ellipsoid");
  EXPECT_GT(ellipsoid.color.r, 2.0F * ellipsoid.color.g);
  const Eigen::Vector3d border = placeOf(handle("tool"));
  EXPECT_GT((border - NEAR_ZERO).norm(), 0.01) << "it did not go as far as it can";
  EXPECT_LE(gapOnceAt(border), 1e-9);
}

TEST_F(Mechanism, isNotMovedByComputationsWhileItIsLed)
{
  const Eigen::Vector3d p(0.03, -0.02, 0.01);
  publishPose(p);
  gapOnceAt(p);
  RegionRequest query;
  query.shape = RegionRequest::SPHERE;
  ASSERT_EQ(ErrorCode::SUCCESS, compute(query).error_code);
  markers("markers", [](const auto& found) { return hasText(found, "sphere"); });
  EXPECT_LE(gapOnceAt(p), 1e-9);
}

TEST_F(Mechanism, ignoresWhatMakesNoSense)
{
  publishPose(NEAR_ZERO);
  gapOnceAt(NEAR_ZERO);
  publishPose(Eigen::Vector3d::Constant(std::nan("")));
  sensor_msgs::JointState rails;
  rails.name = { "elbow" };
  rails.position = { 1.0 };
  rails_.publish(rails);
  publishPose(2.0 * NEAR_ZERO);
  EXPECT_LE(gapOnceAt(2.0 * NEAR_ZERO), 1e-9) << "the node does not follow any more";
}
}  // namespace test
}  // namespace pkm_workspace
