// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/best_parameter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pkm_workspace/machine/catalogue.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
/// Where the edge of the UraneSX's square jumps from 0.3096 to 0.55021 m, and its edge there by a dense search.
const double JUMP = 2.0 / (3.0 * std::sqrt(3.0));
constexpr double EDGE = 0.55021;

StudyQuery squares(double lower, double upper, double accuracy)
{
  StudyQuery query;
  query.family = uranesxByRadius();
  query.range = Interval(lower, upper);
  query.region.shape = makeSquare();
  query.region.accuracy = accuracy;
  return query;
}

LargestRegion largestAt(const StudyQuery& query, double parameter)
{
  return findLargestRegion(query.family.at(Interval(parameter)), query.region);
}

bool mayBeLarger(const BestParameter& best, double parameter)
{
  return std::any_of(best.candidates.begin(), best.candidates.end(),
                     [&](const StudyPart& part) { return part.parameters.contains(parameter); });
}
}  // namespace

TEST(BestParameter, isWhereTheSizeJumps)
{
  for (const double accuracy : { 1e-3, 1e-5 })
  {
    const BestParameter best = findBestParameter(squares(0.3, 0.5, accuracy));
    EXPECT_EQ(best.region.status, LargestRegion::Status::PROVEN) << best.region.message;
    EXPECT_LE(best.region.size, EDGE + 1e-5);
    EXPECT_GE(best.region.size_upper_bound, EDGE - 1e-5);
    EXPECT_LE(best.region.size_upper_bound - best.region.size, accuracy);
    EXPECT_GE(best.parameter, JUMP);
    EXPECT_LE(best.parameter, JUMP + accuracy);
    ASSERT_FALSE(best.candidates.empty());
    EXPECT_TRUE(mayBeLarger(best, JUMP));
    EXPECT_GT(best.candidates.front().parameters.lower(), JUMP - 2.0 * accuracy);
    EXPECT_LT(best.candidates.back().parameters.upper(), JUMP + 2.0 * accuracy);
  }
}

TEST(BestParameter, keepsToItsMemory)
{
  StudyQuery query = squares(0.3, 0.5, 1e-4);
  query.region.budget.max_memory = Budget::LEAST_MEMORY;
  const BestParameter best = findBestParameter(query);
  EXPECT_TRUE(best.region.out_of_memory);
  EXPECT_EQ(best.region.message, "the limit of 4096 bytes of memory ended the search: the bracket holds, but is wide");
  EXPECT_LE(best.region.size, EDGE + 1e-5);
  EXPECT_GE(best.region.size_upper_bound, EDGE - 1e-5);
  EXPECT_TRUE(mayBeLarger(best, JUMP));
}

TEST(BestParameter, noMachineContradictsTheBracket)
{
  using test::SEED;
  SCOPED_TRACE(SEED);
  test::Random random(SEED);
  for (const auto& ends : { Interval(0.2, 0.9), Interval(0.3849, 0.386), Interval(0.45, 0.55) })
  {
    const StudyQuery query = squares(ends.lower(), ends.upper(), 1e-3);
    const BestParameter best = findBestParameter(query);
    for (int k = 0; k < test::cases(40); ++k)
    {
      const double parameter = random.uniform(ends.lower(), ends.upper());
      const double size = largestAt(query, parameter).size;
      EXPECT_LE(size, best.region.size_upper_bound) << "R - r = " << parameter;
      if (!mayBeLarger(best, parameter))
      {
        EXPECT_LE(size, best.region.size) << "R - r = " << parameter;
      }
    }
    const LargestRegion found = largestAt(query, best.parameter);
    EXPECT_GE(found.size_upper_bound, best.region.size);
  }
}

TEST(BestParameter, budgetsEndWithHonestBrackets)
{
  StudyQuery few = squares(0.3, 0.5, 1e-4);
  few.region.budget.max_boxes = 3000;
  StudyQuery short_time = squares(0.3, 0.5, 1e-4);
  short_time.region.budget.time_limit = 1e-6;
  const std::atomic<bool> stop{ true };
  StudyQuery stopped = squares(0.3, 0.5, 1e-4);
  stopped.region.budget.stop = &stop;
  for (const StudyQuery& query : { few, short_time, stopped })
  {
    const BestParameter best = findBestParameter(query);
    EXPECT_EQ(best.region.status, LargestRegion::Status::STOPPED);
    EXPECT_LE(best.region.size, EDGE + 1e-5);
    EXPECT_GE(best.region.size_upper_bound, EDGE - 1e-5);
    EXPECT_TRUE(mayBeLarger(best, JUMP) || best.parameter == JUMP);
  }
}

TEST(BestParameter, noneIsAnAnswer)
{
  StudyQuery query = squares(0.45, 0.5, 1e-3);
  query.region.criterion.psi_min = 1.2;
  query.region.criterion.psi_max = 1.3;
  const BestParameter best = findBestParameter(query);
  EXPECT_EQ(best.region.status, LargestRegion::Status::NONE) << best.region.message;
  EXPECT_EQ(best.region.size, 0.0);
}

TEST(BestParameter, oneParameterIsOneMachine)
{
  const StudyQuery query = squares(0.45, 0.45, 1e-4);
  const BestParameter best = findBestParameter(query);
  EXPECT_EQ(best.parameter, 0.45);
  EXPECT_EQ(best.region.status, LargestRegion::Status::PROVEN);
  EXPECT_NEAR(best.region.size, largestAt(query, 0.45).size, 1e-4);
}

TEST(BestParameter, partsCoverTheRange)
{
  for (const int threads : { 1, 2 })
  {
    StudyQuery query = squares(0.38, 0.42, 1e-3);
    query.region.budget.threads = threads;
    const auto parts = bestOfParts(query, 4, findBestParameter(query));
    ASSERT_EQ(parts.size(), 4U);
    double lower = 0.38;
    for (const BestParameter& part : parts)
    {
      EXPECT_EQ(part.range.lower(), lower);
      EXPECT_EQ(part.region.status, LargestRegion::Status::PROVEN) << part.region.message;
      EXPECT_TRUE(part.range.contains(part.parameter));
      lower = part.range.upper();
    }
    EXPECT_EQ(lower, 0.42);
    EXPECT_GT(parts[0].region.size, parts[1].region.size);
    EXPECT_GT(parts[2].region.size, parts[3].region.size);
  }
}

/// Parts whose budget proves nothing of them were told without an upper bound beside a proved one of the whole range.
TEST(BestParameter, partsAreBoundedByWhatIsProvedOfTheWholeRange)
{
  StudyQuery query = squares(0.38, 0.42, 1e-3);
  const BestParameter whole = findBestParameter(query);
  ASSERT_EQ(whole.region.status, LargestRegion::Status::PROVEN);
  query.region.budget.max_boxes = 4;
  const auto parts = bestOfParts(query, 4, whole);
  EXPECT_LE(parts.front().region.size_upper_bound, whole.region.size_upper_bound);
  EXPECT_EQ(parts.back().region.size_upper_bound, whole.region.size) << "no candidate is in this part";
  for (const BestParameter& part : parts)
    EXPECT_GE(part.region.size_upper_bound, largestAt(squares(0.38, 0.42, 1e-6), part.range.upper()).size);
}

TEST(BestParameter, allThatIsWrongIsTold)
{
  StudyQuery query;
  query.range = Interval::entire();
  query.region.ratio = RatioRange{ 0.5, 2.0 };
  query.region.accuracy = 0.0;
  for (const char* problem : { "family of machines", "range of the parameter", "one ratio", "accuracy = 0" })
    test::expectThrow<std::invalid_argument>([&] { findBestParameter(query); }, problem);
  test::expectThrow<std::invalid_argument>([&] { findBestParameter(squares(0.5, 1.5, 1e-3)); },
                                           R"(R - r = \[1.*\] m must lie)");
  test::expectThrow<std::invalid_argument>([&] { bestOfParts(squares(0.4, 0.5, 1e-3), 0, {}); }, "1 part or more");
}

TEST(BestParameter, progressIsABracketOfTheAnswerAllTheWay)
{
  StudyQuery query = squares(0.3, 0.5, 1e-5);
  std::vector<StudyProgress> told;
  query.progress = [&told](const StudyProgress& progress) { told.push_back(progress); };
  const BestParameter best = findBestParameter(query);
  EXPECT_FALSE(told.empty()) << "nothing was told";
  for (const StudyProgress& progress : told)
  {
    EXPECT_LE(progress.size, best.region.size);
    EXPECT_GE(progress.size_upper_bound, best.region.size);
  }
}

// Every member stands for all machines within tolerances: the robust squares of single members, by themselves.
TEST(BestParameter, ofMachinesWithinTolerances)
{
  GivenTolerances given;
  given.set(*toleranceKind("tolerance_length"), { 4e-3 });
  given.set(*toleranceKind("tolerance_slider"), { 2e-3 });
  StudyQuery query = squares(0.4, 0.44, 2e-3);
  const BestParameter exact = findBestParameter(query);
  query.family = withinTolerances(query.family, given);
  const BestParameter best = findBestParameter(query);
  EXPECT_EQ(best.region.status, LargestRegion::Status::PROVEN) << best.region.message;
  EXPECT_LT(best.region.size_upper_bound, exact.region.size);
  test::Random random(test::SEED);
  for (int k = 0; k < 12; ++k)
  {
    const double parameter = k == 0 ? 0.4 : random.uniform(0.4, 0.44);
    const double size = largestAt(query, parameter).size;
    EXPECT_LE(size, best.region.size_upper_bound) << "R - r = " << parameter;
    if (!mayBeLarger(best, parameter))
    {
      EXPECT_LE(size, best.region.size) << "R - r = " << parameter;
    }
  }
  EXPECT_NEAR(largestAt(query, best.parameter).size, best.region.size, 2e-3);
}
}  // namespace pkm_workspace
