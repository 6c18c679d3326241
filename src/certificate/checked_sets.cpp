// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "checked_body.h"

namespace pkm_workspace
{
namespace checking
{
namespace
{
/// A function over a box, but for a radius affine in delta.
struct Affine
{
  Ball::Middle center;
  std::array<Ball::Middle, 3> slope;
  double radius;

  explicit Affine(const Jet& f)
    : center(f.value.middle())
    , slope{ f.slope[0].middle(), f.slope[1].middle(), f.slope[2].middle() }
    , radius((Ball(Ball::Middle(0), f.value.radius()) + Ball(Ball::Middle(0), f.slope[0].radius()) +
              Ball(Ball::Middle(0), f.slope[1].radius()) + Ball(Ball::Middle(0), f.slope[2].radius()))
                 .radius())
  {}
  Ball at(const std::array<Ball, 3>& delta) const
  {
    Ball value(center, radius);
    for (std::size_t j = 0; j < 3; ++j)
      value = value + Ball(slope[j], 0.0) * delta[j];
    return value;
  }
};

/// Whether a symmetric matrix (11, 22, 33, 23, 13, 12) is positive definite: by the pivots of its elimination.
bool isDefinite(const std::array<Ball, 6>& m)
{
  if (!m[0].isPositive())
    return false;
  const Ball l2 = m[5] / m[0];
  const Ball l3 = m[4] / m[0];
  const Ball second = m[1] - l2 * m[5];
  if (!second.isPositive())
    return false;
  const Ball rest = m[3] - l3 * m[5];
  return (m[2] - l3 * m[4] - rest / second * rest).isPositive();
}
}  // namespace

std::vector<Corner> cornersOfCube()
{
  std::vector<Corner> corners;
  for (int index = 0; index < 8; ++index)
    corners.push_back({ Ball(index & 1 ? 1.0 : -1.0), Ball(index & 2 ? 1.0 : -1.0), Ball(index & 4 ? 1.0 : -1.0) });
  return corners;
}

bool isGood(const CheckedClaims& claims, const JetVector& points, const std::vector<Corner>& corners)
{
  const std::array<LegAt, 3> legs = claims.at(points);
  std::vector<Question> questions;
  for (int leg = 0; leg < 3; ++leg)
  {
    questions.push_back({ "reach", leg });
    for (const int side : { 0, 1 })
      if (claims.hasLimit(leg, side))
        questions.push_back({ side == 0 ? "joint_lower" : "joint_upper", leg });
  }
  if (claims.aspect() != 0 && !claims.factor(false))
    questions.push_back({ "aspect" });
  const auto isGood = [&](const Question& question) {
    const Affine f(claims.value(question, legs));
    return std::all_of(corners.begin(), corners.end(), [&](const Corner& d) { return f.at(d).lower() >= 0; });
  };
  const auto isBounded = [&](bool is_largest) {
    if (!claims.factor(is_largest))
      return true;
    std::vector<Affine> entries;
    for (const Jet& entry : claims.matrix(is_largest, legs))
      entries.emplace_back(entry);
    return std::all_of(corners.begin(), corners.end(), [&](const Corner& d) {
      return isDefinite({ entries[0].at(d), entries[1].at(d), entries[2].at(d), entries[3].at(d), entries[4].at(d),
                          entries[5].at(d) });
    });
  };
  return std::all_of(questions.begin(), questions.end(), isGood) && isBounded(false) && isBounded(true);
}

bool isInAspect(const CheckedClaims& claims, const JetVector& point)
{
  return claims.aspect() == 0 || !claims.factor(false) ||
         claims.value({ "aspect" }, claims.at(point)).value.isPositive();
}

BoxesCheck::BoxesCheck(const CheckedClaims& claims, const Json& json) : claims_(claims), json_(json)
{
  expect(json, "the boxes", { "box", "tree" });
}

std::string BoxesCheck::run(const std::function<void()>& leaf) const
{
  std::size_t good = 0;
  std::size_t bad = 0;
  const std::vector<Corner> corners = cornersOfCube();
  walk(json_.at("tree"), cubeOf(json_.at("box")), [&](const Cube& box, const Json& node) {
    if (node.is_object())
    {
      expect(node, "a leaf of the boxes", { "of", "leg", "v" });
      const Question question = claims_.questionOf(node);
      prove([&](const Cube& part) { return excludes(question, part); }, box, MOST_SPLITS, "the reason");
      ++bad;
    }
    else if (node == 1)
    {
      prove([&](const Cube& part) { return isGood(claims_, pointsOf(part), corners); }, box, MOST_SPLITS,
            "the criterion");
      need(isInAspect(claims_, pointAt(box.lower)), "a box is in another aspect");
      ++good;
    }
    else
      need(node == 0, "a leaf that is none");
    leaf();
  });
  return "every point of the boxes inside satisfies the criterion (" + std::to_string(good) +
         "), no point of those outside (" + std::to_string(bad) + ")";
}

/// Either a strut does not reach, or the condition is violated.
bool BoxesCheck::excludes(const Question& question, const Cube& box) const
{
  const std::array<LegAt, 3> legs = claims_.at(pointsOf(box));
  for (std::size_t i = 0; i < 3; ++i)
    if ((legs[i].squared_drive.range() - Ball(claims_.legs()[i]->least(), 0.0)).isNegative())
      return true;
  return claims_.value(question, legs).range().isNegative();
}

std::string checkPath(const CheckedClaims& claims, const Json& json, const std::function<void()>& leaf)
{
  need(json.is_array() && !json.empty(), "a path without segments");
  std::size_t pieces = 0;
  for (const Json& segment : json)
  {
    need(segment.is_array() && segment.size() == 3, "a segment that is none");
    const JetVector start = pointAt(numbersOf(segment[0]));
    const JetVector end = pointAt(numbersOf(segment[1]));
    need(isInAspect(claims, start), "a segment is in another aspect");
    const auto isGoodFor = [&](const Cube& times) {
      const Jet t = pointsOf(times)[0];
      const auto at = [&](std::size_t k) { return start[k] + t * (end[k] - start[k]); };
      return isGood(claims, { at(0), at(1), at(2) }, cornersOfCube());
    };
    const Json& cuts = segment[2];
    need(cuts.is_array() && cuts.size() > 1 && cuts.front() == 0 && cuts.back() == 1,
         "pieces that are not the whole segment");
    for (std::size_t k = 1; k < cuts.size(); ++k, ++pieces)
    {
      const Cube times{ { numberOf(cuts[k - 1]), 0.0, 0.0 }, { numberOf(cuts[k]), 0.0, 0.0 } };
      need(times.lower[0] <= times.upper[0], "pieces that are not in order");
      prove(isGoodFor, times, MOST_SPLITS, "the criterion");
      leaf();
    }
  }
  return "every point of the path satisfies the criterion (segments: " + std::to_string(json.size()) +
         ", pieces: " + std::to_string(pieces) + ")";
}
}  // namespace checking
}  // namespace pkm_workspace
