// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/SetCriterion.h>

#include <limits>
#include <regex>

#include "node_client.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/ros/criterion_message.h"

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
}  // namespace

TEST(Hypotheses, giveBackAllPremises)
{
  Machine::Legs legs = orthoglide().legs();
  legs[0].limits = Interval(-1.0, 1.0);
  const auto machine = std::make_shared<const Machine>("limited", legs, orthoglide().zero());
  const FramedMachine in{ "table", machine, machine->geometryHash(), { { 0.0, 0.0, 0.6, 0.8 }, { 1.0, 2.0, 3.0 } } };
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    for (const double value : { 1.25, 1.5 })
    {
      Criterion criterion;
      criterion.set = bound.is_optional ? Criterion::Set::REACHABLE : Criterion::Set::DEXTROUS;
      criterion.aspect = Criterion::Aspect::OTHER;
      criterion.joint_limits = true;
      criterion.*bound.value = value;
      const Premises premises = in.premises(criterion);
      EXPECT_TRUE(premises.criterion == criterion) << bound.name;
      const Premises back = fromMessage(toMessage(premises, 0.0));
      EXPECT_EQ(back.bytes(), premises.bytes()) << bound.name;
      EXPECT_EQ(describe(back), describe(premises)) << bound.name;
    }
}

TEST(SetCriterion, computesAgainAndLatches)
{
  const auto response = set(psi(1.0 / 3.0, 3.0), 0.01);
  ASSERT_EQ(ErrorCode::SUCCESS, response.error_code) << response.message;
  EXPECT_TRUE(std::regex_match(response.message, std::regex("Computing: largest cube, .*\\."))) << response.message;
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

TEST(SetCriterion, takesInfinityForNoneWhereTheMessageSaysSo)
{
  using Field = double CriterionRequest::*;
  const std::pair<Field, const char*> bounds[] = { { &CriterionRequest::force_min, "force_min" },
                                                   { &CriterionRequest::force_max, "force_max" },
                                                   { &CriterionRequest::kappa_max, "kappa_max" },
                                                   { &CriterionRequest::psi_min, "psi_min" },
                                                   { &CriterionRequest::psi_max, "psi_max" } };
  for (const auto& [field, name] : bounds)
  {
    CriterionRequest criterion;
    criterion.*field = INF;
    const auto response = set(criterion, 0.0);
    const bool may_be_none = field != &CriterionRequest::psi_min && field != &CriterionRequest::psi_max;
    EXPECT_EQ(may_be_none, response.error_code == ErrorCode::SUCCESS) << name << ": " << response.message;
    EXPECT_TRUE(may_be_none || response.message.find(name + std::string(" = inf ")) == 0) << response.message;
    criterion.*field = -INF;
    EXPECT_EQ(ErrorCode::INVALID_REQUEST, set(criterion, 0.0).error_code) << name;
  }
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, set(CriterionRequest(), INF).error_code) << "accuracy";
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
  expectRefused(psi(3.0, 0.0), 0.0, "psi_max = 2 \\(the node's\\) must be at least psi_min = 3 \\(trans");
  expectRefused(CriterionRequest(), -1.0, "accuracy = -1.* m.*must be");
  for (const double accuracy : { 1e300, 1e-300 })
    expectRefused(CriterionRequest(), accuracy,
                  "accuracy = 1e.300 .*must be from 1e-18 to 1000 for this machine, whose longest strut is 1 m");
  CriterionRequest unknown;
  unknown.joint_limits = 5;
  expectRefused(unknown, 0.0, "joint_limits = 5 must be");
  EXPECT_EQ(0.5, compute(RegionRequest()).region.hypotheses.psi_min);
}
}  // namespace test
}  // namespace pkm_workspace
