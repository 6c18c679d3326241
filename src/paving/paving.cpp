// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving.h"

#include <chrono>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/parallel.h"

namespace pkm_workspace
{
namespace
{
/// Boxes of one level that a thread takes at a time.
constexpr std::size_t CHUNK = 256;

Interval volumeOf(const std::vector<Box>& boxes)
{
  Interval sum(0.0);
  for (const Box& box : boxes)
    sum += box.volume();
  return sum;
}

void append(std::vector<Box>& to, const std::vector<Box>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

/// Section 2.6 of the paper, one generation of boxes after the other: the answer does not depend on the number of
/// threads, and a run that is cut short is as fine everywhere as it got.
class Paver
{
public:
  Paver(const Machine& machine, const PavingQuery& query)
    : query_(query), test_(machine, query.criterion), begin_(std::chrono::steady_clock::now())
  {
    paving_.box = query.box ? *query.box : workspaceBounds(machine, query.criterion);
  }

  Paving run()
  {
    std::vector<Box> generation;
    if (paving_.box.isValid())
      generation.push_back(paving_.box);
    while (!generation.empty() && paving_.pending.empty())
      generation = divide(generation);
    append(paving_.pending, generation);
    std::vector<Box> undecided = paving_.boundary;
    append(undecided, paving_.pending);
    paving_.volume_inside = volumeOf(paving_.inside);
    paving_.volume_boundary = volumeOf(undecided);
    paving_.complete = paving_.pending.empty();
    paving_.seconds = seconds();
    return paving_;
  }

private:
  struct Part
  {
    std::vector<Box> inside, boundary, next, pending;
  };

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  bool outOfTime() const { return query_.budget.isOver(seconds()); }

  /// Looks at every box of a generation. @return the halves of those that are neither decided nor small enough
  std::vector<Box> divide(const std::vector<Box>& generation)
  {
    std::size_t allowed = generation.size();
    if (query_.budget.max_boxes > 0)
      allowed = std::min<std::size_t>(allowed, static_cast<std::size_t>(query_.budget.max_boxes - paving_.boxes));
    std::vector<Part> parts((generation.size() + CHUNK - 1) / CHUNK);
    parallelFor(query_.budget.threads, parts.size(), [&](std::size_t index) {
      const bool late = outOfTime();
      for (std::size_t k = index * CHUNK; k < std::min((index + 1) * CHUNK, generation.size()); ++k)
        look(generation[k], late || k >= allowed, parts[index]);
    });
    std::vector<Box> next;
    for (const Part& part : parts)
    {
      append(paving_.inside, part.inside);
      append(paving_.boundary, part.boundary);
      append(paving_.pending, part.pending);
      append(next, part.next);
    }
    paving_.boxes += static_cast<std::int64_t>(generation.size() - paving_.pending.size());
    report(next);
    return next;
  }

  void look(const Box& box, bool late, Part& part) const
  {
    if (late)
    {
      part.pending.push_back(box);
      return;
    }
    const BoxVerdict verdict = test_.classify(box);
    const int axis = box.widestAxis();
    if (verdict == BoxVerdict::INSIDE)
      part.inside.push_back(box);
    else if (verdict == BoxVerdict::UNDECIDED && (box.width(axis) <= query_.resolution || !box.canBisect(axis)))
      part.boundary.push_back(box);
    else if (verdict == BoxVerdict::UNDECIDED)
    {
      const auto halves = box.bisect(axis);
      part.next.push_back(halves.first);
      part.next.push_back(halves.second);
    }
  }

  void report(const std::vector<Box>& next)
  {
    if (!query_.progress || seconds() < next_progress_)
      return;
    std::vector<Box> undecided = paving_.boundary;
    append(undecided, next);
    query_.progress({ volumeOf(paving_.inside).lower(), volumeOf(undecided).upper(), paving_.boxes, seconds() });
    next_progress_ = seconds() + 0.1;
  }

  const PavingQuery& query_;
  BoxTest test_;
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
