// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"

namespace pkm_workspace
{
namespace
{
/// Halves of [0, 1024], down to pieces of one.
struct Piece
{
  int first;
  int last;
  bool operator<(const Piece& other) const { return last - first < other.last - other.first; }
};

template <class Open>
struct Halving : public BranchingDefaults
{
  Open open;
  std::vector<Piece> units;
  std::int64_t boxes = 0;
  std::size_t wave = 1;
  std::size_t node_bytes = 0;
  int indivisible_from = 1 << 30;
  std::size_t enough = 1 << 30;

  std::int64_t looks() const { return boxes; }
  std::size_t waveSize() const { return wave; }
  std::size_t bytes(std::size_t nodes) const { return node_bytes * (nodes + wave); }
  bool isSettled() const { return units.size() >= enough; }
  bool isDivisible(const Piece& piece) const { return piece.first < indivisible_from; }
  bool expand(const std::vector<Piece>& pieces)
  {
    EXPECT_LE(pieces.size(), wave);
    for (const Piece& piece : pieces)
    {
      ++boxes;
      const int middle = (piece.first + piece.last) / 2;
      if (middle == piece.first)
        units.push_back(piece);
      else
      {
        open.put({ piece.first, middle });
        open.put({ middle, piece.last });
      }
    }
    return true;
  }

  Ending run(const Budget& budget)
  {
    open.put({ 0, 1024 });
    return branchAndBound(open, *this, RunningBudget(budget));
  }
};

TEST(BranchAndBound, dividesUntilNothingIsOpen)
{
  Halving<BestFirst<Piece>> best;
  best.wave = 7;
  EXPECT_EQ(best.run(Budget()), Ending::EXHAUSTED);
  EXPECT_EQ(best.units.size(), 1024u);
  Halving<DepthFirst<Piece>> depth;
  EXPECT_EQ(depth.run(Budget()), Ending::EXHAUSTED);
  EXPECT_EQ(depth.boxes, best.boxes);
  for (std::size_t k = 0; k < depth.units.size(); ++k)
    EXPECT_EQ(depth.units[k].first, static_cast<int>(1023 - k));  // the latest first
}

TEST(BranchAndBound, takesTheBestFirst)
{
  BestFirst<Piece> open;
  for (const int last : { 3, 9, 1, 27, 4 })
    open.put({ 0, last });
  for (const int last : { 27, 9, 4, 3, 1 })
    EXPECT_EQ(open.take().last, last);
  EXPECT_TRUE(open.isEmpty());
}

TEST(BranchAndBound, endsAtEachLimitAndKeepsWhatIsOpen)
{
  Budget boxes;
  boxes.max_boxes = 100;
  Halving<BestFirst<Piece>> search;
  EXPECT_EQ(search.run(boxes), Ending::BUDGET);
  EXPECT_EQ(search.boxes, 100);
  EXPECT_EQ(search.open.size(), 101u);

  std::atomic<bool> stop(true);
  Budget stopped;
  stopped.stop = &stop;
  Halving<DepthFirst<Piece>> none;
  EXPECT_EQ(none.run(stopped), Ending::BUDGET);
  EXPECT_EQ(none.boxes, 0);

  Budget memory;
  memory.max_memory = Budget::LEAST_MEMORY;
  Halving<BestFirst<Piece>> large;
  large.node_bytes = 100;
  EXPECT_EQ(large.run(memory), Ending::MEMORY);
  EXPECT_LE(large.bytes(large.open.size() - 1), 4096u);
}

TEST(BranchAndBound, endsWhereTheSearchSaysSo)
{
  Halving<BestFirst<Piece>> settled;
  settled.enough = 1;
  EXPECT_EQ(settled.run(Budget()), Ending::SETTLED);
  EXPECT_EQ(settled.units.size(), 1u);

  Halving<DepthFirst<Piece>> indivisible;
  indivisible.indivisible_from = 512;
  EXPECT_EQ(indivisible.run(Budget()), Ending::INDIVISIBLE);
  EXPECT_EQ(indivisible.open.first().first, 512);

  Halving<BestFirst<Piece>> no_wave;
  no_wave.wave = 0;
  EXPECT_EQ(no_wave.run(Budget()), Ending::SETTLED);
}
}  // namespace
}  // namespace pkm_workspace
