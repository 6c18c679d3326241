// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "checked_body.h"

namespace pkm_workspace
{
namespace checking
{
namespace
{
Vector unit(std::size_t axis, int sign)
{
  Vector u;
  u[axis] = Ball(sign);
  return u;
}
}  // namespace

BoundCheck::BoundCheck(const CheckedClaims& claims, const CheckedBody& body, const Json& json)
  : claims_(claims), body_(body), json_(json)
{
  expect(json, "the bound", { "size", "centers", "search_box", "travel_axis", "points", "bad", "tree" });
  size_ = numberOf(json.at("size"));
  centers_ = cubeOf(json.at("centers"));
  if (!json.at("search_box").is_null())
    search_box_ = cubeOf(json.at("search_box"));
  if (!json.at("travel_axis").is_null())
  {
    travel_axis_ = indexOf(json.at("travel_axis"), 3);
    need(claims_.hasParallelRails(), "travel along rails that are not parallel");
    need(centers_.lower[*travel_axis_] == centers_.upper[*travel_axis_], "places that are not flat");
  }
  readPoints();
}

void BoundCheck::readPoints()
{
  for (const Json& point : json_.at("points"))
  {
    expect(point, "a point", { "fixed", "per_size" });
    points_.push_back({ numbersOf(point.at("fixed")), numbersOf(point.at("per_size")) });
    need(body_.has(points_.back().fixed, points_.back().per_size), "a point that the body does not have");
  }
  for (const Json& bad : json_.at("bad"))
  {
    expect(bad, "a bad point", { "point", "of", "leg", "v" });
    bad_.push_back({ numbersOf(bad.at("point")), claims_.questionOf(bad) });
    need(!travel_axis_ || push(bad_.back().why) == 0, "a bad point that others along the rails are not");
    const Ball value = claims_.value(bad_.back().why, claims_.at(pointAt(bad_.back().point))).value;
    need(value.isNegative(), "a point that is not proved to be bad");
  }
}

void BoundCheck::run(const std::function<void()>& leaf) const
{
  need(hasAllCenters(centers_), "centers may lie beyond the box of the search");
  walk(json_.at("tree"), centers_, [&](const Cube& box, const Json& node) {
    expect(node, "a leaf of the bound", { "size", "terms" });
    const double size = numberOf(node.at("size"));
    need(0.0 <= size && size <= size_, "a reason that is about larger regions only");
    std::vector<Term> terms;
    for (const Json& term : node.at("terms"))
      terms.push_back(termOf(term));
    prove([&](const Cube& part) { return excludes(terms, size, part); }, box, MOST_SPLITS, "the reason");
    leaf();
  });
}

/// The center of a body that satisfies the criterion does so itself.
bool BoundCheck::hasAllCenters(const Cube& box) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!isWithin(axis, -1, box.lower[axis]) || !isWithin(axis, 1, box.upper[axis]))
      return false;
  return true;
}

/// Whether no center lies beyond a face.
bool BoundCheck::isWithin(std::size_t axis, int sign, double face) const
{
  const auto& legs = claims_.legs();
  if (search_box_ && (!travel_axis_ || slider(0).isAlong(*travel_axis_)))
    if (sign > 0 ? search_box_->upper[axis] <= face : search_box_->lower[axis] >= face)
      return true;
  if (travel_axis_ == axis)
    return slider(0).axis()[axis].isPositive() || slider(0).axis()[axis].isNegative();
  const Vector u = unit(axis, sign);
  const Ball most(sign * face);
  if (travel_axis_)
    return isWithinPlaces(slider(0), u, most) || isWithinPlaces(slider(1), u, most) ||
           isWithinPlaces(slider(2), u, most);
  const auto endsBefore = [&](const auto& leg) {
    const std::optional<Ball> reach = leg->farthest(u, claims_.hasJointLimits());
    return reach && (*reach - most).upper() <= 0;
  };
  return isWithinReach(u, most) || std::any_of(legs.begin(), legs.end(), endsBefore);
}

/// @pre there is an axis of travel
const SlidingLeg& BoundCheck::slider(std::size_t leg) const
{
  return dynamic_cast<const SlidingLeg&>(*claims_.legs()[leg]);
}

/// By all three rails: E_i (p - c_i) = q_i. For M = E_1 + E_2 + E_3 and a with M a = det M u,
/// det M u . p = a . M p = sum of E_i a . c_i + a . q_i.
bool BoundCheck::isWithinReach(const Vector& u, const Ball& most) const
{
  std::array<Vector, 3> m;
  for (std::size_t j = 0; j < 3; ++j)
    for (const auto& leg : claims_.legs())
    {
      const Vector column = leg->across(unit(j, 1));
      for (std::size_t k = 0; k < 3; ++k)
        m[j][k] = m[j][k] + column[k];
    }
  const std::array<Vector, 3> adjoint = { vectorProduct(m[1], m[2]), vectorProduct(m[2], m[0]),
                                          vectorProduct(m[0], m[1]) };
  const Ball det = scalarProduct(m[0], adjoint[0]);
  const Vector a = { scalarProduct(adjoint[0], u), scalarProduct(adjoint[1], u), scalarProduct(adjoint[2], u) };
  Ball reach(0.0);
  for (const auto& leg : claims_.legs())
    reach = reach + scalarProduct(leg->across(a), leg->center()) + leg->offset(a);
  return det.isPositive() && (reach - det * most).upper() <= 0;
}

/// By one rail and the plane of places, where q_k + t e_k is known along its axis k:
/// e_k u . p = e_k u . c + (level - c_k) (e . u) + (e_k u - (e . u) k) . q.
bool BoundCheck::isWithinPlaces(const SlidingLeg& leg, const Vector& u, const Ball& most) const
{
  const std::size_t k = *travel_axis_;
  const Ball sign(leg.axis()[k].isPositive() ? 1.0 : -1.0);
  const Ball e_k = sign * leg.axis()[k];
  const Ball along = sign * scalarProduct(leg.axis(), u);
  Vector w = { e_k * u[0], e_k * u[1], e_k * u[2] };
  w[k] = w[k] - along;
  const Ball reach =
      e_k * scalarProduct(u, leg.center()) + (Ball(centers_.lower[k]) - leg.center()[k]) * along + leg.offset(w);
  return e_k.isPositive() && (reach - e_k * most).upper() <= 0;
}

BoundCheck::Term BoundCheck::termOf(const Json& json) const
{
  json.contains("bad") ? expect(json, "a term", { "bad", "weight" })
                       : expect(json, "a term", { "weight", "at", "of", "leg", "v" });
  Term term;
  term.weight = numberOf(json.at("weight"));
  need(term.weight >= 0.0, "a weight below 0");
  if (json.contains("bad"))
  {
    term.bad = indexOf(json.at("bad"), bad_.size());
    return term;
  }
  term.at = indexOf(json.at("at"), points_.size());
  term.question = claims_.questionOf(json);
  return term;
}

/// By how much travel along parallel rails makes a joint limit's condition grow.
int BoundCheck::push(const Question& question) const
{
  const int sign = question.of == "joint_lower" ? 1 : question.of == "joint_upper" ? -1 : 0;
  return travel_axis_ && sign != 0 ? sign * slider(static_cast<std::size_t>(question.leg)).sense() : 0;
}

bool BoundCheck::excludes(const std::vector<Term>& terms, double size, const Cube& box) const
{
  Jet sum;
  Exact travel = 0;
  const JetVector c = pointsOf(box);
  for (const Term& term : terms)
  {
    const Ball weight(term.weight);
    if (term.bad)
    {
      const std::optional<Jet> avoidance = body_.avoidance(bad_[*term.bad].point, box, size);
      if (!avoidance)
        return false;
      sum = sum + weight * *avoidance;
      continue;
    }
    const Point& point = points_[term.at];
    JetVector p;
    for (std::size_t j = 0; j < 3; ++j)
      p[j] = c[j] + Jet(Ball(point.fixed[j]) + Ball(size) * Ball(point.per_size[j]));
    const std::array<LegAt, 3> legs = claims_.at(p);
    for (std::size_t i = 0; i < 3; ++i)
      if ((legs[i].squared_drive.range() - Ball(claims_.legs()[i]->least(), 0.0)).isNegative())
        return true;  // a strut does not reach a point of the body, wherever its center
    sum = sum + weight * claims_.value(term.question, legs);
    travel += Exact(term.weight) * push(term.question);
  }
  return travel == 0 ? sum.range().isNegative() : excludesByTravel(sum, travel, box);
}

/// What is left of the travel is bounded by the search box, where rails run along its axis, or by a joint limit at the
/// center.
bool BoundCheck::excludesByTravel(const Jet& sum, const Exact& travel, const Cube& box) const
{
  const std::size_t k = *travel_axis_;
  if (search_box_ && slider(0).isAlong(k))
  {
    const bool is_up = (slider(0).sense() * slider(0).axis()[k]).isPositive() == (travel > 0);
    const Exact level(centers_.lower[k]);
    const Exact rest = is_up ? Exact(search_box_->upper[k]) - level : level - Exact(search_box_->lower[k]);
    if ((sum + Jet(ballOf(Exact(abs(travel) * rest)))).range().isNegative())
      return true;
  }
  const std::array<LegAt, 3> legs = claims_.at(pointsOf(box));
  for (int leg = 0; leg < 3; ++leg)
    for (const int side : { 0, 1 })
    {
      const Question limit{ side == 0 ? "joint_lower" : "joint_upper", leg };
      if (claims_.hasLimit(leg, side) && (push(limit) > 0) == (travel < 0) &&
          (sum + ballOf(Exact(abs(travel))) * claims_.value(limit, legs)).range().isNegative())
        return true;
    }
  return false;
}
}  // namespace checking
}  // namespace pkm_workspace
