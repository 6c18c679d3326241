// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/ComputeWorkspace.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <shape_msgs/SolidPrimitive.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const double LARGEST_EDGE = 1.0 / std::sqrt(6.0) + 1.0 / (3.0 * std::sqrt(2.0));

geometry_msgs::TransformStamped stamped(const std::string& parent, const std::string& child,
                                        const Eigen::Quaterniond& turn, const Eigen::Vector3d& shift)
{
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = shift.x();
  message.transform.translation.y = shift.y();
  message.transform.translation.z = shift.z();
  message.transform.rotation.x = turn.x();
  message.transform.rotation.y = turn.y();
  message.transform.rotation.z = turn.z();
  message.transform.rotation.w = turn.w();
  return message;
}

const Eigen::Quaterniond QUARTER(Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()));
const Eigen::Vector3d SHIFT(1.0, 2.0, 3.0);
const Eigen::Quaterniond TILT(Eigen::AngleAxisd(M_PI / 6.0, Eigen::Vector3d::UnitX()));

/// Above the machine's root a workbench, turned by a quarter; below it a tilted table; a gripper at the
/// tool; and a cloud that hangs nowhere.
class Frame : public testing::Test
{
protected:
  Frame()
  {
    broadcaster_.sendTransform({ stamped("workbench", "base_link", QUARTER, SHIFT),
                                 stamped("base_link", "table", TILT, Eigen::Vector3d::Zero()),
                                 stamped("tcp_1", "gripper", TILT, SHIFT), stamped("cloud", "drop", TILT, SHIFT) });
  }

  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

RegionRequest in(const std::string& frame)
{
  RegionRequest request;
  request.header.frame_id = frame;
  return request;
}

/// Where requests wait behind a misspelt one, no more than two are answered: the last before it, and the next.
constexpr int NOBODY_WAITS = 4;
constexpr int TRIES = 30;  // as others may compute on this machine, too

/// Asks for frames that do not exist, a new one each time until nobody waits, and has others ask for what does.
/// @param request without frames @param frame of a request
/// @return the most answers that others got while one such request was open
template <class Service>
int answersMeanwhile(const std::string& name, const typename Service::Request& request,
                     std::string& (*frame)(typename Service::Request&))
{
  std::atomic<int> answers(0);
  std::atomic<bool> ends(false);
  int most = 0;
  std::thread misspelling([&] {
    for (int k = 0; k < TRIES && most < NOBODY_WAITS; ++k)
    {
      typename Service::Request misspelt = request;
      frame(misspelt) = "misspelt_" + std::to_string(k);
      const int before = answers;
      EXPECT_EQ(ErrorCode::UNKNOWN_FRAME, call<Service>(name, misspelt).error_code);
      most = std::max(most, answers - before);
    }
    ends = true;
  });
  while (!ends)
  {
    const auto response = call<Service>(name, request);
    EXPECT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
    ++answers;
  }
  misspelling.join();
  return most;
}

void expectBracket(const Region& region, double size)
{
  EXPECT_LE(region.size, size);
  EXPECT_GE(region.size_upper_bound, size);
}
}  // namespace

TEST_F(Frame, turnedByAQuarterHasTheSameCube)
{
  const Region here = compute(RegionRequest()).region;
  const auto response = compute(in("workbench"));
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  const Region& region = response.region;
  EXPECT_EQ("workbench", region.header.frame_id);
  expectBracket(region, LARGEST_EDGE);
  const Eigen::Vector3d center(region.center.x, region.center.y, region.center.z);
  EXPECT_LE((QUARTER.conjugate() * (center - SHIFT) - Eigen::Vector3d::Constant(0.086273015)).norm(), 2e-3);
  EXPECT_EQ(here.hypotheses.geometry_hash, region.hypotheses.geometry_hash);
  EXPECT_EQ(SHIFT.y(), region.hypotheses.root.position.y);
  EXPECT_EQ(1.0, here.hypotheses.root.orientation.w);
}

/// The cube of a tilted frame is another one, and all of it is good: a grid of its points, seen from the root.
TEST_F(Frame, tiltedHasACubeAlongItsOwnAxes)
{
  const auto response = compute(in("table"));
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  const Region& region = response.region;
  EXPECT_GT(region.size, 0.3);
  EXPECT_GT(std::abs(region.size - LARGEST_EDGE), 1e-3);
  const Machine machine = orthoglide();
  for (int k = 0; k < 125; ++k)
  {
    const Eigen::Vector3d share(k % 5 / 4.0 - 0.5, k / 5 % 5 / 4.0 - 0.5, k / 25 / 4.0 - 0.5);
    const Eigen::Vector3d center(region.center.x, region.center.y, region.center.z);
    const auto matrices = jacobians(machine, TILT * (center + region.size * share));
    ASSERT_TRUE(matrices);
    const Eigen::Vector3d psi = transmissionFactors(*matrices);
    EXPECT_GE(psi[0], 0.5 - 1e-9);
    EXPECT_LE(psi[2], 2.0 + 1e-9);
  }
}

TEST_F(Frame, isPavedToo)
{
  ComputeWorkspace::Request request;
  request.query.resolution = 0.1;
  const Workspace here = call<ComputeWorkspace>("compute_workspace", request).workspace;
  request.query.header.frame_id = "table";
  const Workspace there = call<ComputeWorkspace>("compute_workspace", request).workspace;
  EXPECT_EQ("table", there.header.frame_id);
  EXPECT_LE(there.volume_lower_bound, here.volume_upper_bound);
  EXPECT_GE(there.volume_upper_bound, here.volume_lower_bound);
}

TEST_F(Frame, mayHaveALeadingSlash)
{
  EXPECT_EQ("workbench", compute(in("/workbench")).region.header.frame_id);
}

TEST_F(Frame, unknownIsRefusedWithThoseThatAreKnown)
{
  compute(in("table"));  // by then the node knows of all
  const auto unknown = compute(in("nowhere"));
  EXPECT_EQ(ErrorCode::UNKNOWN_FRAME, unknown.error_code);
  EXPECT_NE(std::string::npos, unknown.message.find("'nowhere' is not known to tf"));
  EXPECT_NE(std::string::npos, unknown.message.find("these frames are known: base_link, table, workbench"))
      << unknown.message;
  const auto apart = compute(in("drop"));
  EXPECT_EQ(ErrorCode::UNKNOWN_FRAME, apart.error_code);
  EXPECT_NE(std::string::npos, apart.message.find("'drop' is not connected to 'base_link'")) << apart.message;
}

TEST_F(Frame, thatTheMachineMovesIsRefused)
{
  compute(in("table"));  // by then the node knows of all
  for (const char* const moved : { "tcp_1", "slider_2", "/tcp_1" })
  {
    const auto response = compute(in(moved));
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code) << moved;
    EXPECT_NE(std::string::npos, response.message.find("moves with the machine: name a frame that stands still, such "
                                                       "as base_link, table, workbench"))
        << response.message;
  }
  const auto gripped = compute(in("gripper"));
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, gripped.error_code);
  EXPECT_NE(std::string::npos, gripped.message.find("'gripper' hangs at 'tcp_1', which moves with the machine"))
      << gripped.message;
}

TEST_F(Frame, misspeltKeepsNobodyWaiting)
{
  const int verdicts = answersMeanwhile<EvaluatePoint>(
      "evaluate_point", {}, [](EvaluatePoint::Request& request) -> std::string& { return request.header.frame_id; });
  EXPECT_GE(verdicts, NOBODY_WAITS);
  CheckRegion::Request small;
  small.solid.type = shape_msgs::SolidPrimitive::BOX;
  small.solid.dimensions = { 0.1, 0.1, 0.1 };
  const int checks = answersMeanwhile<CheckRegion>(
      "check_region", small, [](CheckRegion::Request& request) -> std::string& { return request.header.frame_id; });
  EXPECT_GE(checks, NOBODY_WAITS);
  const int regions = answersMeanwhile<ComputeLargestRegion>(
      "compute_largest_region", {},
      [](ComputeLargestRegion::Request& request) -> std::string& { return request.query.header.frame_id; });
  EXPECT_GE(regions, NOBODY_WAITS);
}
}  // namespace test
}  // namespace pkm_workspace
