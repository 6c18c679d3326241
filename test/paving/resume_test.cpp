// SPDX-License-Identifier: BSD-3-Clause
// Going on from an earlier paving gives, bit for bit, what a new one gives.
#include <gtest/gtest.h>

#include "paving/pavings.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;

using test::expectSame;
using test::query;

TEST(PavingResume, atAFinerResolution)
{
  for (const Machine& machine : { orthoglide(), test::crooked(7) })
    for (const auto set : { Criterion::Set::DEXTROUS, Criterion::Set::REACHABLE })
    {
      const Paving fresh = pave(machine, query(0.03, set));
      const Paving coarse = pave(machine, query(0.1, set));
      const Paving fine = resume(machine, query(0.03, set), coarse);
      expectSame(fresh, fine);
      EXPECT_EQ(fine.boxes_here, fresh.boxes - coarse.boxes) << "a box was looked at twice";
      expectSame(fresh, resume(machine, query(0.03, set), resume(machine, query(0.05, set), coarse)));
    }
}

TEST(PavingResume, atTheSameOrACoarserResolutionLooksAtNothing)
{
  const Paving fine = pave(orthoglide(), query(0.05));
  for (const double resolution : { 0.05, 0.051, 0.2, 1.0, 5.0 })
  {
    const Paving again = resume(orthoglide(), query(resolution), fine);
    expectSame(pave(orthoglide(), query(resolution)), again);
    EXPECT_EQ(again.boxes_here, 0);
  }
}

TEST(PavingResume, afterABudgetOfBoxes)
{
  const Paving fresh = pave(orthoglide(), query(0.05));
  test::Random random(SEED);
  for (int k = 0; k < test::cases(20); ++k)
  {
    SCOPED_TRACE("case " + std::to_string(k) + ", seed " + std::to_string(SEED));
    PavingQuery wanted = query(random.once(2) ? 0.05 : 0.1);
    Paving paving;
    for (std::int64_t looked = 0; !paving.complete; looked = paving.boxes)
    {
      wanted.budget.max_boxes = random.integer(1, 4000);
      paving = looked == 0 ? pave(orthoglide(), wanted) : resume(orthoglide(), wanted, paving);
      ASSERT_LE(paving.boxes_here, wanted.budget.max_boxes);
      ASSERT_GT(paving.boxes_here, 0);
    }
    expectSame(fresh, resume(orthoglide(), query(0.05), paving));
  }
}

// The boxes that a budget left open are in several levels, and the next run has another resolution.
TEST(PavingResume, afterBudgetsOfEveryKindInTurns)
{
  const Paving fresh = pave(test::crooked(7), query(0.05));
  std::atomic<bool> stop(false);
  PavingQuery wanted = query(0.1);
  wanted.budget.max_boxes = 777;
  Paving paving = pave(test::crooked(7), wanted);
  wanted.resolution = 0.03;
  wanted.budget.max_boxes = 1500;
  paving = resume(test::crooked(7), wanted, paving);
  wanted.resolution = 0.07;
  wanted.budget.max_boxes = 0;
  wanted.budget.max_memory = 60000;
  paving = resume(test::crooked(7), wanted, paving);
  EXPECT_FALSE(paving.complete);
  wanted.budget.max_memory = 0;
  stop = true;
  wanted.budget.stop = &stop;
  const std::int64_t pending = paving.tree.count(CellState::PENDING);
  paving = resume(test::crooked(7), wanted, paving);
  EXPECT_EQ(paving.boxes_here, 0);
  EXPECT_GE(paving.tree.count(CellState::PENDING), pending);
  expectSame(fresh, resume(test::crooked(7), query(0.05), paving));
}

TEST(PavingResume, inAPlaneAndOnAnyNumberOfThreads)
{
  PavingQuery wanted = query(0.02);
  wanted.box.reset();
  const Paving coarse = pave(uranesx(), wanted);
  wanted.resolution = 0.003;
  for (const int threads : { 1, 2, 5 })
  {
    wanted.budget.threads = threads;
    expectSame(pave(uranesx(), wanted), resume(uranesx(), wanted, coarse));
  }
}

TEST(PavingResume, refusesWhatIsAboutSomethingElse)
{
  const Paving earlier = pave(orthoglide(), query(0.2));
  const auto refuses = [&](const Machine& machine, const PavingQuery& wanted, const std::string& pattern) {
    test::expectThrow<std::invalid_argument>([&] { resume(machine, wanted, earlier); }, pattern);
  };
  refuses(orthoglide(2.0), query(0.2),
          "geometry hash: .* " + orthoglide().geometryHash() + ", .* " + orthoglide(2.0).geometryHash());
  refuses(orthoglide(), query(0.2, Criterion::Set::REACHABLE), "criterion: .*dextrous with psi.*, .*reachable");
  refuses(
      orthoglide(), query(0.2, Criterion::Set::DEXTROUS, Criterion::Aspect::OTHER),
      "criterion: the earlier paving is of dextrous with psi in \\[0.5, 2\\], own aspect, joint limits off, asked for "
      "is dextrous with psi in \\[0.5, 2\\], other aspect, joint limits off$");
  PavingQuery wanted = query(0.2);
  wanted.criterion.psi_min = std::nextafter(0.5, 1.0);
  refuses(orthoglide(), wanted, "psi in \\[0.5, 2\\].*psi in \\[0.5000000000000001, 2\\]");
  wanted = query(0.2);
  wanted.box->upper.x() = 1.5;
  refuses(orthoglide(), wanted, "box: .*from .* to .*\\(1 1 1\\) m.*1.5");
  wanted.box.reset();
  refuses(orthoglide(), wanted, "box: ");
}
}  // namespace
}  // namespace pkm_workspace
