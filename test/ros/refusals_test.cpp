// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <limits>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();

struct BadRequest
{
  const char* what;
  std::function<void(RegionRequest&)> spoil;
  const char* message;  ///< regular expression
  std::int32_t error_code = ErrorCode::INVALID_REQUEST;
};

void PrintTo(const BadRequest& request, std::ostream* stream)
{
  *stream << request.what;
}

class Refusals : public testing::TestWithParam<BadRequest>
{
};

const BadRequest BAD_REQUESTS[] = {
  { "shape of another name", [](auto& q) { q.shape = "blob"; },
    "shape = 'blob' must be cube, square, box, sphere, disc, cylinder or polytope" },
  { "proportions of a cube", [](auto& q) { q.proportions.x = 2.0; }, "proportions = \\(2, 0, 0\\).* box only.* cube" },
  { "ratio of a cube", [](auto& q) { q.ratio_min = q.ratio_max = 1.0; }, "ratio is for .*cylinder only.* cube" },
  { "cylinder without a ratio", [](auto& q) { q.shape = "cylinder"; }, "cylinder needs a ratio" },
  { "negative proportion",
    [](auto& q) {
      q.shape = "box";
      q.proportions.x = -1.0;
    },
    "proportions \\(-1, 0, 0\\).*must be" },
  { "NaN proportion",
    [](auto& q) {
      q.shape = "box";
      q.proportions.y = NAN_VALUE;
    },
    "proportions \\(0, nan, 0\\).*must be" },
  { "negative psi_min", [](auto& q) { q.criterion.psi_min = -0.5; }, "psi_min = -0.5 .*must be positive" },
  { "NaN psi_min", [](auto& q) { q.criterion.psi_min = NAN_VALUE; }, "psi_min = nan .*must be positive" },
  { "psi_min above psi_max", [](auto& q) { q.criterion.psi_min = 3.0; },
    "psi_max = 2 \\(the node's\\) must be at least psi_min = 3 \\(trans" },
  { "infinite psi_max", [](auto& q) { q.criterion.psi_max = INF; }, "psi_max = inf .*must be positive and finite" },
  { "negative accuracy", [](auto& q) { q.accuracy = -1e-3; }, "accuracy = -0.001.* m.*must be positive" },
  { "NaN accuracy", [](auto& q) { q.accuracy = NAN_VALUE; }, "accuracy = nan.*must be positive" },
  { "huge accuracy", [](auto& q) { q.accuracy = 1e300; }, "accuracy = 1e\\+300.* must be from 1e-18 to 1000 " },
  { "vanishing accuracy", [](auto& q) { q.accuracy = 1e-300; }, "accuracy = 1e-300.* must be from 1e-18 to 1000 " },
  { "aspect of another number", [](auto& q) { q.criterion.aspect = 4; },
    "aspect = 4 must be OWN = 1, OTHER = 2 or BOTH = 3, or 0 for own" },
  { "both aspects of a dextrous region", [](auto& q) { q.criterion.aspect = CriterionRequest::BOTH; },
    "bounded factors lies in one aspect" },
  { "set of another number", [](auto& q) { q.criterion.set = 3; },
    "set = 3 must be DEFAULT = 0, DEXTROUS = 1 or REACHABLE = 2" },
  { "psi_max of a reachable set",
    [](auto& q) {
      q.criterion.set = CriterionRequest::REACHABLE;
      q.criterion.psi_max = 2.0;
    },
    "psi_min and psi_max must be 0 unless the set is DEXTROUS" },
  { "negative force_min", [](auto& q) { q.criterion.force_min = -0.5; }, "force_min = -0.5 .*must be" },
  { "NaN force_max", [](auto& q) { q.criterion.force_max = NAN_VALUE; }, "force_max = nan .*must be" },
  { "force_min above force_max",
    [](auto& q) {
      q.criterion.force_min = 2.0;
      q.criterion.force_max = 1.0;
    },
    "force_max = 1 .*at least force_min" },
  { "kappa_max below 1", [](auto& q) { q.criterion.kappa_max = 0.5; }, "kappa_max = 0.5 .*must be" },
  { "joint limits neither on nor off", [](auto& q) { q.criterion.joint_limits = 3; },
    "joint_limits = 3 must be DEFAULT = 0, ON = 1 or OFF = 2" },
  { "time limit above the ceiling", [](auto& q) { q.time_limit = 61.0; },
    "time_limit = 61 s must be positive and at most the node's ~time_limit, 60 s, or 0 for it" },
  { "negative time limit", [](auto& q) { q.time_limit = -1.0; }, "time.limit = -1 s must be positive" },
  { "infinite time limit", [](auto& q) { q.time_limit = INF; }, "time.limit = inf s must be" },
  { "corners without a search box", [](auto& q) { q.max_corner.x = 1.0; },
    "min_corner and max_corner .*use_search_box" },
  { "reversed search box",
    [](auto& q) {
      q.use_search_box = true;
      q.max_corner.z = -1.0;
    },
    "search.box z = \\[0, -1\\] m" },
  { "NaN search box",
    [](auto& q) {
      q.use_search_box = true;
      q.min_corner.x = NAN_VALUE;
    },
    "min_corner = \\(nan, 0, 0\\) m must be finite, within 1e9 m" },
  { "search box beyond all machines",
    [](auto& q) {
      q.use_search_box = true;
      q.max_corner.x = 1e10;
    },
    "max_corner = \\(10000000000, 0, 0\\) m must be finite, within 1e9 m" },
  { "half a ratio",
    [](auto& q) {
      q.shape = "cylinder";
      q.ratio_max = 2.0;
    },
    "ratio_min and ratio_max must both be given" },
  { "base of a sphere",
    [](auto& q) {
      q.shape = "sphere";
      q.use_base = true;
    },
    "base_z is for regions with a lowest face, and a sphere has none" },
  { "a sphere that turns",
    [](auto& q) {
      q.shape = "sphere";
      q.turned = RegionRequest::ON;
    },
    "turned is for a square, cube, box or polytope: a sphere turned about the vertical is the same sphere" },
  { "unknown turn", [](auto& q) { q.turned = 3; }, "turned = 3 must be OWN = 0, ON = 1 or OFF = 2" },
  { "base of a given center", [](auto& q) { q.use_base = q.use_center = true; },
    "a center and base_z exclude each other.*give the search box" },
  { "center and search box", [](auto& q) { q.use_search_box = q.use_center = true; }, "only one of the two" },
  { "base above the search box",
    [](auto& q) {
      q.use_search_box = q.use_base = true;
      q.base_z = 1.0;
    },
    "from z = 0 m to 0 m and base_z = 1 m is not between them" },
  { "NaN base",
    [](auto& q) {
      q.use_base = true;
      q.base_z = NAN_VALUE;
    },
    "base_z = nan m must be finite, within 1e9 m" },
  { "base that is not asked for", [](auto& q) { q.base_z = 1.0; }, "base_z must be 0 \\[m\\] unless use_base" },
  { "center that is not asked for", [](auto& q) { q.center.y = 1.0; }, "center must be 0 \\[m\\] unless use_center" },
  { "radius of a cube", [](auto& q) { q.radius = 1.0; }, "a radius is for the shape cylinder only, the shape is cube" },
  { "negative height",
    [](auto& q) {
      q.shape = "cylinder";
      q.height = -1.0;
    },
    "height = -1 m must be positive" },
  { "radius and height",
    [](auto& q) {
      q.shape = "cylinder";
      q.height = q.radius = 1.0;
    },
    "one of ratio, radius and height" },
  { "polytope without vertices", [](auto& q) { q.shape = "polytope"; }, "polytope needs vertices" },
  { "vertices of a cube", [](auto& q) { q.vertices.resize(4); }, "a list of vertices is for the shape polytope only" },
  { "vertices in one point",
    [](auto& q) {
      q.shape = "polytope";
      q.vertices.resize(4);
    },
    "vertices lie in one plane" },
  { "half a footprint", [](auto& q) { q.footprint_y = 1.0; }, "footprint_x and footprint_y must both be given" },
  { "footprint of a square",
    [](auto& q) {
      q.shape = "square";
      q.footprint_x = q.footprint_y = 1.0;
    },
    "a footprint is for the shape box only" },
  { "frame that is not known", [](auto& q) { q.header.frame_id = "nowhere"; },
    "frame_id = 'nowhere' is not known to tf; empty stands for 'base_link'", ErrorCode::UNKNOWN_FRAME },
};
}  // namespace

TEST_P(Refusals, nameTheFieldAndTheNodeLivesOn)
{
  RegionRequest query;
  GetParam().spoil(query);
  const auto response = compute(query);
  EXPECT_EQ(GetParam().error_code, response.error_code);
  EXPECT_TRUE(std::regex_search(response.message, std::regex(GetParam().message)))
      << "expected: " << GetParam().message << "\n     got: " << response.message;
  EXPECT_EQ(Region(), response.region);
}

INSTANTIATE_TEST_SUITE_P(BadRequests, Refusals, testing::ValuesIn(BAD_REQUESTS));

TEST(Refusal, namesAllFieldsAtOnce)
{
  RegionRequest query;
  query.shape = "blob";
  query.criterion.psi_min = -1.0;
  query.accuracy = INF;
  query.criterion.joint_limits = 9;
  const std::string message = compute(query).message;
  for (const char* const field : { "shape", "psi_min", "accuracy", "joint_limits" })
    EXPECT_NE(std::string::npos, message.find(field)) << message;
}

TEST(Refusal, leavesTheLastAnswerAlone)
{
  const auto computed = compute(RegionRequest());
  ASSERT_EQ(ErrorCode::SUCCESS, computed.error_code) << computed.message;
  RegionRequest bad;
  bad.criterion.psi_min = -1.0;
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, compute(bad).error_code);
  EXPECT_EQ(computed.region, call<GetRegion>("get_region", GetRegion::Request()).region);
}

TEST(Request, mayNameTheFrameThatIsKnown)
{
  RegionRequest query;
  query.header.frame_id = "base_link";
  const auto response = compute(query);
  EXPECT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
}
}  // namespace test
}  // namespace pkm_workspace
