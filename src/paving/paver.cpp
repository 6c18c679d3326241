// SPDX-License-Identifier: BSD-3-Clause
#include "paver.h"

#include <algorithm>
#include <array>
#include <limits>

namespace pkm_workspace
{
namespace
{
/// Boxes of one level that a thread takes at a time.
constexpr std::size_t CHUNK = 128;
/// Chunks between two reports.
constexpr std::size_t CHUNKS_A_REPORT = 4096;
/// Processor time after which others join [s]: levels double, so that most of the work is yet to come by then.
constexpr double ALONE = 5e-4;
/// What a box takes while its level is in work, and what its halves will take meanwhile [bytes].
constexpr std::size_t BOX_BYTES = sizeof(Cell) + 2 * sizeof(CellState);
constexpr std::size_t SPLIT_BYTES = 2 * BOX_BYTES;

CellState stateOf(BoxVerdict verdict, CellState undecided)
{
  return verdict == BoxVerdict::INSIDE    ? CellState::INSIDE
         : verdict == BoxVerdict::OUTSIDE ? CellState::OUTSIDE
                                          : undecided;
}

/// More than volumes may differ by the order in which levels are summed up, relative to them.
constexpr double ORDER = 0x1p-40;
}  // namespace

StateCounts Paver::Counts::states(std::size_t size) const
{
  const std::size_t known[] = { splits, inside, outside, boundary, size - splits - inside - outside - boundary };
  StateCounts result{};
  std::copy(std::begin(known), std::end(known), result.begin());  // in the order of CellState
  return result;
}

void Paver::Counts::add(const Counts& other)
{
  looked += other.looked;
  inside += other.inside;
  outside += other.outside;
  boundary += other.boundary;
  splits += other.splits;
  known_splits += other.known_splits;
}

Paver::Paver(const Machine& machine, const PavingQuery& query, const Paving* earlier)
  : query_(query)
  , earlier_(earlier)
  , test_(machine, query.criterion)
  , pool_(query.budget.threads, ALONE)
  , budget_(query.budget)
  , pace_(query.progress_period)
{
  told_.volume_boundary = std::numeric_limits<double>::infinity();
  paving_.premises = premisesOf(machine, query.criterion);
  paving_.resolution = query.resolution;
  paving_.box = query.box ? *query.box : defaultBox(machine, query.criterion);
}

Paving Paver::run()
{
  if (paving_.box.isValid())
  {
    paving_.tree = BoxTree(Bisection(paving_.box, query_.resolution));
    for (Level level = firstLevel(); level.size > 0;)
      level = divide(level);
  }
  paving_.sumUp();
  paving_.seconds = budget_.seconds();
  return std::move(paving_);
}

Paver::Level Paver::firstLevel() const
{
  Level level(1);
  level.cells[0] = { 0, 0, 0 };
  if (earlier_)
    level.known = earlier_->tree.level(0);
  return level;
}

CellState Paver::known(const Level& level, std::size_t box) const
{
  return earlier_ ? level.known[box] : CellState::PENDING;
}

/// Looks at every box of a level. @return the halves of those that are neither decided nor small enough
Paver::Level Paver::divide(const Level& level)
{
  States states(level.size);
  std::vector<Counts> counts = lookAtAll(level, states);
  keepToMemory(level, states, counts);
  std::vector<Counts> before(counts.size() + 1);
  for (std::size_t chunk = 0; chunk < counts.size(); ++chunk)
  {
    before[chunk + 1] = before[chunk];
    before[chunk + 1].add(counts[chunk]);
  }
  Level next = halves(level, states, before);
  paving_.tree.addLevel(std::move(states), before.back().states(level.size));
  return next;
}

/// @param states what is known afterwards @return the counts of each chunk
std::vector<Paver::Counts> Paver::lookAtAll(const Level& level, States& states)
{
  const std::size_t last = endOfAllowed(level);
  std::vector<Counts> counts((level.size + CHUNK - 1) / CHUNK);
  Counts sum;
  for (std::size_t begin = 0; begin < counts.size(); begin += CHUNKS_A_REPORT)
  {
    const std::size_t chunks = std::min(CHUNKS_A_REPORT, counts.size() - begin);
    pool_.forEach(chunks, [&](std::size_t index) {
      const std::size_t first = (begin + index) * CHUNK;
      counts[begin + index] = lookAt(level, first, std::min(last, first + CHUNK), states.data());
    });
    for (std::size_t index = begin; index < begin + chunks; ++index)
      sum.add(counts[index]);
    report(level, sum);
  }
  paving_.boxes_here += static_cast<std::int64_t>(sum.looked);
  return counts;
}

/// Boxes of the chunk that begins at @p first. @param last those from here on are not looked at
Paver::Counts Paver::lookAt(const Level& level, std::size_t first, std::size_t last, CellState* states) const
{
  std::array<std::size_t, CHUNK> open;
  std::array<Box, CHUNK> boxes;
  std::array<BoxVerdict, CHUNK> verdicts;
  Counts counts;
  const Bisection& bisection = paving_.tree.bisection();
  const std::size_t number = paving_.tree.levels();
  const std::size_t end = std::min(first + CHUNK, level.size);
  for (std::size_t k = first; k < end; ++k)
    states[k] = known(level, k);
  if (!budget_.isOver())
    for (std::size_t k = first; k < last; ++k)
      if (states[k] == CellState::PENDING)
      {
        boxes[counts.looked] = bisection.box(level.cells[k], number);
        open[counts.looked++] = k;
      }
  test_.kernel().classify(boxes.data(), counts.looked, verdicts.data());
  const CellState undecided = number == bisection.depth() ? CellState::BOUNDARY : CellState::SPLIT;
  for (std::size_t k = 0; k < counts.looked; ++k)
    states[open[k]] = stateOf(verdicts[k], undecided);
  for (std::size_t k = first; k < end; ++k)
  {
    if (states[k] == CellState::SPLIT || states[k] == CellState::BOUNDARY)
      states[k] = undecided;  // an earlier paving may have been coarser or finer
    counts.inside += states[k] == CellState::INSIDE ? 1 : 0;
    counts.outside += states[k] == CellState::OUTSIDE ? 1 : 0;
    counts.boundary += states[k] == CellState::BOUNDARY ? 1 : 0;
    counts.splits += states[k] == CellState::SPLIT ? 1 : 0;
    counts.known_splits += states[k] == CellState::SPLIT && known(level, k) == CellState::SPLIT ? 1 : 0;
  }
  return counts;
}

/// @return up to which box of the level the budget allows looks
std::size_t Paver::endOfAllowed(const Level& level) const
{
  if (query_.budget.max_boxes == 0)
    return level.size;
  std::int64_t allowed = query_.budget.max_boxes - paving_.boxes_here;
  std::size_t end = 0;
  for (; end < level.size; ++end)
    if (known(level, end) == CellState::PENDING && allowed-- <= 0)
      break;
  return end;
}

/// Takes back splits, from the last box to the first, whose halves would not fit into the memory. What the earlier
/// paving has split stays.
void Paver::keepToMemory(const Level& level, States& states, std::vector<Counts>& counts) const
{
  if (query_.budget.max_memory == 0)
    return;
  std::size_t needed = paving_.tree.bytes() + (earlier_ ? earlier_->tree.bytes() : 0) + BOX_BYTES * states.size();
  for (const Counts& chunk : counts)
    needed += SPLIT_BYTES * chunk.splits;
  for (std::size_t k = states.size(); k > 0 && query_.budget.isFull(needed); --k)
    if (states[k - 1] == CellState::SPLIT && known(level, k - 1) != CellState::SPLIT)
    {
      states[k - 1] = CellState::PENDING;
      --counts[(k - 1) / CHUNK].splits;
      needed -= SPLIT_BYTES;
    }
}

/// @param before of each chunk, the counts of all that come before it; at last of all
Paver::Level Paver::halves(const Level& level, const States& states, const std::vector<Counts>& before)
{
  const std::size_t number = paving_.tree.levels();
  Level next(2 * before.back().splits);
  if (earlier_)
    next.known = States(next.size, CellState::PENDING);
  pool_.forEach(before.size() - 1, [&](std::size_t chunk) {
    std::size_t half = 2 * before[chunk].splits;
    std::size_t known = 2 * before[chunk].known_splits;
    for (std::size_t k = chunk * CHUNK; k < std::min(states.size(), (chunk + 1) * CHUNK); ++k)
      if (states[k] == CellState::SPLIT)
        for (const std::uint32_t side : { 0U, 1U })
        {
          if (this->known(level, k) == CellState::SPLIT)
            next.known[half] = earlier_->tree.level(number + 1)[known++];
          next.cells[half++] = paving_.tree.bisection().half(level.cells[k], number, side);
        }
  });
  return next;
}

/// @param sum of what became of the level in work
void Paver::report(const Level& level, const Counts& sum)
{
  if (!query_.progress || !pace_.isDue(budget_.seconds()))
    return;
  const BoxTree& tree = paving_.tree;
  const Interval each = tree.bisection().volume(tree.levels());
  const auto volume = [&each](std::size_t count) { return Interval(static_cast<double>(count)) * each; };
  const Interval inside = tree.volume(CellState::INSIDE) + volume(sum.inside);
  const Interval undecided = tree.volume(CellState::BOUNDARY) + tree.volume(CellState::PENDING) +
                             volume(level.size - sum.inside - sum.outside);
  told_.volume_inside = std::max(told_.volume_inside, (1.0 - ORDER) * inside.lower());
  told_.volume_boundary =
      std::min(told_.volume_boundary, (1.0 + ORDER) * undecided.upper() + 4.0 * ORDER * inside.upper());
  told_.boxes = paving_.boxes_here + static_cast<std::int64_t>(sum.looked);
  told_.seconds = budget_.seconds();
  query_.progress(told_);
}
}  // namespace pkm_workspace
