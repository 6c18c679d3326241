// SPDX-License-Identifier: BSD-3-Clause
// A machine whose limits leave nothing: every search ends, and no bound is negative.
#include <gtest/gtest.h>

#include "pkm_workspace/paving/range_workspace.h"
#include "pkm_workspace/region/region_wish.h"
#include "pkm_workspace/study/best_parameter.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
/// Every slider would have to be five struts away from where its strut can reach the tool.
Machine emptyOrthoglide()
{
  const Interval far(5.0, 6.0);
  return withJointLimits(orthoglide(), { far, far, far });
}

RegionQuery queryFor(const std::string& shape, std::optional<RatioRange> ratio = std::nullopt)
{
  RegionQuery query;
  const bool is_box = shape == "box";
  setShape({ shape, is_box ? std::make_optional(Eigen::Vector3d(1.0, 2.0, 0.5)) : std::nullopt, ratio }, query);
  query.criterion.joint_limits = true;
  return query;
}

void expectNothing(const LargestRegion& region)
{
  EXPECT_EQ(region.status, LargestRegion::Status::NONE) << region.message;
  EXPECT_EQ(region.size, 0.0);
  EXPECT_EQ(region.size_upper_bound, 0.0);
  EXPECT_EQ(region.volume, 0.0);
  EXPECT_EQ(region.volume_upper_bound, 0.0);
  EXPECT_NE(region.message.find("no region of any size"), std::string::npos) << region.message;
}
}  // namespace

TEST(EmptyMachine, noShapeHasASize)
{
  for (const std::string& shape : shapeNames())
    expectNothing(findLargestRegion(emptyOrthoglide(), queryFor(shape)));
  expectNothing(findLargestRegion(emptyOrthoglide(), queryFor("cylinder", RatioRange{ 0.5, 0.5 })));
}

TEST(EmptyMachine, norHasACylinderOfFreeRatio)
{
  expectNothing(findLargestRegion(emptyOrthoglide(), queryFor("cylinder", RatioRange{ 0.5, 1.0 })));
  RegionQuery limited = queryFor("cylinder", RatioRange{ 1e-6, 1e6 });
  limited.accuracy = 1e-4;
  limited.budget.time_limit = 1.0;
  expectNothing(findLargestRegion(emptyOrthoglide(), limited));
}

TEST(EmptyMachine, norAnythingWithItsCenterOutOfReach)
{
  RegionQuery query = queryFor("cube");
  query.criterion.joint_limits = false;
  query.search_box = Box{ Eigen::Vector3d::Constant(3.0), Eigen::Vector3d::Constant(4.0) };
  expectNothing(findLargestRegion(orthoglide(), query));
}

TEST(EmptyMachine, norAMachineOfAFamily)
{
  StudyQuery query;
  query.family = familyBetween(emptyOrthoglide(), emptyOrthoglide(), true);
  query.range = Interval(0.0, 1.0);
  query.region = queryFor("cube");
  expectNothing(findBestParameter(query).region);
}
}  // namespace pkm_workspace
