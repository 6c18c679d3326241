// SPDX-License-Identifier: BSD-3-Clause
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

/// What bad points violate: along parallel rails a point stands for all others, which joint limits tell apart.
Criterion badAllAlongRails(const Machine& machine, Criterion criterion)
{
  criterion.joint_limits = criterion.joint_limits && !machine.hasParallelRails();
  return criterion;
}

/// Writes the reasons of a search down.
class BoundWriter
{
public:
  BoundWriter(const Machine& machine, const RegionQuery& query, const SearchRecord& record)
    : test_(machine, badAllAlongRails(machine, query.criterion), query.precision)
    , query_(query)
    , record_(record)
    , length_(machine.scale())
    , travel_axis_(machine.hasParallelRails() ? mainAxisOfRails(machine) : -1)
  {}

  std::optional<std::string> text(const Box& centers, double size) const
  {
    for (const auto& leaf : record_.leaves())
      if (!leaf.second.is_proved)
        return std::nullopt;
    bool is_open = false;
    std::size_t cuts = 0;  // a tree has one less than leaves
    const auto cutOf = [&](const Box& box) -> std::optional<std::pair<int, double>> {
      const int axis = box.widestAxis();
      if (record_.leaves().count(keyOf(box)) > 0 || !box.canBisect(axis) || ++cuts >= record_.leaves().size())
        return std::nullopt;
      return std::make_pair(axis, box.center()[axis]);
    };
    const auto append = [&](const Box& box, std::string& tree) {
      const auto leaf = record_.leaves().find(keyOf(box));
      if (leaf == record_.leaves().end())
        is_open = true;
      else
        appendLeaf(leaf->second, tree);
    };
    const std::string tree = treeText(centers, cutOf, append);
    if (is_open)
      return std::nullopt;
    const Json bound{ { "size", size },
                      { "centers", toJson(centers) },
                      { "search_box", query_.search_box ? toJson(*query_.search_box) : Json() },
                      { "travel_axis", travel_axis_ >= 0 ? Json(travel_axis_) : Json() },
                      { "points", pointsJson() },
                      { "bad", badPointsJson() } };
    return withMember(bound, "tree", tree);
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
      std::string violation;
      appendViolation(test_, { point, point }, violation);
      points.push_back(Json::parse('{' + violation + '}'));
      points.back()["point"] = toJson(point);
    }
    return points;
  }

  /// Weights are of forms in metres, which the search makes numbers without unit.
  double weightOf(const SearchRecord::Term& term, double size) const
  {
    if (term.kind == ReasonTerm::Kind::BAD_POINT)
      return term.weight / length_ / (query_.shape->isBox() ? 1.0 : query_.shape->upper().at(size).x());
    if (term.kind == ReasonTerm::Kind::TRAVEL)
      return term.weight / length_;
    return std::ldexp(term.weight, exponentPerLength(length_ * length_) * powerOf(term.subject.kind));
  }

  void appendTerm(const SearchRecord::Term& term, double size, std::string& text) const
  {
    const bool is_bad_point = term.kind == ReasonTerm::Kind::BAD_POINT;
    if (!is_bad_point)
      appendCondition(term.subject, term.v, text);
    text += (is_bad_point ? "\"bad\":" : ",\"at\":") + std::to_string(term.place) + ",\"weight\":";
    appendShort(weightOf(term, size), text);
  }

  void appendLeaf(const SearchRecord::Leaf& leaf, std::string& text) const
  {
    text += "{\"size\":" + Json(leaf.size).dump() + ",\"terms\":[";
    for (std::size_t k = 0; k < leaf.terms.size(); ++k)
    {
      text += k == 0 ? "{" : ",{";
      appendTerm(leaf.terms[k], leaf.size, text);
      text += '}';
    }
    text += "]}";
  }

  const BoxTest test_;
  const RegionQuery& query_;
  const SearchRecord& record_;
  const double length_;    ///< [m]
  const int travel_axis_;  ///< along which rails are parallel, or -1
};
}  // namespace

std::optional<std::string> boundText(const Machine& machine, const RegionQuery& query, const SearchRecord& record,
                                     const Box& centers, double size)
{
  return BoundWriter(machine, query, record).text(centers, size);
}
}  // namespace certificate
}  // namespace pkm_workspace
