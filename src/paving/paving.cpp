// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/parallel.h"

namespace pkm_workspace
{
namespace
{
/// Boxes of one level that a thread takes at a time.
constexpr std::size_t CHUNK = 1024;
using States = std::vector<CellState>;

/// Section 2.6 of the paper, one level of boxes after the other: the answer does not depend on the number of threads,
/// and a run that is cut short is as fine everywhere as it got.
class Paver
{
public:
  Paver(const Machine& machine, const PavingQuery& query)
    : query_(query)
    , test_(machine, query.criterion)
    , pool_(query.budget.threads)
    , begin_(std::chrono::steady_clock::now())
  {
    paving_.box = query.box ? *query.box : workspaceBounds(machine, query.criterion);
  }

  Paving run()
  {
    if (paving_.box.isValid())
    {
      paving_.tree = BoxTree(Bisection(paving_.box, query_.resolution));
      std::vector<Cell> level = { Cell{ 0, 0, 0 } };
      while (!level.empty())
        level = divide(level);
    }
    const BoxTree& tree = paving_.tree;
    paving_.volume_inside = tree.volume(CellState::INSIDE);
    paving_.volume_boundary = tree.volume(CellState::BOUNDARY) + tree.volume(CellState::PENDING);
    paving_.complete = tree.count(CellState::PENDING) == 0;
    paving_.seconds = seconds();
    return std::move(paving_);
  }

private:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  /// Looks at every box of a level. @return the halves of those that are neither decided nor small enough
  std::vector<Cell> divide(const std::vector<Cell>& cells)
  {
    const std::size_t level = paving_.tree.levels();
    std::size_t allowed = late() ? 0 : cells.size();
    if (query_.budget.max_boxes > 0)
      allowed = std::min<std::size_t>(allowed, static_cast<std::size_t>(query_.budget.max_boxes - paving_.boxes));
    States states(cells.size(), CellState::PENDING);
    const std::size_t chunks = (allowed + CHUNK - 1) / CHUNK;
    std::vector<std::size_t> splits(chunks + 1, 0);  // in the chunks before
    pool_.forEach(chunks, [&](std::size_t chunk) {
      const std::size_t first = chunk * CHUNK;
      if (!late())
        splits[chunk + 1] = look(&cells[first], std::min(CHUNK, allowed - first), level, &states[first]);
    });
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      splits[chunk + 1] += splits[chunk];
    std::vector<Cell> next(2 * splits[chunks]);
    pool_.forEach(chunks, [&](std::size_t chunk) {
      Cell* half = next.data() + 2 * splits[chunk];
      for (std::size_t k = chunk * CHUNK; k < std::min(allowed, (chunk + 1) * CHUNK); ++k)
        if (states[k] == CellState::SPLIT)
          for (const std::uint32_t side : { 0U, 1U })
            *half++ = paving_.tree.bisection().half(cells[k], level, side);
    });
    paving_.tree.addLevel(std::move(states));
    paving_.boxes += static_cast<std::int64_t>(cells.size()) - paving_.tree.count(CellState::PENDING, level);
    report(next.size());
    return next;
  }

  bool late() const { return query_.budget.isOver(seconds()); }

  /// @return how many are to be split
  std::size_t look(const Cell* cells, std::size_t count, std::size_t level, CellState* states) const
  {
    std::array<Box, CHUNK> boxes;
    std::array<BoxVerdict, CHUNK> verdicts;
    const Bisection& bisection = paving_.tree.bisection();
    for (std::size_t k = 0; k < count; ++k)
      boxes[k] = bisection.box(cells[k], level);
    test_.kernel().classify(boxes.data(), count, verdicts.data());
    const CellState undecided = level == bisection.depth() ? CellState::BOUNDARY : CellState::SPLIT;
    std::size_t splits = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
      states[k] = verdicts[k] == BoxVerdict::INSIDE    ? CellState::INSIDE
                  : verdicts[k] == BoxVerdict::OUTSIDE ? CellState::OUTSIDE
                                                       : undecided;
      splits += states[k] == CellState::SPLIT ? 1 : 0;
    }
    return splits;
  }

  void report(std::size_t open)
  {
    if (!query_.progress || seconds() < next_progress_)
      return;
    const BoxTree& tree = paving_.tree;
    Interval undecided = tree.volume(CellState::BOUNDARY) + tree.volume(CellState::PENDING);
    if (open > 0)
      undecided += Interval(static_cast<double>(open)) * tree.bisection().volume(tree.levels());
    query_.progress({ tree.volume(CellState::INSIDE).lower(), undecided.upper(), paving_.boxes, seconds() });
    next_progress_ = seconds() + 0.1;
  }

  const PavingQuery& query_;
  BoxTest test_;
  ThreadPool pool_;
  Paving paving_;
  std::chrono::steady_clock::time_point begin_;
  double next_progress_ = 0.1;
};
}  // namespace

void PavingQuery::validate(Problems& problems) const
{
  criterion.validate(problems);
  validatePositive("resolution", resolution, "m", problems);
  budget.validate(problems);
  if (box)
    validateBox("box", *box, problems);
}

Paving pave(const Machine& machine, const PavingQuery& query)
{
  return Paver(machine, validated(query)).run();
}
}  // namespace pkm_workspace
