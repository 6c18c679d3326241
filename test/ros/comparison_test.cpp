// SPDX-License-Identifier: BSD-3-Clause
#include <pkm_workspace/CompareMachines.h>

#include "node_client.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/machine/tolerances.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const ComparedFigure& figure(const MachineComparison& machine, const std::string& name)
{
  for (const ComparedFigure& candidate : machine.figures)
    if (candidate.name == name)
      return candidate;
  throw std::runtime_error("no figure " + name);
}
}  // namespace

// docs/values.md: the Orthoglide's workspace for the strokes of its cube, and the cube of the prototype.
TEST(CompareMachines, tellsTheNodesMachineBesideAnother)
{
  CompareMachines::Request request;
  request.urdfs = { writeUrdf(orthoglidePrototype()) };
  const auto compared = call<CompareMachines>("compare_machines", request);
  ASSERT_EQ(ErrorCode::SUCCESS, compared.error_code) << compared.message;
  ASSERT_EQ(2U, compared.machines.size());
  const MachineComparison& own = compared.machines[0];
  EXPECT_EQ("orthoglide", own.region.hypotheses.machine);
  EXPECT_TRUE(own.complete);
  EXPECT_LE(figure(own, "workspace_volume").value.lower, 0.5743);
  EXPECT_GE(figure(own, "workspace_volume").value.upper, 0.5742);
  EXPECT_GT(figure(own, "region_least_det_a").value.lower, 0.0);
  EXPECT_EQ(3, figure(own, "region_volume").power);
  EXPECT_NEAR(0.2, compared.machines[1].region.size, 1e-3);
  EXPECT_EQ(own.figures.size(), compared.machines[1].figures.size());
}

TEST(CompareMachines, tellsOfAllMachinesWithinTolerances)
{
  CompareMachines::Request request;
  Tolerances some;
  setTolerance(*toleranceKind("tolerance_length"), { 5e-3 }, some);
  request.urdfs = { writeUrdf(withTolerances(orthoglide(), some)) };
  request.query.accuracy = 1e-3;
  const auto own = call<CompareMachines>("compare_machines", request);
  ASSERT_EQ(ErrorCode::SUCCESS, own.error_code) << own.message;
  EXPECT_TRUE(own.machines[0].region.hypotheses.tolerances.empty());
  ASSERT_EQ(1U, own.machines[1].region.hypotheses.tolerances.size());
  EXPECT_LT(own.machines[1].region.size_upper_bound, own.machines[0].region.size);
  request.query.criterion.own_tolerances = CriterionRequest::OFF;
  const auto none = call<CompareMachines>("compare_machines", request);
  EXPECT_TRUE(none.machines[1].region.hypotheses.tolerances.empty());
  EXPECT_EQ(none.machines[0].region.size, none.machines[1].region.size);
}

TEST(CompareMachines, namesEachOneThatIsNone)
{
  CompareMachines::Request request;
  request.urdfs = { "<robot name='none'/>", writeUrdf(orthoglide()), "<robot" };
  const auto refused = call<CompareMachines>("compare_machines", request);
  EXPECT_NE(std::string::npos, refused.message.find("urdfs[0]: ")) << refused.message;
  EXPECT_NE(std::string::npos, refused.message.find("urdfs[2]: ")) << refused.message;
}

TEST(CompareMachines, refusesWhatIsNoMachineByItsPlace)
{
  CompareMachines::Request request;
  request.urdfs = { writeUrdf(orthoglide()), "<robot name='none'/>" };
  const auto refused = call<CompareMachines>("compare_machines", request);
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, refused.error_code);
  EXPECT_NE(std::string::npos, refused.message.find("urdfs[1]: ")) << refused.message;
  EXPECT_TRUE(refused.machines.empty());
  const auto none = call<CompareMachines>("compare_machines", {});
  EXPECT_EQ(ErrorCode::INVALID_REQUEST, none.error_code);
  EXPECT_EQ("urdfs lists 0 machines; it must list from 1 to 16", none.message);
}
}  // namespace test
}  // namespace pkm_workspace
