// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/comparison.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/region_parts.h"

namespace pkm_workspace
{
namespace
{
/// Computations that share the time limit: the region, the volumes, the singularities of two sets.
constexpr double PARTS = 4.0;

Interval power(const Interval& x, int exponent)
{
  Interval product(1.0);
  for (int k = 0; k < exponent; ++k)
    product *= x;
  return product;
}

void addSingularities(const Singularities& found, const std::string& key, const std::string& where,
                      std::vector<Figure>& figures)
{
  figures.push_back({ key + "_least_eta", "least |eta| [m] " + where, 1, least(found.serial).least });
  figures.push_back({ key + "_least_det_a", "least |det A| [m^3] " + where, 3, found.parallel.least });
}
}  // namespace

std::array<Interval, 3> Comparison::each(Interval JointRange::*part) const
{
  return { region.joint_ranges[0].*part, region.joint_ranges[1].*part, region.joint_ranges[2].*part };
}

Interval Comparison::largest(Interval JointRange::*part) const
{
  Interval most = region.joint_ranges[0].*part;
  for (const JointRange& range : region.joint_ranges)
    most = { std::max(most.lower(), (range.*part).lower()), std::max(most.upper(), (range.*part).upper()) };
  return most;
}

Comparison comparisonOf(const Machine& machine, const RegionQuery& query, double volume_accuracy, const Tell& tell)
{
  Comparison study{ machine, query, {} };
  study.query.criterion = withJointData(machine, query.criterion);
  const Criterion::Aspect aspect = query.criterion.aspect;
  if (aspect == Criterion::Aspect::BOTH)
    throw std::invalid_argument("machines are compared in one aspect: ask for their own or for the other one");
  if (query.turns())
    throw std::invalid_argument(NOT_TURNED);
  for (const Leg& leg : machine.legs())
    if (hasAngle(leg))
      throw std::invalid_argument("machines are compared by the strokes of their joints [m]; joint '" + leg.joint +
                                  "' of '" + machine.name() + "' turns: ask for the largest region of each by itself");
  study.query.budget = query.budget.inTurns(PARTS);
  study.query.progress = [&](const RegionProgress& state) {
    tell(machine.name() + ", largest region: " +
         (query.ratio ? "volume " + bracket(state.volume, state.volume_upper_bound) + " m^3"
                      : "size " + bracket(state.size, state.size_upper_bound)));
  };
  const Budget& budget = study.query.budget;
  study.region = findLargestRegion(machine, study.query);
  study.query.progress = nullptr;
  if (!(study.region.size > 0.0))
    return study;
  study.ranges = equalisedRanges(study.each(&JointRange::lower), study.each(&JointRange::stroke));
  tell(machine.name() + ", volume for the strokes");
  study.workspace = workspaceOfRanges(machine, { study.ranges, volume_accuracy, budget, aspect });
  const auto singularities = [&budget](const Machine& in, SingularityQuery of) {
    const std::int64_t most = of.budget.max_boxes;
    of.budget = budget;
    of.budget.max_boxes = budget.max_boxes > 0 ? std::min(most, budget.max_boxes) : most;
    return findSingularities(in, of);
  };
  tell(machine.name() + ", singularities");
  study.in_region =
      singularities(machine, singularitiesOver(study.region.shape, study.region.center, study.region.size));
  SingularityQuery in_ranges;
  in_ranges.joint_limits = true;
  in_ranges.surely_within = study.ranges.inner;
  study.in_ranges = singularities(withJointLimits(machine, study.ranges.outer), in_ranges);
  return study;
}

Interval Figure::scaled(double size) const
{
  if (value.isEmpty() || power == 0)
    return value;
  const Interval unit = pkm_workspace::power(Interval(size), power);
  const Interval lower = Interval(value.lower()) / unit;
  return value.isBounded() ? value / unit : Interval(lower.lower(), value.upper());
}

std::string sizeOf(const Shape& shape)
{
  return shape.name() + ": " + shape.sizeMeaning();
}

std::vector<Figure> figuresOf(const Comparison& study)
{
  const LargestRegion& region = study.region;
  if (!(region.size > 0.0))
    return {};
  const Shape& shape = *region.shape;
  Interval strut = lengthOf(study.machine.enclosed(0));
  for (int i = 1; i < 3; ++i)
  {
    const Interval length = lengthOf(study.machine.enclosed(i));
    strut = { std::max(strut.lower(), length.lower()), std::max(strut.upper(), length.upper()) };
  }
  const bool is_own = study.query.criterion.aspect == Criterion::Aspect::OWN;
  const Interval& all = is_own ? study.workspace.own_aspect : study.workspace.other_aspect;
  const Interval& more = is_own ? study.workspace.other_aspect : study.workspace.own_aspect;
  // of a free ratio, what is bracketed is the volume
  const Interval size(region.size, region.ratio ? region.size : region.size_upper_bound);
  std::vector<Figure> figures = {
    { "size", sizeOf(shape), 1, size },
    { "strut", "longest strut [m]", 1, strut },
    { "stroke", "largest stroke, Delta rho [m]", 1, study.largest(&JointRange::stroke) },
    { "across", "its part Delta f [m]", 1, study.largest(&JointRange::across) },
    { "workspace_volume", "volume for these strokes [m^3]", 3, all },
    { "other_aspect_volume", is_own ? "  more in the other aspect [m^3]" : "  more in the own aspect [m^3]", 3, more },
  };
  if (shape.volume(1.0).lower() > 0.0)
  {
    const Interval volume = shape.volume(region.size);
    if (region.ratio)
      figures.push_back({ "largest_volume",
                          "largest volume of a " + shape.name() + " [m^3]",
                          3,
                          { region.volume, region.volume_upper_bound } });
    figures.push_back({ "region_volume", "volume of the region [m^3]", 3, volume });
    figures.push_back({ "volume_ratio", "  its share of the volume", 0,
                        all.lower() > 0.0 ? intersection(volume / all, { 0.0, 1.0 }) : Interval(0.0, 1.0) });
  }
  addSingularities(study.in_region, "region", "in the region", figures);
  addSingularities(study.in_ranges, "ranges", "in these strokes", figures);
  return figures;
}

SingularityAnswer least(const std::array<SingularityAnswer, 3>& serial)
{
  using Status = SingularityAnswer::Status;
  SingularityAnswer all = serial[0];
  for (const SingularityAnswer& leg : { serial[1], serial[2] })
  {
    all.boxes += leg.boxes;
    if (!leg.least.isEmpty())
      all.least = all.least.isEmpty() ? leg.least
                                      : Interval(std::min(all.least.lower(), leg.least.lower()),
                                                 std::min(all.least.upper(), leg.least.upper()));
    if (leg.status == Status::PROVED || all.status == Status::NONE)
    {
      all.status = leg.status;
      all.box = leg.box;
    }
  }
  return all;
}
}  // namespace pkm_workspace
