// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving.h"

#include <algorithm>

#include "paver.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
std::string describe(const Box& box)
{
  TextStream text;
  text << "from (" << box.lower.transpose() << ") to (" << box.upper.transpose() << ") m";
  return text.str();
}

void refuse(const Difference& difference, Problems& problems)
{
  problems.push_back(difference.what + ": the earlier paving is of " + difference.one + ", asked for is " +
                     difference.other);
}
}  // namespace

void PavingQuery::validate(Problems& problems) const
{
  criterion.validate(problems);
  validatePositive("resolution", resolution, "m", problems);
  budget.validate(problems);
  if (box)
    validateBox("box", *box, problems);
}

void Paving::sumUp()
{
  volume_inside = tree.volume(CellState::INSIDE);
  volume_boundary = tree.volume(CellState::BOUNDARY) + tree.volume(CellState::PENDING);
  boxes = 0;
  for (const CellState state : { CellState::SPLIT, CellState::INSIDE, CellState::OUTSIDE, CellState::BOUNDARY })
    boxes += tree.count(state);
  complete = tree.count(CellState::PENDING) == 0;
}

double Paving::volumeUpper() const
{
  // all boxes fill the whole: finer ones, whose faces round more, do not tell less
  const Interval not_outside = tree.wholeVolume() - tree.volume(CellState::OUTSIDE);
  return std::min((volume_inside + volume_boundary).upper(), not_outside.upper());
}

Box defaultBox(const Machine& machine, const Criterion& criterion)
{
  if (!slidesAlongRails(machine, criterion))
    return workspaceBounds(machine, criterion);
  const int axis = mainAxisOfRails(machine);
  return boundsAcrossRails(machine, criterion, axis, machine.zero()[axis]);
}

Paving pave(const Machine& machine, const PavingQuery& query)
{
  return Paver(machine, validated(query), nullptr).run();
}

Paving resume(const Machine& machine, const PavingQuery& query, const Paving& earlier)
{
  Problems problems;
  query.validate(problems);
  if (problems.empty())
    validateEarlier(machine, query, earlier, problems);
  throwProblems(problems);
  return Paver(machine, query, &earlier).run();
}

void validateEarlier(const Machine& machine, const PavingQuery& query, const Paving& earlier, Problems& problems)
{
  for (const Difference& difference : differences(earlier.premises, premisesOf(machine, query.criterion)))
    refuse(difference, problems);
  if (!problems.empty())
    return;
  // without one asked for, the box depends on the machine and the criterion
  const Box box = query.box ? *query.box : defaultBox(machine, query.criterion);
  if (earlier.box.lower != box.lower || earlier.box.upper != box.upper)
    refuse({ "box", describe(earlier.box), describe(box) }, problems);
}
}  // namespace pkm_workspace
