// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/paper_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "paper/unit_ball.h"
#include "pkm_workspace/dexterity/characteristic_polynomial.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/region/largest_region.h"
#include "support/expect_throw.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace
{
const Eigen::Vector3d ONES = Eigen::Vector3d::Ones();

// docs/values.md: 1/sqrt(6) + 1/(3 sqrt(2)), exact.
const Interval CUBE_EDGE = Interval(1.0) / sqrt(Interval(6.0)) + Interval(1.0) / (Interval(3.0) * sqrt(Interval(2.0)));
// Values called "search" in docs/values.md are good to this.
const Interval SEARCH_ERROR(-1e-5, 1e-5);

PaperQuery cubesOf(const Machine& machine, double accuracy)
{
  PaperQuery query;
  query.accuracy = accuracy;
  query.centers = workspaceBounds(machine, Criterion());
  query.start = machine.zero();
  return query;
}

/// Squares of a machine with rails along z: the plane is that of the zero configuration, and centers farther from the
/// axis than a strut is long are out of reach.
PaperQuery squaresOf(const Machine& machine, double accuracy)
{
  PaperQuery query;
  query.shape = PaperQuery::Shape::SQUARE;
  query.accuracy = accuracy;
  const Eigen::Vector3d reach(machine.scale(), machine.scale(), 0.0);
  query.centers = { machine.zero() - reach, machine.zero() + reach };
  query.start = machine.zero();
  return query;
}

void expectBracket(const PaperResult& result, const PaperQuery& query, const Interval& value)
{
  EXPECT_EQ(result.ending, PaperResult::Ending::EXHAUSTED);
  EXPECT_LE(result.size, value.upper());
  EXPECT_GE(result.size_upper_bound, value.lower());
  EXPECT_LE((Interval(result.size_upper_bound) - Interval(result.size)).lower(), query.accuracy);
}

/// The brackets of the two ways have something in common.
void expectSameAs(const LargestRegion& other_way, const PaperResult& result)
{
  EXPECT_EQ(result.ending, PaperResult::Ending::EXHAUSTED);
  EXPECT_EQ(other_way.status, LargestRegion::Status::PROVEN);
  EXPECT_LE(result.size, other_way.size_upper_bound);
  EXPECT_LE(other_way.size, result.size_upper_bound);
}
}  // namespace

TEST(PaperSearch, bracketsTheCubeOfTheOrthoglideInSteps)
{
  const CharacteristicTest test(orthoglide(), Criterion());
  PaperQuery query = cubesOf(orthoglide(), 0.1);
  for (const double accuracy : { 0.1, 0.05, 0.02 })
  {
    SCOPED_TRACE(accuracy);
    query.accuracy = accuracy;
    const PaperResult result = findLargestByPaper(test, query);
    expectBracket(result, query, CUBE_EDGE);
    EXPECT_GE(result.size, query.start_size);
    query.start = result.center;
    query.start_size = result.size;
  }
}

TEST(PaperSearch, goesOnToFineAccuracyWithTheOtherBoxTest)
{
  const BoxTest test(orthoglide(), Criterion());
  PaperQuery query = cubesOf(orthoglide(), 0.1);
  for (const double accuracy : { 0.1, 0.01, 0.001, 0.0001 })
  {
    SCOPED_TRACE(accuracy);
    query.accuracy = accuracy;
    const PaperResult result = findLargestByPaper([&test](const Box& box) { return test.classify(box); }, query);
    expectBracket(result, query, CUBE_EDGE);
    query.start = result.center;
    query.start_size = result.size;
  }
}

// docs/values.md: squares of the UraneSX for R = 7/13 + lambda; the paper prints 0.510, 0.470, 0.420, 0.370, 0.320.
TEST(PaperSearch, bracketsTheSquaresOfTheUranesx)
{
  const std::pair<double, double> known[] = {
    { 0.0, 0.51949 }, { 0.05, 0.47585 }, { 0.1, 0.42859 }, { 0.15, 0.377935 }, { 0.2, 0.324062 }
  };
  for (const auto& [lambda, edge] : known)
  {
    SCOPED_TRACE(lambda);
    const Machine machine = uranesx(Interval(7.0) / Interval(13.0) + Interval(lambda), Interval(3.0) / Interval(26.0));
    const PaperQuery query = squaresOf(machine, 0.01);
    expectBracket(findLargestByPaper(CharacteristicTest(machine, Criterion()), query), query, edge + SEARCH_ERROR);
  }
}

TEST(PaperSearch, bothWaysOfStoringBoxesGiveABracket)
{
  const CharacteristicTest test(uranesx(), Criterion());
  PaperQuery query = squaresOf(uranesx(), 0.01);
  query.list_size = 1;  // always in place
  const PaperResult in_place = findLargestByPaper(test, query);
  expectBracket(in_place, query, 0.51949 + SEARCH_ERROR);
  query.list_size = 1000000;  // always at the end
  const PaperResult at_end = findLargestByPaper(test, query);
  expectBracket(at_end, query, 0.51949 + SEARCH_ERROR);
  EXPECT_LT(in_place.longest_list, at_end.longest_list) << "what the second mode is for";
}

TEST(PaperSearch, agreesWithTheOtherAlgorithmOnCubes)
{
  for (const Machine& machine : { orthoglide(), test::crooked(1), test::crooked(4) })
  {
    SCOPED_TRACE(machine.name());
    RegionQuery query;
    expectSameAs(findLargestRegion(machine, query),
                 findLargestByPaper(CharacteristicTest(machine, Criterion()), cubesOf(machine, 0.1)));
  }
}

TEST(PaperSearch, agreesWithTheOtherAlgorithmOnSquares)
{
  RegionQuery query;
  query.shape = makeSquare();
  expectSameAs(findLargestRegion(uranesx(), query),
               findLargestByPaper(CharacteristicTest(uranesx(), Criterion()), squaresOf(uranesx(), 0.005)));
}

// docs/values.md: assembled on the other side of the parallel singularity, the Orthoglide has a cube of edge
// 0.062854514.
TEST(PaperSearch, staysInTheAspectOfTheMachine)
{
  const Machine machine("other aspect", orthoglide().legs(), Eigen::Vector3d::Constant(-0.546));
  PaperQuery query = cubesOf(machine, 0.05);
  query.centers.upper.setZero();  // cubes of the other aspect are much larger here, too
  const PaperResult result = findLargestByPaper(CharacteristicTest(machine, Criterion()), query);
  expectBracket(result, query, Interval(0.062854513, 0.062854515));
}

TEST(PaperSearch, aSingleCenterHasABracketToo)
{
  PaperQuery query = cubesOf(orthoglide(), 1e-4);
  query.start = 0.1 * ONES;
  query.centers = { query.start, query.start };
  const PaperResult result = findLargestByPaper(CharacteristicTest(orthoglide(), Criterion()), query);
  // the upper corner is on the diagonal, which ends at t = 1/sqrt(6)
  expectBracket(result, query, Interval(2.0) * (Interval(1.0) / sqrt(Interval(6.0)) - Interval(0.1)));
}

TEST(PaperSearch, startIsBelievedOnlyAfterAProof)
{
  PaperQuery query = squaresOf(uranesx(), 0.05);
  query.start_size = 0.53;  // too much
  const PaperResult result = findLargestByPaper(CharacteristicTest(uranesx(), Criterion()), query);
  expectBracket(result, query, 0.51949 + SEARCH_ERROR);
}

TEST(PaperSearch, endsAtItsBudgetWithoutAnUpperBound)
{
  PaperQuery query = cubesOf(orthoglide(), 0.1);
  query.max_boxes = 10;
  const PaperResult result = findLargestByPaper(CharacteristicTest(orthoglide(), Criterion()), query);
  EXPECT_EQ(result.ending, PaperResult::Ending::BUDGET);
  EXPECT_EQ(result.boxes, 10);
  EXPECT_GT(result.size, 0.0) << "the cube at the zero configuration";
  EXPECT_LE(result.size, CUBE_EDGE.upper());
  EXPECT_EQ(result.size_upper_bound, 0.0);
}

TEST(PaperSearch, findsWhatIsKnownOfTheBall)
{
  PaperQuery query;
  query.accuracy = 1e-3;
  query.centers = { -1.1 * ONES, 1.2 * ONES };
  query.start = { 0.3, -0.2, 0.1 };
  expectBracket(findLargestByPaper(test::unitBall, query), query, Interval(2.0) / sqrt(Interval(3.0)));
  query.shape = PaperQuery::Shape::SQUARE;
  expectBracket(findLargestByPaper(test::unitBall, query), query, sqrt(Interval(2.0)));
}

TEST(PaperSearch, findsThatThereIsNothing)
{
  PaperQuery query;
  query.centers = { -ONES, ONES };
  const PaperResult result = findLargestByPaper([](const Box&) { return BoxVerdict::OUTSIDE; }, query);
  expectBracket(result, query, 0.0);
  EXPECT_EQ(result.size, 0.0);
}

TEST(PaperSearch, saysWhenTheAccuracyCannotBeSettled)
{
  PaperQuery query;
  query.accuracy = 1e-14;  // finer than what the test of the unit ball decides
  const PaperResult result = findLargestByPaper(test::unitBall, query);
  EXPECT_EQ(result.ending, PaperResult::Ending::PRECISION);
  EXPECT_NEAR(result.size, 2.0 / std::sqrt(3.0), 1e-12) << "certified all the same";
  EXPECT_EQ(result.size_upper_bound, 0.0);
}

TEST(PaperSearch, refusesEverythingThatIsOutOfRangeAtOnce)
{
  PaperQuery query = cubesOf(orthoglide(), 0.0);
  query.start = { 0.0, 5.0, 0.0 };
  query.start_size = -1.0;
  query.list_size = 0;
  query.max_boxes = -3;
  const auto search = [&query] { findLargestByPaper(CharacteristicTest(orthoglide(), Criterion()), query); };
  for (const char* text : { "accuracy = 0 m must be positive", "start = 5 m must lie in the box of centers",
                            "start size = -1 m must be 0 or positive", "list size = 0 boxes must be positive",
                            "max_boxes = -3 boxes must be positive" })
    test::expectThrow<std::invalid_argument>(search, text);
  query.centers.lower.x() = 7.0;
  test::expectThrow<std::invalid_argument>(search, "box of centers x = .*lower end first");
}
}  // namespace pkm_workspace
