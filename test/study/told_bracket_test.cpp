// SPDX-License-Identifier: BSD-3-Clause
// What is told while a search goes on, and what shorter searches answer: brackets only get narrower.
#include <gtest/gtest.h>

#include <regex>

#include "pkm_workspace/interval/running_bracket.h"
#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/region/region_wish.h"
#include "pkm_workspace/study/best_parameter.h"
#include "pkm_workspace/study/comparison.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
/// Looks that each bracket lies within all that were told before.
class Watch
{
public:
  void tell(double lower, double upper)
  {
    ++told_;
    EXPECT_LE(lower, upper) << "bracket " << told_;
    EXPECT_GE(lower, known_.lower()) << "bracket " << told_;
    EXPECT_LE(upper, known_.upper()) << "bracket " << told_;
    known_.narrow(lower, upper);
  }
  int told() const { return told_; }

private:
  RunningBracket known_;
  int told_ = 0;
};

void expectToldBracketsShrink(const Machine& machine, RegionQuery query, int least)
{
  Watch sizes, volumes;
  query.progress_period = 0.0;
  query.progress = [&](const RegionProgress& progress) {
    if (!query.ratio)
      sizes.tell(progress.size, progress.size_upper_bound);
    volumes.tell(progress.volume, progress.volume_upper_bound);
  };
  const LargestRegion region = findLargestRegion(machine, query);
  SCOPED_TRACE(machine.name() + ", " + region.shape->name());
  if (!query.ratio)
    sizes.tell(region.size, region.size_upper_bound);
  volumes.tell(region.volume, region.volume_upper_bound);
  EXPECT_GE(volumes.told(), least);
}

RegionQuery queryFor(const char* shape, double accuracy, std::int64_t boxes = 0)
{
  RegionQuery query;
  setShape({ shape, std::nullopt, std::nullopt }, query);
  query.accuracy = accuracy;
  query.budget.max_boxes = boxes;
  return query;
}

RegionQuery cylinderQuery(double accuracy, std::int64_t boxes)
{
  RegionQuery query;
  setShape({ "cylinder", std::nullopt, RatioRange{ 0.5, 0.8 } }, query);
  query.accuracy = accuracy;
  query.budget.max_boxes = boxes;
  return query;
}

RegionQuery reachableSphere(std::int64_t boxes)
{
  RegionQuery query = queryFor("sphere", 1e-3, boxes);
  query.criterion.set = Criterion::Set::REACHABLE;
  return query;
}

void expectLongerIsNarrower(const Machine& machine, RegionQuery query, const std::vector<std::int64_t>& budgets)
{
  Watch sizes, volumes;
  for (const std::int64_t boxes : budgets)
  {
    SCOPED_TRACE(machine.name() + ", " + std::to_string(boxes) + " boxes");
    query.budget.max_boxes = boxes;
    const LargestRegion region = findLargestRegion(machine, query);
    if (!query.ratio)
      sizes.tell(region.size, region.size_upper_bound);
    volumes.tell(region.volume, region.volume_upper_bound);
  }
}
}  // namespace

TEST(ToldBrackets, shrinkInSearchesForOneShape)
{
  expectToldBracketsShrink(orthoglide(), queryFor("cube", 1e-6), 3);
  expectToldBracketsShrink(uranesx(Interval(0.3848), Interval(0.0)), queryFor("square", 1e-4), 3);
  expectToldBracketsShrink(test::crooked(4), queryFor("disc", 1e-3), 3);
  expectToldBracketsShrink(orthoglide(), reachableSphere(20), 3);
}

TEST(ToldBrackets, shrinkInSearchesOverRatios)
{
  expectToldBracketsShrink(orthoglide(), cylinderQuery(1e-2, 2000), 3);
  expectToldBracketsShrink(test::crooked(4), cylinderQuery(2e-2, 1000), 3);
}

TEST(ToldBrackets, shrinkInStudies)
{
  StudyQuery query;
  query.family = uranesxByRadius();
  query.range = Interval(0.3, 0.5);
  query.region = queryFor("square", 1e-3, 20000);
  query.progress_period = 0.0;
  Watch sizes;
  query.progress = [&](const StudyProgress& progress) { sizes.tell(progress.size, progress.size_upper_bound); };
  const LargestRegion region = findBestParameter(query).region;
  sizes.tell(region.size, region.size_upper_bound);
  EXPECT_GE(sizes.told(), 20);
}

/// Of the last bracket in a text: "size 0.61 to 0.66".
void tellLast(const std::string& text, Watch& watch)
{
  std::smatch found;
  if (std::regex_search(text, found, std::regex(R"((\S+) to (\S+?)( m\^3)?$)")))
    watch.tell(std::stod(found[1]), std::stod(found[2]));
}

void expectToldComparisonShrinks(const Machine& machine, RegionQuery query)
{
  SCOPED_TRACE(machine.name());
  Watch watch;
  query.progress_period = 0.0;
  const Comparison study =
      comparisonOf(machine, query, 0.1, [&watch](const std::string& text) { tellLast(text, watch); });
  EXPECT_GE(watch.told(), 3);
  const LargestRegion& region = study.region;
  query.ratio ? watch.tell(region.volume, region.volume_upper_bound) : watch.tell(region.size, region.size_upper_bound);
}

TEST(ToldBrackets, shrinkInComparisons)
{
  expectToldComparisonShrinks(orthoglide(), queryFor("cube", 1e-6, 150));
  expectToldComparisonShrinks(test::crooked(4), queryFor("disc", 1e-3, 150));
  expectToldComparisonShrinks(orthoglide(), cylinderQuery(1e-2, 1000));
}

// What is inside only gets more, what is undecided only less.
TEST(ToldBrackets, shrinkInPavings)
{
  PavingQuery query;
  query.resolution = 0.05;
  query.progress_period = 0.0;
  Watch inside, undecided;
  const auto tell = [&](double volume_inside, double volume_boundary) {
    inside.tell(volume_inside, 1e9);
    undecided.tell(0.0, volume_boundary);
  };
  query.progress = [&](const PavingProgress& state) { tell(state.volume_inside, state.volume_boundary); };
  const Paving paving = pave(orthoglide(), query);
  tell(paving.volume_inside.lower(), paving.volume_boundary.upper());
  EXPECT_GE(inside.told(), 10);
}

TEST(ToldBrackets, largerBoxBudgetsNeverGiveWiderOnes)
{
  const std::vector<std::int64_t> budgets = { 1, 15, 16, 17, 63, 64, 65, 100, 128, 150, 200, 257, 500, 512, 700, 1100 };
  expectLongerIsNarrower(orthoglide(), queryFor("cube", 1e-9), budgets);
  expectLongerIsNarrower(orthoglide(), queryFor("sphere", 1e-3), { 1, 20, 100 });
  expectLongerIsNarrower(test::crooked(4), queryFor("disc", 1e-6), budgets);
  expectLongerIsNarrower(orthoglide(), cylinderQuery(1e-2, 0), { 1, 60, 64, 200, 600 });
}

TEST(ToldBrackets, largerBoxBudgetsNeverGiveWiderStudies)
{
  StudyQuery query;
  query.family = uranesxByRadius();
  query.range = Interval(0.3, 0.5);
  query.region = queryFor("square", 1e-3);
  Watch sizes;
  for (const std::int64_t boxes : { 1, 50, 500, 1500, 3000, 5000, 8000 })
  {
    query.region.budget.max_boxes = boxes;
    const LargestRegion region = findBestParameter(query).region;
    sizes.tell(region.size, region.size_upper_bound);
  }
}
}  // namespace pkm_workspace
