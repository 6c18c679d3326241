// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/CompareMachines.h>
#include <pkm_workspace/FindSingularities.h>

#include <map>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using diagnostic_msgs::DiagnosticStatus;

std::map<std::string, std::string> valuesOf(const DiagnosticStatus& status)
{
  std::map<std::string, std::string> values;
  for (const auto& pair : status.values)
    values[pair.key] = pair.value;
  return values;
}

/// The status of that name within the next complete message of the node.
DiagnosticStatus diagnosis(const std::string& name, const std::function<bool(const DiagnosticStatus&)>& fits)
{
  using Array = diagnostic_msgs::DiagnosticArray;
  DiagnosticStatus found;
  await<Array>("/diagnostics", [&](const Array& array) {
    for (const auto& status : array.status)
      if (status.name == "pkm_workspace_node: " + name)
        found = status;
    return !found.name.empty() && fits(found);
  });
  return found;
}

/// The status of the computation, once that is told of.
DiagnosticStatus computation(const std::string& question)
{
  return diagnosis("computation", [&question](const DiagnosticStatus& status) {
    return valuesOf(status)["question"].find(question) != std::string::npos;
  });
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}  // namespace

TEST(Diagnostics, tellOfTheGeometryAndTheLastComputation)
{
  const Region region = compute(RegionRequest()).region;
  const auto ok = [](const DiagnosticStatus& status) { return status.level == 0; };
  const auto geometry = diagnosis("geometry", ok);
  EXPECT_EQ(region.hypotheses.geometry_hash, valuesOf(geometry)["geometry hash"]);
  EXPECT_NE(std::string::npos, geometry.hardware_id.find(region.hypotheses.machine));
  const auto computation = diagnosis("computation", [](const DiagnosticStatus& status) {
    return valuesOf(status)["question"].find("accuracy 0.001 m") != std::string::npos;
  });
  EXPECT_NE(std::string::npos, valuesOf(computation)["question"].find("largest cube, dextrous with psi in [0.5, 2]"));
  EXPECT_NE(std::string::npos, valuesOf(computation)["answer"].find("m of frame 'base_link', edge [m] "));
  EXPECT_NE(std::string::npos, valuesOf(computation)["answer"].find("Proved: every point of the "));
  EXPECT_GE(std::stod(valuesOf(computation)["seconds"]), 0.0);
}

TEST(Diagnostics, tellTheBracketOfAFreeRatioAsOneOfVolumes)
{
  RegionRequest query;
  query.shape = RegionRequest::CYLINDER;
  query.accuracy = 1e-2;
  query.ratio_min = 0.55;
  query.ratio_max = 0.75;
  compute(query);
  const auto values = valuesOf(computation("radius 0.55 to 0.75 times its height"));
  EXPECT_TRUE(has(values.at("answer"), " times its height and a volume above ")) << values.at("answer");
  EXPECT_FALSE(has(values.at("answer"), "of a size above")) << values.at("answer");
}

TEST(Diagnostics, countRefusals)
{
  const auto count = [](const DiagnosticStatus& status) { return std::stol(valuesOf(status)["invalid requests"]); };
  const long before = count(diagnosis("refusals", [](const auto&) { return true; }));
  RegionRequest bad;
  bad.accuracy = -3.0;
  compute(bad);
  const auto after = diagnosis("refusals", [&](const auto& status) { return count(status) > before; });
  EXPECT_EQ(before + 1, count(after));
  EXPECT_NE(std::string::npos, valuesOf(after)["last refusal"].find("accuracy = -3"));
}

TEST(Diagnostics, tellOfSingularitiesThatAreUndecided)
{
  FindSingularities::Request request;
  request.time_limit = 1e-9;
  ASSERT_EQ(SingularityFinding::UNDECIDED, call<FindSingularities>("find_singularities", request).parallel.status);
  EXPECT_EQ(DiagnosticStatus::WARN, computation("singularities").level);
}

TEST(Diagnostics, tellOfComparisons)
{
  CompareMachines::Request request;
  request.urdfs = { writeUrdf(orthoglidePrototype()) };
  ASSERT_EQ(ErrorCode::SUCCESS, call<CompareMachines>("compare_machines", request).error_code);
  EXPECT_EQ("2 machines were compared.", valuesOf(computation("comparison"))["answer"]);
}

TEST(Diagnostics, andMessagesStayShortAfterLongRequests)
{
  constexpr std::size_t MOST = 10000;
  const std::string text(2000000, 'x');
  CheckPath::Request path;
  path.segments.resize(100000);
  const std::string segments = call<CheckPath>("check_path", path).message;
  EXPECT_LT(segments.size(), MOST);
  EXPECT_TRUE(has(segments, "segments[0]: kind = 0") && has(segments, "and 99980 more")) << segments.substr(0, MOST);
  CheckRegion::Request region;
  region.solid.type = shape_msgs::SolidPrimitive::BOX;
  region.solid.dimensions.resize(100000, 0.5);
  EXPECT_LT(call<CheckRegion>("check_region", region).message.size(), MOST);
  RegionRequest query;
  query.header.frame_id = text;
  const auto unknown = compute(query);
  EXPECT_EQ(ErrorCode::UNKNOWN_FRAME, unknown.error_code);
  EXPECT_LT(unknown.message.size(), MOST);
  EXPECT_TRUE(has(unknown.message, "bytes left out") && has(unknown.message, "'base_link'"));
  query.header.frame_id = "";
  query.shape = text;
  const std::string shape = compute(query).message;
  EXPECT_LT(shape.size(), MOST);
  EXPECT_TRUE(has(shape, "shape = 'xxx") && has(shape, "must be cube"));
  const auto refusals = diagnosis(
      "refusals", [](const DiagnosticStatus& status) { return has(valuesOf(status)["last refusal"], "must be cube"); });
  EXPECT_LT(valuesOf(refusals)["last refusal"].size(), 1100U);
}
}  // namespace test
}  // namespace pkm_workspace
