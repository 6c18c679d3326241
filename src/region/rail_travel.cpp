// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/rail_travel.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/interval/centered_box.h"
#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

const Box NOWHERE{ Vector3d::Constant(INF), Vector3d::Constant(-INF) };
}  // namespace

RailTravel::RailTravel(const Machine& machine, const RegionQuery& query, double size_bound)
  : machine_(machine)
  , model_(machine, query.criterion)
  , criterion_(query.criterion)
  , shape_(query.shape)
  , search_box_(query.search_box)
  , axis_(mainAxisOfRails(machine))
  , direction_(mid(directionOfRails(machine)))
{
  for (int i = 0; i < 3; ++i)
  {
    const auto leg = static_cast<std::size_t>(i);
    senses_[leg] = parallelSense(machine.leg(0), machine.leg(i));
    limits_[leg] = criterion_.joint_limits ? Interval(senses_[leg]) * machine.leg(i).limits : Interval::entire();
  }
  level_ = query.levelAlong(axis_, machine);
  places_ = placesAt(level_);
  binds_ = search_box_ || !alwaysLeavesTravel(size_bound);
  for (int round = 0; binds_ && places_.isValid() && round < 2; ++round)
  {
    const Interval travel = travelOver(places_);
    binds_ = travel.isEmpty() || travel.isBounded();
    if (travel.isEmpty())
      places_ = NOWHERE;
    else if (binds_ && round == 0)
    {
      level_ += direction_[axis_] * travel.mid();  // any level is as good: this one makes the reach small
      places_ = placesAt(level_);
    }
    else if (binds_)
      reach_ = travel.magnitude();
  }
}

/// Those of the search box are c - t e, where t leads from the level to c.
Box RailTravel::placesAt(double level) const
{
  Box places = boundsAcrossRails(machine_, criterion_, axis_, level);
  if (!search_box_)
    return places;
  const IntervalVector& e = directionOfRails(machine_);
  const Interval t = (search_box_->side(axis_) - Interval(level)) / e[static_cast<std::size_t>(axis_)];
  Box projected = boundingBox(enclose(*search_box_) - t * e);
  projected.lower[axis_] = projected.upper[axis_] = level;
  return intersection(places, projected);
}

/// sense * eta, which is what lies along e of the strut.
Interval RailTravel::alongRail(int leg) const
{
  return Interval(sense(leg)) * driveRange(machine_.enclosed(leg), steepest(machine_, criterion_));
}

Interval RailTravel::jointRange(int leg, const Box& places) const
{
  return dot(directionOfRails(machine_), enclose(places) - machine_.center(leg)) - alongRail(leg);
}

Interval RailTravel::travelOver(const Box& places) const
{
  Interval travel = Interval::entire();
  if (search_box_)
    travel =
        (search_box_->side(axis_) - places.side(axis_)) / directionOfRails(machine_)[static_cast<std::size_t>(axis_)];
  for (int i = 0; i < 3 && !travel.isEmpty(); ++i)
    travel = intersection(travel, limits_[static_cast<std::size_t>(i)] - jointRange(i, places));
  return travel;
}

/// For each two legs i and j and points p and p' of one region: (U_j - r_j(p')) - (L_i - r_i(p)) >= 0, by
/// r_i(p) - r_j(p') = e . (p - p') + e . (c_j - c_i) + sense_j eta_j - sense_i eta_i.
bool RailTravel::alwaysLeavesTravel(double size_bound) const
{
  const IntervalVector& e = directionOfRails(machine_);
  const Growing<Interval> first = shape_->support({ -e[0], -e[1], -e[2] });
  const Growing<Interval> last = shape_->support(e);
  const Interval extent = first.per_size + last.per_size;
  const Interval growth = extent == Interval(0.0) ? extent : extent * Interval(0.0, std::max(0.0, size_bound));
  const Interval apart = first.fixed + last.fixed + growth;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const double lower = limits_[static_cast<std::size_t>(i)].lower();
      const double upper = limits_[static_cast<std::size_t>(j)].upper();
      if (!std::isfinite(lower) || !std::isfinite(upper))
        continue;
      const Interval centers = dot(e, machine_.center(j) - machine_.center(i));
      const Interval room = Interval(upper) - Interval(lower) + centers + alongRail(j) - alongRail(i) - apart;
      if (!(room.lower() >= 0.0))
        return false;
    }
  return true;
}

Box RailTravel::centers() const
{
  if (!places_.isValid())
    return places_;
  const Box box = boundingBox(enclose(places_) + Interval(-reach_, reach_) * directionOfRails(machine_));
  return search_box_ ? intersection(box, *search_box_) : box;
}

void RailTravel::addForms(const CenteredBox<double>& points, std::vector<TravelForm>& forms) const
{
  if (!binds_)
    return;
  const JointLimits<double>& limits = model_.condition<JointLimits>();
  const MachineForms<double> machine = model_.legs().evaluate(points);
  const Place<double, CenteredBox<double>> place{ model_.legs(), machine, points };
  for (int leg = 0; leg < 3; ++leg)
    for (const int side : { 0, 1 })
    {
      if (!limits.limited(static_cast<std::size_t>(leg), side))
        continue;
      AffineForm<double> form = limits.form(static_cast<std::size_t>(leg), side, place);
      form.gradient[static_cast<std::size_t>(axis_)] = (side == 0 ? sense(leg) : -sense(leg)) * reach_;
      const ConditionKind kind = side == 0 ? ConditionKind::JOINT_LOWER : ConditionKind::JOINT_UPPER;
      forms.push_back({ form, Subject{ kind, static_cast<std::size_t>(leg) } });
    }
}

void RailTravel::addSearchBox(const Box& places, std::vector<TravelForm>& forms) const
{
  const CenteredBox<double> centered(places);
  AffineForm<double> travel;
  travel.gradient[static_cast<std::size_t>(axis_)] = reach_;
  for (int j = 0; binds_ && search_box_ && j < 3; ++j)
  {
    const Interval& e = directionOfRails(machine_)[static_cast<std::size_t>(j)];
    if (j == axis_ || e == Interval(0.0))
      continue;
    const AffineForm<double> center = coordinate(centered, static_cast<std::size_t>(j)) + Enclosed<double>(e) * travel;
    forms.push_back({ center + Enclosed<double>(Interval(-search_box_->lower[j])) });
    forms.push_back({ -center + Enclosed<double>(Interval(search_box_->upper[j])) });
  }
}

Vector3d RailTravel::placeOf(const Vector3d& point) const
{
  Vector3d place = point - (point[axis_] - level_) / direction_[axis_] * direction_;
  place[axis_] = level_;
  return place;
}

RailTravel::Travel RailTravel::travelAt(const Vector3d& place, double size,
                                        const std::vector<GrowingVector>& points) const
{
  Travel travel{ -INF, INF };
  const auto leave = [&travel](double lower, double upper) {
    travel.lower = std::max(travel.lower, lower);
    travel.upper = std::min(travel.upper, upper);
  };
  const auto ask = [&](const Vector3d& p) {
    const auto rho = inverseKinematics(machine_, p);
    for (std::size_t i = 0; rho && i < 3; ++i)
    {
      const double joint = senses_[i] * (*rho)[static_cast<int>(i)];
      leave(limits_[i].lower() - joint, limits_[i].upper() - joint);
    }
  };
  ask(place);
  for (const GrowingVector& k : points)
    ask(place + k.at(size));
  for (int j = 0; search_box_ && j < 3; ++j)
    if (direction_[j] != 0.0)
    {
      const double first = (search_box_->lower[j] - place[j]) / direction_[j];
      const double last = (search_box_->upper[j] - place[j]) / direction_[j];
      leave(std::min(first, last), std::max(first, last));
    }
  return travel;
}

bool RailTravel::leavesCenter(const Vector3d& place, double size, const std::vector<GrowingVector>& points) const
{
  const Travel travel = travelAt(place, size, points);
  return travel.lower <= travel.upper;
}

Vector3d RailTravel::centerAt(const Vector3d& place, double size, const std::vector<GrowingVector>& points) const
{
  const Travel travel = travelAt(place, size, points);
  const double strut = machine_.scale();
  const bool from_below = travel.lower > -INF;
  const bool from_above = travel.upper < INF;
  const double t = from_below && from_above ? 0.5 * (travel.lower + travel.upper)
                   : from_below             ? travel.lower + strut
                   : from_above             ? travel.upper - strut
                                            : 0.0;
  const Vector3d center = place + t * direction_;
  return search_box_ ? Vector3d(center.cwiseMax(search_box_->lower).cwiseMin(search_box_->upper)) : center;
}
}  // namespace pkm_workspace
