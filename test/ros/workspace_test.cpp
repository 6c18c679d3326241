// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/ComputeWorkspace.h>

#include <limits>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/paving/components.h"
#include "pkm_workspace/paving/set_volume.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
ComputeWorkspace::Response approximate(const PavingRequest& query)
{
  ComputeWorkspace::Request request;
  request.query = query;
  return call<ComputeWorkspace>("compute_workspace", request);
}

PavingRequest atResolution(double resolution)
{
  PavingRequest query;
  query.resolution = resolution;
  return query;
}

/// The same by the library, from the beginning.
Paving fresh(double resolution)
{
  PavingQuery query;
  query.resolution = resolution;
  return pave(orthoglide(), query);
}

void expectSame(const Paving& paving, const Workspace& workspace)
{
  const Interval volume = setVolume(orthoglide(), paving, {}).volume;
  EXPECT_EQ(volume.lower(), workspace.volume_lower_bound);
  EXPECT_EQ(volume.upper(), workspace.volume_upper_bound);
  EXPECT_EQ(paving.volume_inside.lower(), workspace.volume_inside);
  EXPECT_EQ(paving.tree.count(CellState::INSIDE), workspace.boxes_inside);
  EXPECT_EQ(paving.tree.count(CellState::BOUNDARY), workspace.boxes_boundary);
  EXPECT_EQ(paving.boxes, workspace.boxes);
  EXPECT_TRUE(workspace.complete);
}

double volumeOf(const BoxList& list)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < list.min_corners.size(); ++k)
    sum += (list.max_corners[k].x - list.min_corners[k].x) * (list.max_corners[k].y - list.min_corners[k].y) *
           (list.max_corners[k].z - list.min_corners[k].z);
  return sum;
}
}  // namespace

TEST(ComputeWorkspace, goesOnFromTheLastPaving)
{
  const auto coarse = approximate(atResolution(0.1));
  ASSERT_EQ(ErrorCode::SUCCESS, coarse.error_code) << coarse.message;
  expectSame(fresh(0.1), coarse.workspace);
  const auto fine = approximate(atResolution(0.05));
  expectSame(fresh(0.05), fine.workspace);
  EXPECT_LT(fine.workspace.boxes_here, fine.workspace.boxes);
  EXPECT_EQ(0, approximate(atResolution(0.05)).workspace.boxes_here);
}

TEST(ComputeWorkspace, beginsAnewForAnotherQuestion)
{
  approximate(atResolution(0.1));
  PavingRequest other = atResolution(0.1);
  other.criterion.psi_max = 1.5;
  const Workspace workspace = approximate(other).workspace;
  EXPECT_EQ(workspace.boxes, workspace.boxes_here);
  EXPECT_EQ(1.5, workspace.hypotheses.psi_max);
  EXPECT_EQ(0.1, workspace.hypotheses.accuracy);
}

TEST(ComputeWorkspace, saysWhatItMeansForLimitsThatAreLeftAside)
{
  constexpr const char* REMARK = " Joint limits are off: all rails stay within their limits.";
  PavingRequest query = atResolution(0.1);
  EXPECT_EQ(std::string::npos, approximate(query).message.find("Joint limits"));
  query.criterion.joint_limits = CriterionRequest::OFF;
  EXPECT_NE(std::string::npos, approximate(query).message.find(REMARK)) << approximate(query).message;
}

TEST(ComputeWorkspace, saysWhatIsProvedAndWhichLimitEndedIt)
{
  constexpr const char* PROOF =
      "Proved: the points of the box that are dextrous in the machine's own aspect have a volume of [0-9.]+ to [0-9.]+ "
      "m\\^3\\.";
  const std::string whole = approximate(atResolution(0.1)).message;
  EXPECT_TRUE(std::regex_match(whole, std::regex(PROOF))) << whole;
  for (const bool by_memory : { false, true })
  {
    PavingRequest query = atResolution(1e-3);
    query.criterion.psi_max = 1.75;  // nobody asked before
    query.time_limit = by_memory ? 0.0 : 1e-6;
    query.max_memory = by_memory ? 4096 : 0;
    const std::string ended_by = by_memory ? "the limit of 4096 bytes of memory" : "the time limit of 1e-06 s";
    const std::string message = approximate(query).message;
    EXPECT_TRUE(std::regex_match(message, std::regex(PROOF + (" Ended early by " + ended_by) +
                                                     ": more time, boxes or memory give closer bounds\\.")))
        << message;
  }
}

TEST(ComputeWorkspace, knowsTheVolumeMoreCloselyThanItsBoxes)
{
  PavingRequest query = atResolution(0.1);
  const Workspace workspace = approximate(query).workspace;
  EXPECT_LT(workspace.volume_inside, workspace.volume_lower_bound);
  EXPECT_LT(workspace.volume_upper_bound, workspace.volume_inside + workspace.volume_boundary);
  query.volume_accuracy = 1e-3;
  const Workspace close = approximate(query).workspace;
  EXPECT_TRUE(close.complete);
  EXPECT_LE(close.volume_upper_bound - close.volume_lower_bound, 1e-3 * close.volume_upper_bound);
  EXPECT_EQ(close.boxes_boundary, workspace.boxes_boundary);
  query.volume_accuracy = -1.0;
  const auto refused = approximate(query);
  EXPECT_EQ(refused.error_code, ErrorCode::INVALID_REQUEST);
  EXPECT_NE(refused.message.find("volume_accuracy = -1"), std::string::npos) << refused.message;
}

TEST(ComputeWorkspace, listsBoxesAsCoarselyAsItTakes)
{
  PavingRequest query = atResolution(0.05);
  EXPECT_TRUE(approximate(query).workspace.inside.min_corners.empty());
  std::size_t before = 0;
  for (const int most : { 1, 100, 1000, 1000000 })
  {
    query.max_listed = most;
    const Workspace workspace = approximate(query).workspace;
    const std::size_t count = workspace.inside.min_corners.size() + workspace.boundary.min_corners.size();
    EXPECT_LE(count, static_cast<std::size_t>(most));
    EXPECT_GT(count, before);
    before = count;
    EXPECT_LE(volumeOf(workspace.inside), workspace.volume_inside + 1e-9);
    EXPECT_GE(volumeOf(workspace.inside) + volumeOf(workspace.boundary), workspace.volume_upper_bound - 1e-9);
  }
  EXPECT_EQ(before, static_cast<std::size_t>(fresh(0.05).tree.count(CellState::INSIDE) +
                                             fresh(0.05).tree.count(CellState::BOUNDARY)));
}

TEST(ComputeWorkspace, tellsTheAspectsApart)
{
  PavingRequest query = atResolution(0.1);
  query.criterion.set = CriterionRequest::REACHABLE;
  double sum = 0.0;
  for (const std::uint8_t aspect : { CriterionRequest::OWN, CriterionRequest::OTHER })
  {
    query.criterion.aspect = aspect;
    const Workspace workspace = approximate(query).workspace;
    EXPECT_EQ(aspect, workspace.hypotheses.aspect);
    sum += workspace.volume_lower_bound;
  }
  query.criterion.aspect = CriterionRequest::BOTH;
  const Workspace both = approximate(query).workspace;
  EXPECT_GE(both.volume_upper_bound, sum);
  EXPECT_EQ(Hypotheses::REACHABLE, both.hypotheses.set);
}

TEST(ComputeWorkspace, refusesWhatIsOutOfRange)
{
  struct Case
  {
    void (*spoil)(PavingRequest&);
    const char* message;
  };
  const Case cases[] = {
    { [](PavingRequest& q) { q.criterion.aspect = 4; }, "aspect = 4 must be OWN = 1, OTHER = 2 or BOTH = 3" },
    { [](PavingRequest& q) { q.resolution = -0.1; }, "resolution = -0.1.* m must be positive" },
    { [](PavingRequest& q) { q.resolution = std::numeric_limits<double>::quiet_NaN(); }, "resolution = nan" },
    { [](PavingRequest& q) { q.max_memory = 5; },
      "max_memory = 5 bytes must be from 4096 to the node's ~max_memory, 1073741824 bytes, or 0" },
    { [](PavingRequest& q) { q.max_memory = std::int64_t(1) << 40; }, "max_memory = .* to the node's ~max_memory" },
    { [](PavingRequest& q) { q.max_listed = -1; }, "max_listed = -1 must be >= 0" },
    { [](PavingRequest& q) { q.time_limit = 61.0; }, "time_limit = 61 s must be positive and at most" },
    { [](PavingRequest& q) { q.min_corner.x = 1.0; }, "min_corner and max_corner .* unless use_box" },
    { [](PavingRequest& q) { q.criterion.psi_min = -1.0; }, "psi_min = -1 .*must be positive" },
    { [](PavingRequest& q) { q.criterion.joint_limits = 7; }, "joint_limits = 7 must be DEFAULT" },
  };
  for (const Case& bad : cases)
  {
    PavingRequest query;
    bad.spoil(query);
    const auto response = approximate(query);
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code);
    EXPECT_TRUE(std::regex_search(response.message, std::regex(bad.message)))
        << "expected: " << bad.message << "\n     got: " << response.message;
    EXPECT_EQ(Workspace(), response.workspace);
  }
}
namespace
{
geometry_msgs::Point pointAt(double x, double y, double z)
{
  geometry_msgs::Point point;
  point.x = x;
  point.y = y;
  point.z = z;
  return point;
}
}  // namespace

TEST(ComputeWorkspace, saysHowTheSetHangsTogether)
{
  EXPECT_EQ("", approximate(atResolution(0.1)).workspace.components_message);
  EXPECT_EQ(Workspace::NOT_ASKED, approximate(atResolution(0.1)).workspace.connection);
  PavingRequest query = atResolution(0.05);
  query.components = true;
  const Workspace found = approximate(query).workspace;
  const Paving paving = fresh(0.05);
  const Components components(paving.tree);
  ASSERT_EQ(components.list().size(), found.components.size());
  EXPECT_EQ(components.clusters(), static_cast<std::size_t>(found.clusters));
  EXPECT_EQ(*components.at(orthoglide().zero()), static_cast<std::size_t>(found.zero_component));
  EXPECT_EQ(components.list()[0].volume.lower(), found.components[0].volume_lower_bound);
  EXPECT_EQ(components.list()[0].boxes, found.components[0].boxes);
  EXPECT_LE(found.components[0].min_corner.x, found.components[0].point.x);
  EXPECT_EQ(0U, found.components_message.find("Proved: the boxes inside form ")) << found.components_message;
}

TEST(ComputeWorkspace, saysWhetherTwoPointsAreConnected)
{
  PavingRequest query = atResolution(0.05);
  query.connect = { pointAt(-0.1, -0.1, -0.1), pointAt(0.3, 0.3, 0.3) };
  const Workspace found = approximate(query).workspace;
  ASSERT_EQ(Workspace::CONNECTED, found.connection) << found.connection_message;
  EXPECT_EQ(query.connect.front(), found.connection_path.front());
  EXPECT_EQ(query.connect.back(), found.connection_path.back());
  EXPECT_EQ(-1, found.zero_component) << "components are not asked for";
  query.connect.back() = pointAt(5, 0, 0);
  EXPECT_EQ(Workspace::OUTSIDE, approximate(query).workspace.connection);
  query.connect.pop_back();
  EXPECT_NE(std::string::npos, approximate(query).message.find("connect has 1 points, it must have two, or none"));
}

}  // namespace test
}  // namespace pkm_workspace
