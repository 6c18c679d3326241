// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
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

// Trees are long, and become text at once.

/// The text of each claim that there is, by its name.
using Claims = std::map<std::string, std::string>;
/// The whole file. @param shape nullptr where the claims are about none
std::string fileOf(const Machine& machine, const Criterion& criterion, const Shape* shape, const Claims& claims);

/// An object with one more member. @param text its value, JSON
std::string withMember(const Json& object, const std::string& name, const std::string& text);

/// To eight digits: reasons need no more.
void appendShort(double x, std::string& text);
/// The members that say a condition, and which leg or vector it is about.
void appendCondition(const Subject& subject, const std::array<double, 3>& v, std::string& text);
/// The same of what is violated most at all points of a box. @return false where no single form is
bool appendViolation(const BoxTest& test, const Box& box, std::string& text);

inline Key keyOf(const Box& box)
{
  return { box.lower[0], box.lower[1], box.lower[2], box.upper[0], box.upper[1], box.upper[2] };
}

inline void appendCut(int axis, double plane, std::string& text)
{
  text += '[' + std::to_string(axis) + ',' + Json(plane).dump() + ']';
}

/// A tree in the order in which it is walked: cuts, [axis, plane], each with its two parts behind it, and leaves.
/// @param cutOf std::optional<std::pair<int, double>>(const Box&) @param appendLeaf void(const Box&, std::string&)
template <class CutOf, class AppendLeaf>
std::string treeText(const Box& root, const CutOf& cutOf, const AppendLeaf& appendLeaf)
{
  std::string tree;
  std::vector<Box> open = { root };
  while (!open.empty())
  {
    const Box box = open.back();
    open.pop_back();
    tree += tree.empty() ? '[' : ',';
    const auto cut = cutOf(box);
    if (!cut)
    {
      appendLeaf(box, tree);
      continue;
    }
    appendCut(cut->first, cut->second, tree);
    const auto halves = box.splitAt(cut->first, cut->second);
    open.push_back(halves.second);
    open.push_back(halves.first);
  }
  return tree + ']';
}

/// The bound of a search, or nothing where a box has no reason to show.
/// @param centers the box that was searched
std::optional<std::string> boundText(const Machine& machine, const RegionQuery& query, const SearchRecord& record,
                                     const Box& centers, double size);
}  // namespace certificate
}  // namespace pkm_workspace
