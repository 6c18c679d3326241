// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "checked_body.h"

namespace pkm_workspace
{
namespace checking
{
Ball ballOf(const Exact& x)
{
  return Ball(Ball::Middle(x), 0.0) * Ball(Ball::Middle(1), 0x1p-130);
}

CheckedBody::CheckedBody(const Json& json)
{
  need(json.is_object() && json.size() == 1, "one body is wanted");
  const std::string kind = json.begin().key();
  const Json& measures = json.begin().value();
  const auto measure = [](const Json& pair) {
    need(pair.is_array() && pair.size() == 2, "a measure is missing");
    return Measure{ numberOf(pair[0]), numberOf(pair[1]) };
  };
  need(kind == "box" || kind == "ball" || kind == "cylinder", "a body of a kind that is not known here");
  if (kind == "box")
    expect(measures, "a box", { "lower", "upper" });
  else
    expect(measures, "a round body",
           { "radius", kind == "ball" ? "radius" : "lower", kind == "ball" ? "radius" : "upper" });
  need(kind != "box" || (measures.at("lower").size() == 3 && measures.at("upper").size() == 3), "a measure is missing");
  round_ = kind == "box" ? 0 : kind == "ball" ? 3 : 2;
  for (std::size_t j = 0; j < 3; ++j)
    if (j < round_)
    {
      upper_[j] = measure(measures.at("radius"));
      lower_[j] = { -upper_[j].fixed, -upper_[j].per_size };
    }
    else
    {
      lower_[j] = measure(round_ == 0 ? measures.at("lower").at(j) : measures.at("lower"));
      upper_[j] = measure(round_ == 0 ? measures.at("upper").at(j) : measures.at("upper"));
    }
  for (std::size_t j = 0; j < 3; ++j)
    need(lower_[j].fixed <= 0.0 && lower_[j].per_size <= 0.0 && upper_[j].fixed >= 0.0 && upper_[j].per_size >= 0.0,
         "a body that does not hold its center");
}

bool CheckedBody::has(const Numbers& fixed, const Numbers& per_size) const
{
  Exact of_fixed = 0;
  Exact of_size = 0;
  for (std::size_t j = 0; j < 3; ++j)
  {
    if (fixed[j] < lower_[j].fixed || fixed[j] > upper_[j].fixed || per_size[j] < lower_[j].per_size ||
        per_size[j] > upper_[j].per_size)
      return false;
    if (j < round_)
    {
      of_fixed += Exact(fixed[j]) * Exact(fixed[j]);
      of_size += Exact(per_size[j]) * Exact(per_size[j]);
    }
  }
  return round_ == 0 || (of_fixed <= Exact(radius().fixed) * Exact(radius().fixed) &&
                         of_size <= Exact(radius().per_size) * Exact(radius().per_size));
}

std::optional<Jet> CheckedBody::avoidance(const Numbers& point, const Cube& centers, double h) const
{
  const JetVector c = pointsOf(centers);
  std::vector<Jet> beyond;  // one for each side that the point may be on
  for (std::size_t j = round_; j < 3; ++j)
  {
    if (Exact(point[j]) - Exact(centers.lower[j]) > upper_[j].at(h))
      beyond.push_back(Jet(Ball(point[j]) - ballOf(upper_[j].at(h))) - c[j]);
    if (Exact(point[j]) - Exact(centers.upper[j]) < lower_[j].at(h))
      beyond.push_back(c[j] - Jet(Ball(point[j]) - ballOf(lower_[j].at(h))));
  }
  if (round_ > 0)
  {
    const Ball radius = ballOf(this->radius().at(h));
    Jet squared = Jet(-(radius * radius));
    for (std::size_t j = 0; j < round_; ++j)
    {
      const Jet off = c[j] - Jet(Ball(point[j]));
      squared = squared + off * off;
    }
    beyond.push_back(squared);
  }
  if (beyond.size() > 1)
    return std::nullopt;
  return beyond.empty() ? Jet(Ball(-1.0)) : beyond.front();
}

RegionCheck::RegionCheck(const CheckedClaims& claims, const CheckedBody& body, const Json& json)
  : claims_(claims), body_(body), json_(json)
{
  expect(json, "the region", { "center", "size", "box", "tree" });
  center_ = numbersOf(json.at("center"));
  size_ = numberOf(json.at("size"));
  need(size_ >= 0.0, "a size below 0");
  for (std::size_t j = 0; j < 3; ++j)
  {
    lower_[j] = Exact(center_[j]) + body_.lower(j).at(size_);
    upper_[j] = Exact(center_[j]) + body_.upper(j).at(size_);
  }
  radius_ = body_.round() > 0 ? body_.radius().at(size_) : Exact(0);
}

void RegionCheck::run(const std::function<void()>& leaf) const
{
  const Cube root = cubeOf(json_.at("box"));
  for (std::size_t j = 0; j < 3; ++j)
    need(Exact(root.lower[j]) <= lower_[j] && upper_[j] <= Exact(root.upper[j]),
         "the region reaches beyond the box of its proof");
  walk(json_.at("tree"), root, [&](const Cube& box, const Json& node) {
    need(node == 0, "a leaf of the region says something");
    prove([this](const Cube& part) { return holds(part); }, box, MOST_SPLITS, "the criterion");
    leaf();
  });
  need(isInAspect(claims_, pointAt(center_)), "the center is in another aspect");
}

bool RegionCheck::isBeyond(const Cube& box) const
{
  Ball squared(0.0);
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Exact low(box.lower[j]);
    const Exact high(box.upper[j]);
    if (low > upper_[j] || high < lower_[j])
      return true;
    const Exact c(center_[j]);
    const Exact gap = low > c ? Exact(low - c) : high < c ? Exact(c - high) : Exact(0);
    if (j < body_.round())
      squared = squared + ballOf(gap) * ballOf(gap);
  }
  return body_.round() > 0 && (squared - ballOf(radius_) * ballOf(radius_)).isPositive();
}

/// Points whose hull has all points of the body in the box: its corners, or where a plane that touches a round body
/// cuts its edges.
std::vector<Corner> RegionCheck::cornersOf(const Cube& box) const
{
  const std::vector<Corner> corners = cornersOfCube();
  const JetVector p = pointsOf(box);
  std::array<Ball::Middle, 3> normal;
  Ball squared(0.0);
  for (std::size_t j = 0; j < body_.round(); ++j)
  {
    normal[j] = p[j].value.middle() - Ball::Middle(center_[j]);
    squared = squared + Ball(normal[j], 0.0) * Ball(normal[j], 0.0);
  }
  if (!squared.isPositive())
    return corners;
  // the body lies where normal . (x - c) <= radius |normal|
  Jet beyond = Jet(-(ballOf(radius_) * sqrt(squared)));
  for (std::size_t j = 0; j < body_.round(); ++j)
    beyond = beyond + Ball(normal[j], 0.0) * (p[j] - Jet(Ball(center_[j])));
  const auto excess = [&](const Corner& d) { return (beyond.value + scalarProduct(beyond.slope, d)).lower(); };
  std::vector<Corner> kept;
  for (const Corner& d : corners)
  {
    const Ball::Middle here = excess(d);
    if (here > 0)
      continue;
    kept.push_back(d);
    for (std::size_t j = 0; j < body_.round(); ++j)
    {
      Corner end = d;
      end[j] = -d[j];
      const Ball::Middle there = excess(end);
      if (!(there > 0))
        continue;
      // a little further than where the plane is
      const Ball way = Ball(2.0) * (Ball(-here, 0.0) / (Ball(there, 0.0) - Ball(here, 0.0))) + Ball(0x1p-100);
      end[j] = d[j] - d[j] * Ball(way.upper(), 0.0);
      kept.push_back(end);
    }
  }
  return kept;
}

bool RegionCheck::holds(const Cube& box) const
{
  return isBeyond(box) || isGood(claims_, pointsOf(box), cornersOf(box));
}
}  // namespace checking
}  // namespace pkm_workspace
