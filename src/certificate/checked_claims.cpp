// SPDX-License-Identifier: BSD-3-Clause
#include "checked_claims.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace checking
{
void expect(const Json& object, const std::string& what, std::initializer_list<const char*> members)
{
  need(object.is_object(), what + " is missing");
  for (const auto& member : object.items())
    need(std::find(members.begin(), members.end(), member.key()) != members.end(),
         what + " has '" + member.key() + "', which is not known here");
}

double numberOf(const Json& json)
{
  need(json.is_number(), "a number is missing");
  const double number = json.get<double>();
  // integers that doubles do not tell apart reach 2^53 when they are rounded
  need(json.is_number_integer() ? std::abs(number) < 0x1p53 : std::abs(number) <= 1e100, "a number is out of range");
  return number;
}

Ball ballOf(const Json& json)
{
  if (!json.is_array())
    return numberOf(json);
  need(json.size() == 2 && numberOf(json[0]) <= numberOf(json[1]), "an enclosure that is none");
  return Ball::between(numberOf(json[0]), numberOf(json[1]));
}

Numbers numbersOf(const Json& json)
{
  need(json.is_array() && json.size() == 3, "a vector is missing");
  return { numberOf(json[0]), numberOf(json[1]), numberOf(json[2]) };
}

Vector vectorOf(const Json& json)
{
  need(json.is_array() && json.size() == 3, "a vector is missing");
  return { ballOf(json[0]), ballOf(json[1]), ballOf(json[2]) };
}

Cube cubeOf(const Json& json)
{
  need(json.is_array() && json.size() == 2, "a box is missing");
  return { numbersOf(json[0]), numbersOf(json[1]) };
}

std::string textOf(const Cube& box)
{
  return Json(box.lower).dump() + " to " + Json(box.upper).dump();
}

std::size_t indexOf(const Json& json, std::size_t count)
{
  need(json.is_number_unsigned() && json.get<std::uint64_t>() < count, "a number that counts nothing");
  return json.get<std::size_t>();
}

JetVector pointAt(const Numbers& p)
{
  return { Jet(Ball(p[0])), Jet(Ball(p[1])), Jet(Ball(p[2])) };
}

JetVector pointsOf(const Cube& box)
{
  JetVector points;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Ball lower(box.lower[j]);
    const Ball upper(box.upper[j]);
    points[j].value = Ball(0.5) * (lower + upper);
    points[j].slope[j] = Ball(0.5) * (upper - lower);
  }
  return points;
}

CheckedClaims::CheckedClaims(const Json& json)
{
  const Json& machine = json.at("machine");
  const Json& criterion = json.at("criterion");
  expect(machine, "the machine", { "name", "directions", "legs" });
  expect(criterion, "the criterion", { "aspect", "joint_limits", "psi_min", "psi_max" });
  const auto factor = [&](const char* name) {
    return criterion.contains(name) ? std::make_optional(ballOf(criterion.at(name))) : std::nullopt;
  };
  psi_min_ = factor("psi_min");
  psi_max_ = factor("psi_max");
  need((!psi_min_ || psi_min_->isPositive()) && (!psi_max_ || psi_max_->isPositive()), "a factor that is not positive");
  const double aspect = numberOf(criterion.at("aspect"));
  need(aspect == 0.0 || aspect == 1.0 || aspect == -1.0, "an aspect that is none of 1, 0, -1");
  aspect_ = static_cast<int>(aspect);
  joint_limits_ = criterion.at("joint_limits").get<bool>();
  const Json& directions = machine.at("directions");
  std::vector<Vector> axes;
  for (const Json& direction : directions)
  {
    axes.push_back(vectorOf(direction));
    const Ball squared = scalarProduct(axes.back(), axes.back()) - Ball(1.0);
    need(!squared.isPositive() && !squared.isNegative(), "a direction whose length is not 1");
  }
  need(directions.is_array() && machine.at("legs").is_array() && machine.at("legs").size() == 3,
       "a machine without three legs");
  for (const Json& leg : machine.at("legs"))
    legs_.push_back(readLeg(leg, axes, psi_max_));
}

bool CheckedClaims::hasParallelRails() const
{
  const auto* const first = dynamic_cast<const SlidingLeg*>(legs_[0].get());
  return first != nullptr && std::all_of(legs_.begin(), legs_.end(), [&](const auto& leg) {
           const auto* const sliding = dynamic_cast<const SlidingLeg*>(leg.get());
           return sliding != nullptr && sliding->direction() == first->direction();
         });
}

std::array<LegAt, 3> CheckedClaims::at(const JetVector& p) const
{
  return { legs_[0]->at(p), legs_[1]->at(p), legs_[2]->at(p) };
}

Question CheckedClaims::questionOf(const Json& json) const
{
  Question question;
  question.of = json.at("of").get<std::string>();
  if (question.of == "psi_min" || question.of == "psi_max")
  {
    question.v = vectorOf(json.at("v"));
    return question;
  }
  if (question.of == "aspect")
    return question;
  const double leg = numberOf(json.at("leg"));
  need(leg == 0.0 || leg == 1.0 || leg == 2.0, "no such leg");
  question.leg = static_cast<int>(leg);
  return question;
}

std::array<Jet, 6> CheckedClaims::matrix(bool is_largest, const std::array<LegAt, 3>& legs) const
{
  const std::optional<Ball>& factor = this->factor(is_largest);
  need(factor.has_value(), "a reason by a factor that is not asked for");
  const Ball sign(is_largest ? -1.0 : 1.0);
  const Ball limit = *factor * *factor;
  const auto square = [&](std::size_t i) { return sign * legs_[i]->diagonal(legs[i], limit); };
  const auto product = [&](std::size_t i, std::size_t j) { return sign * scalarProduct(legs[i].row, legs[j].row); };
  return { square(0), square(1), square(2), product(1, 2), product(0, 2), product(0, 1) };
}

Jet CheckedClaims::value(const Question& question, const std::array<LegAt, 3>& legs) const
{
  const auto i = static_cast<std::size_t>(question.leg);
  if (question.of == "psi_min" || question.of == "psi_max")
  {
    const std::array<Jet, 6> s = matrix(question.of == "psi_max", legs);
    const Vector& v = question.v;
    return v[0] * v[0] * s[0] + v[1] * v[1] * s[1] + v[2] * v[2] * s[2] +
           Ball(2.0) * (v[1] * v[2] * s[3] + v[0] * v[2] * s[4] + v[0] * v[1] * s[5]);
  }
  if (question.of == "reach")
    return legs[i].squared_drive - Jet(Ball(legs_[i]->least(), 0.0));
  for (const int side : { 0, 1 })
    if (question.of == (side == 0 ? "joint_lower" : "joint_upper") && hasLimit(question.leg, side))
      return legs_[i]->fromLimit(side, legs[i]);
  need(question.of == "aspect" && aspect_ != 0, "a reason by '" + question.of + "', which is not asked for");
  return Ball(aspect_) * scalarProduct(legs[0].row, vectorProduct(legs[1].row, legs[2].row));
}
}  // namespace checking
}  // namespace pkm_workspace
