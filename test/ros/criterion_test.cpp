// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <pkm_workspace/SetCriterion.h>

#include <functional>
#include <limits>
#include <map>
#include <regex>

#include "node_client.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
SetCriterion::Response set(const CriterionRequest& criterion, double accuracy)
{
  SetCriterion::Request request;
  request.criterion = criterion;
  request.accuracy = accuracy;
  return call<SetCriterion>("set_criterion", request);
}

CriterionRequest psi(double least, double largest)
{
  CriterionRequest criterion;
  criterion.psi_min = least;
  criterion.psi_max = largest;
  return criterion;
}

/// Waits for a message that fits. @return the last one that came
template <class Message>
boost::shared_ptr<const Message> await(const std::string& topic, const std::function<bool(const Message&)>& fits)
{
  const ros::Time deadline = ros::Time::now() + PATIENCE;
  auto message = receive<Message>(topic);
  while (!fits(*message) && ros::Time::now() < deadline)
    message = receive<Message>(topic);
  EXPECT_TRUE(fits(*message)) << *message;
  return message;
}

std::map<std::string, std::string> valuesOf(const diagnostic_msgs::DiagnosticStatus& status)
{
  std::map<std::string, std::string> values;
  for (const auto& pair : status.values)
    values[pair.key] = pair.value;
  return values;
}

/// The status of that name within the next complete message of the node.
diagnostic_msgs::DiagnosticStatus diagnosis(const std::string& name,
                                            const std::function<bool(const diagnostic_msgs::DiagnosticStatus&)>& fits)
{
  using Array = diagnostic_msgs::DiagnosticArray;
  diagnostic_msgs::DiagnosticStatus found;
  await<Array>("/diagnostics", [&](const Array& array) {
    for (const auto& status : array.status)
      if (status.name == "pkm_workspace_node: " + name)
        found = status;
    return !found.name.empty() && fits(found);
  });
  return found;
}
}  // namespace

TEST(SetCriterion, computesAgainAndLatches)
{
  const auto response = set(psi(1.0 / 3.0, 3.0), 0.01);
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  EXPECT_EQ(3.0, response.hypotheses.psi_max);
  EXPECT_EQ(0.01, response.hypotheses.accuracy);
  const auto region =
      await<Region>(NODE + "/region", [](const Region& latched) { return latched.hypotheses.psi_max == 3.0; });
  EXPECT_LE(region->size, 0.786583 + 1e-5);
  EXPECT_GE(region->size_upper_bound, 0.786583 - 1e-5);
  EXPECT_EQ(3.0, compute(RegionRequest()).region.hypotheses.psi_max) << "requests get another default";
  EXPECT_EQ(ErrorCode::SUCCESS, set(psi(0.5, 2.0), 1e-3).error_code);
  await<Region>(NODE + "/region", [](const Region& latched) { return latched.hypotheses.psi_max == 2.0; });
}

TEST(SetCriterion, refusesWhatIsOutOfRangeAndChangesNothing)
{
  constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
  const auto expectRefused = [](const CriterionRequest& criterion, double accuracy, const char* message) {
    const auto response = set(criterion, accuracy);
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, response.error_code);
    EXPECT_TRUE(std::regex_search(response.message, std::regex(message))) << response.message;
  };
  expectRefused(psi(-1.0, 0.0), 0.0, "psi_min = -1 .*must be positive");
  expectRefused(psi(0.0, NOT_A_NUMBER), 0.0, "psi_max = nan .*must be");
  expectRefused(psi(3.0, 0.0), 0.0, "psi_max = 2 .*at least psi_min");
  expectRefused(CriterionRequest(), -1.0, "accuracy = -1.* m.*must be");
  CriterionRequest unknown;
  unknown.joint_limits = 5;
  expectRefused(unknown, 0.0, "joint_limits = 5 must be");
  EXPECT_EQ(0.5, compute(RegionRequest()).region.hypotheses.psi_min);
}

TEST(Diagnostics, tellOfTheGeometryAndTheLastComputation)
{
  const Region region = compute(RegionRequest()).region;
  const auto ok = [](const diagnostic_msgs::DiagnosticStatus& status) { return status.level == 0; };
  const auto geometry = diagnosis("geometry", ok);
  EXPECT_EQ(region.hypotheses.geometry_hash, valuesOf(geometry)["geometry hash"]);
  EXPECT_NE(std::string::npos, geometry.hardware_id.find(region.hypotheses.machine));
  const auto computation = diagnosis("computation", [](const diagnostic_msgs::DiagnosticStatus& status) {
    return valuesOf(status)["question"].find("accuracy 0.001 m") != std::string::npos;
  });
  EXPECT_NE(std::string::npos, valuesOf(computation)["answer"].find("no larger than"));
  EXPECT_GE(std::stod(valuesOf(computation)["seconds"]), 0.0);
}

TEST(Diagnostics, countRefusals)
{
  const auto count = [](const diagnostic_msgs::DiagnosticStatus& status) {
    return std::stol(valuesOf(status)["invalid requests"]);
  };
  const long before = count(diagnosis("refusals", [](const auto&) { return true; }));
  RegionRequest bad;
  bad.accuracy = -3.0;
  compute(bad);
  const auto after = diagnosis("refusals", [&](const auto& status) { return count(status) > before; });
  EXPECT_EQ(before + 1, count(after));
  EXPECT_NE(std::string::npos, valuesOf(after)["last refusal"].find("accuracy = -3"));
}
}  // namespace test
}  // namespace pkm_workspace
