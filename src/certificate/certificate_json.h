// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "pkm_workspace/certificate/certificate.h"

namespace pkm_workspace
{
namespace certificate
{
// The members of a certificate (docs/certificate.md).

using Json = nlohmann::json;
using Key = SearchRecord::Key;

inline Json toJson(const Interval& x)
{
  return x.isSingle() ? Json(x.lower()) : Json{ x.lower(), x.upper() };
}

inline Json toJson(const Eigen::Vector3d& v)
{
  return { v[0], v[1], v[2] };
}

inline Json toJson(const IntervalVector& v)
{
  return { toJson(v[0]), toJson(v[1]), toJson(v[2]) };
}

inline Json toJson(const Box& box)
{
  return { toJson(box.lower), toJson(box.upper) };
}

/// All but the claims, which are null. @param shape nullptr where they are about none
Json headerOf(const Machine& machine, const Criterion& criterion, const Shape* shape);

/// To eight digits: reasons need no more.
double shortened(double x);
/// A condition, and which leg or vector it is about.
Json conditionJson(const Subject& subject, const std::array<double, 3>& v);
/// What is violated most at all points of a box, or nothing where no single form is.
std::optional<Json> violationJson(const BoxTest& test, const Box& box);

inline Key keyOf(const Box& box)
{
  return { box.lower[0], box.lower[1], box.lower[2], box.upper[0], box.upper[1], box.upper[2] };
}

/// Appends a tree in the order in which it is walked: cuts, [axis, plane], each with its two parts behind it, and
/// leaves.
/// @param cutOf std::optional<std::pair<int, double>>(const Box&) @param leafOf Json(const Box&)
template <class CutOf, class LeafOf>
Json treeJson(const Box& root, const CutOf& cutOf, const LeafOf& leafOf)
{
  Json tree = Json::array();
  std::vector<Box> open = { root };
  while (!open.empty())
  {
    const Box box = open.back();
    open.pop_back();
    const auto cut = cutOf(box);
    if (!cut)
    {
      tree.push_back(leafOf(box));
      continue;
    }
    tree.push_back({ cut->first, cut->second });
    const auto halves = box.splitAt(cut->first, cut->second);
    open.push_back(halves.second);
    open.push_back(halves.first);
  }
  return tree;
}

/// The bound of a search, or nothing where a box has no reason to show.
/// @param centers the box that was searched
std::optional<Json> boundJson(const Machine& machine, const RegionQuery& query, const SearchRecord& record,
                              const Box& centers, double size);
}  // namespace certificate
}  // namespace pkm_workspace
