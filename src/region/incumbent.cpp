// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/incumbent.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "pkm_workspace/region/own_proof.h"
#include "pkm_workspace/region/turned_region.h"

namespace pkm_workspace
{
namespace
{
/// Boxes that one region may take to be proved, round ones because they touch bounds all along a curve; and the share
/// of all that are allowed.
constexpr std::int64_t VERIFICATION_BOXES = 20000;
constexpr std::int64_t ROUND_VERIFICATION_BOXES = 100000;
/// Where a proof was given up after that many, the next ones that get them are smaller by this share of the accuracy.
constexpr double LESS = 0.1;
constexpr std::int64_t VERIFICATIONS = 16;
/// The least gain that a region is proved for, as a share of the accuracy.
constexpr double WORTHWHILE = 0.05;
}  // namespace

Incumbent::Incumbent(const Machine& machine, const BoxTest& test, const RegionQuery& query, const RunningBudget& budget,
                     double known, std::int64_t most)
  : machine_(machine)
  , test_(test)
  , query_(query)
  , budget_(budget)
  , most_(most > 0 ? most : std::numeric_limits<std::int64_t>::max())
{
  candidate_.size = known;
}

std::int64_t Incumbent::allowedBoxes(double size) const
{
  const bool may_be_long =
      !query_.shape->isBox() && query_.shape->ownProof() == nullptr && size < given_up_ - LESS * query_.accuracy;
  return std::min(may_be_long ? ROUND_VERIFICATION_BOXES : VERIFICATION_BOXES, most_ / VERIFICATIONS + 1);
}

bool Incumbent::asksFor(double size) const
{
  const double gain = machine_.hasTolerances() && found_ ? WORTHWHILE * query_.accuracy : 0.0;
  return size > candidate_.size + gain && boxes_ < most_ && !budget_.isOver();
}

/// As seen from the region. @return with a bad point as seen from its center
ContainmentResult Incumbent::checkTurned(const Candidate& region, const Budget& budget) const
{
  try
  {
    const SeenFrom seen = seenFrom(machine_, query_.criterion, region.center, region.angle);
    const BoxTest turned(seen.machine, seen.criterion, query_.precision);
    const Eigen::Vector3d center(0.0, 0.0, region.center.z());
    ContainmentResult proof = checkContainment(turned, *query_.shape, center, region.size, budget);
    if (proof.bad_point)
      *proof.bad_point -= center;
    return proof;
  }
  catch (const std::invalid_argument&)
  {
    return {};  // rounding loses the machine
  }
}

ContainmentResult Incumbent::check(const Candidate& region, const Budget& budget) const
{
  if (const OwnProof* own = query_.shape->ownProof())
    return own->prove(test_, region.center, region.size, budget);
  return query_.turns() ? checkTurned(region, budget)
                        : checkContainment(test_, *query_.shape, region.center, region.size, budget);
}

/// Bounds over all machines within tolerances have a gap between what is proved good and what is proved bad: half-way
/// to the best so far is most often beyond it.
void Incumbent::certifyLess(const Candidate& region)
{
  const double size = candidate_.size + 0.5 * (region.size - candidate_.size);
  if (region.size - size < WORTHWHILE * query_.accuracy)
    return;
  Candidate less = region;
  less.size = size;
  certify(less);
}

ContainmentResult Incumbent::certify(const Candidate& region)
{
  if (!asksFor(region.size))
    return {};
  Budget budget = budget_.rest();
  budget.max_boxes = allowedBoxes(region.size);
  const ContainmentResult proof = check(region, budget);
  boxes_ += proof.boxes;
  if (proof.verdict == Containment::INSIDE)
  {
    candidate_ = region;
    found_ = true;
  }
  else if (proof.boxes >= ROUND_VERIFICATION_BOXES)
    given_up_ = region.size;
  if (proof.verdict == Containment::UNDECIDED && machine_.hasTolerances())
    certifyLess(region);
  return proof;
}
}  // namespace pkm_workspace
