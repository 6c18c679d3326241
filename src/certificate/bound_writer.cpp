// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "certificate_json.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
namespace certificate
{
namespace
{
/// The power of a length that a condition's form is.
int powerOf(ConditionKind kind)
{
  return kind == ConditionKind::ASPECT                                              ? 3
         : kind == ConditionKind::JOINT_LOWER || kind == ConditionKind::JOINT_UPPER ? 1
                                                                                    : 2;
}

/// Writes the reasons of a search down.
class BoundWriter
{
public:
  BoundWriter(const Machine& machine, const RegionQuery& query, const SearchRecord& record)
    : test_(machine, query.criterion, query.precision)
    , query_(query)
    , record_(record)
    , length_(machine.scale())
    , travel_axis_(machine.hasParallelRails() ? mainAxisOfRails(machine) : -1)
  {}

  std::optional<Json> json(const Box& centers, double size) const
  {
    for (const auto& leaf : record_.leaves())
      if (!leaf.second.is_proved)
        return std::nullopt;
    std::size_t cuts = 0;  // a tree has one less than leaves
    const auto cutOf = [&](const Box& box) -> std::optional<std::pair<int, double>> {
      const int axis = box.widestAxis();
      if (record_.leaves().count(keyOf(box)) > 0 || !box.canBisect(axis) || ++cuts >= record_.leaves().size())
        return std::nullopt;
      return std::make_pair(axis, box.center()[axis]);
    };
    const auto leafOf = [&](const Box& box) {
      const auto leaf = record_.leaves().find(keyOf(box));
      return leaf == record_.leaves().end() ? Json() : leafJson(leaf->second);
    };
    const Json tree = treeJson(centers, cutOf, leafOf);
    if (std::count(tree.begin(), tree.end(), Json()) > 0)
      return std::nullopt;  // some boxes are open
    return Json{ { "size", size },
                 { "centers", toJson(centers) },
                 { "search_box", query_.search_box ? toJson(*query_.search_box) : Json() },
                 { "travel_axis", travel_axis_ >= 0 ? Json(travel_axis_) : Json() },
                 { "points", pointsJson() },
                 { "bad", badPointsJson() },
                 { "tree", tree } };
  }

private:
  Json pointsJson() const
  {
    Json points = Json::array();
    for (const GrowingVector& point : record_.points())
      points.push_back({ { "fixed", toJson(point.fixed) }, { "per_size", toJson(point.per_size) } });
    return points;
  }

  /// With what is violated there most.
  Json badPointsJson() const
  {
    Json points = Json::array();
    for (const Eigen::Vector3d& point : record_.badPoints())
    {
      points.push_back(violationJson(test_, { point, point }).value_or(Json::object()));
      points.back()["point"] = toJson(point);
    }
    return points;
  }

  /// Weights are of forms in metres, which the search makes numbers without unit.
  Json termJson(const SearchRecord::Term& term, double size) const
  {
    if (term.kind == ReasonTerm::Kind::BAD_POINT)
    {
      const double radius = query_.shape->isBox() ? 1.0 : query_.shape->upper().at(size).x();
      return { { "bad", term.place }, { "weight", shortened(term.weight / length_ / radius) } };
    }
    Json json = conditionJson(term.subject, term.v);
    json["at"] = term.place;
    const double per_length = std::ldexp(1.0, exponentPerLength(length_ * length_) * powerOf(term.subject.kind));
    json["weight"] = shortened(term.weight * (term.kind == ReasonTerm::Kind::TRAVEL ? 1.0 / length_ : per_length));
    return json;
  }

  Json leafJson(const SearchRecord::Leaf& leaf) const
  {
    Json terms = Json::array();
    for (const SearchRecord::Term& term : leaf.terms)
      terms.push_back(termJson(term, leaf.size));
    return { { "size", leaf.size }, { "terms", terms } };
  }

  const BoxTest test_;
  const RegionQuery& query_;
  const SearchRecord& record_;
  const double length_;    ///< [m]
  const int travel_axis_;  ///< along which rails are parallel, or -1
};
}  // namespace

std::optional<Json> boundJson(const Machine& machine, const RegionQuery& query, const SearchRecord& record,
                              const Box& centers, double size)
{
  return BoundWriter(machine, query, record).json(centers, size);
}
}  // namespace certificate
}  // namespace pkm_workspace
