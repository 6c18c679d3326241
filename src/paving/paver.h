// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pkm_workspace/common/parallel.h"
#include "pkm_workspace/paving/paving.h"

namespace pkm_workspace
{
/// Section 2.6 of the paper, one level of boxes after the other: the answer does not depend on the number of threads,
/// and a run that is cut short is as fine everywhere as it got. What an earlier paving knows of a box is not looked at
/// again.
class Paver
{
public:
  /// @param earlier of the same machine, criterion and box, or nullptr
  Paver(const Machine& machine, const PavingQuery& query, const Paving* earlier);

  Paving run();

private:
  using States = std::vector<CellState>;

  /// The boxes of a level, and what the earlier paving knows of each: nothing where PENDING, or where there is none.
  /// Cells are first written by the threads that share them: what one thread does for all boxes alone is kept small.
  struct Level
  {
    explicit Level(std::size_t boxes) : size(boxes), cells(new Cell[boxes]) {}

    std::size_t size;
    std::unique_ptr<Cell[]> cells;
    States known;
  };

  /// What became of boxes.
  struct Counts
  {
    std::size_t looked = 0;
    std::size_t inside = 0;
    std::size_t outside = 0;
    std::size_t boundary = 0;
    std::size_t splits = 0;
    std::size_t known_splits = 0;  ///< of these, boxes that the earlier paving has split, too

    void add(const Counts& other);
    /// @param size of the level, of which the rest is PENDING
    StateCounts states(std::size_t size) const;
  };

  Level firstLevel() const;
  Level divide(const Level& level);
  CellState known(const Level& level, std::size_t box) const;
  std::vector<Counts> lookAtAll(const Level& level, States& states);
  Counts lookAt(const Level& level, std::size_t first, std::size_t last, CellState* states) const;
  std::size_t endOfAllowed(const Level& level) const;
  void keepToMemory(const Level& level, States& states, std::vector<Counts>& counts) const;
  Level halves(const Level& level, const States& states, const std::vector<Counts>& before);
  void report(const Level& level, const Counts& sum);

  const PavingQuery& query_;
  const Paving* earlier_;
  BoxTest test_;
  ThreadPool pool_;
  Paving paving_;
  const RunningBudget budget_;
  Pace pace_;
  PavingProgress told_;  ///< last: nobody is told less later
};
}  // namespace pkm_workspace
