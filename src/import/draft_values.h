// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "decimal_number.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/common/text.h"
#include "pkm_workspace/import/machine_draft.h"

namespace pkm_workspace
{
constexpr double DEGREE = M_PI / 180.0;

/// Turns the texts of a draft into numbers and collects what is wrong.
class DraftValues
{
public:
  using Kind = DraftKey::Kind;
  using Map = std::map<std::string, MachineDraft::Given>;

  explicit DraftValues(const std::string& unit) : unit_(unit) {}

  Problems problems;
  bool turns = false;  ///< whether the leg that is being read is a crank

  /// The values of a key in metres and radians. @return nothing where it was not given
  std::optional<std::vector<double>> find(const Map& values, const std::string& name, Kind kind)
  {
    const auto given = values.find(name);
    if (given == values.end())
      return std::nullopt;
    std::vector<double> numbers;
    for (const std::string& text : given->second.texts)
      numbers.push_back(number(text, name, kind, given->second.place));
    return numbers;
  }
  double one(const Map& values, const char* name, Kind kind, double otherwise)
  {
    const auto numbers = find(values, name, kind);
    return numbers ? numbers->front() : otherwise;
  }
  Eigen::Vector3d three(const Map& values, const char* name, Kind kind)
  {
    const auto numbers = find(values, name, kind);
    return numbers ? Eigen::Vector3d(numbers->data()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }

  /// Which of the words was given; the first where none was.
  template <std::size_t N>
  std::size_t word(const Map& values, const char* name, const std::array<const char*, N>& words)
  {
    const auto given = values.find(name);
    if (given == values.end())
      return 0;
    const std::string& text = given->second.texts.front();
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end())
      complain(problems, given->second.place, ": ", name, " = '", shortened(text, 60), "', expected ",
               joined({ words.begin(), words.end() }, " or "));
    return found == words.end() ? 0 : static_cast<std::size_t>(found - words.begin());
  }

private:
  std::string expected(Kind kind) const
  {
    if (kind == Kind::SIGN)
      return "-1 or 1";
    if (kind == Kind::SPEED || kind == Kind::FORCE)
      return std::string("a positive number [") +
             (kind == Kind::SPEED ? (turns ? "rad/s" : "m/s") : (turns ? "N m" : "N")) + "]";
    return "a number [" + (kind == Kind::LENGTH ? unit_ : "degrees") + "]";
  }

  double number(const std::string& text, const std::string& name, Kind kind, const std::string& place)
  {
    const auto decimal = firmware::Decimal::parse(text);
    const bool is_drive = kind == Kind::SPEED || kind == Kind::FORCE;
    if (!decimal || (kind == Kind::SIGN && std::abs(decimal->nearest()) != 1.0) ||
        (is_drive && !(decimal->nearest() > 0.0)))
      complain(problems, place, ": ", name, " = '", shortened(text, 60), "', expected ", expected(kind));
    if (!decimal)
      return 0.0;
    if (kind == Kind::LENGTH)
      return unit_ == "mm" ? (*decimal * firmware::Decimal(1, -3)).nearest() : decimal->nearest();
    return kind == Kind::ANGLE ? decimal->nearest() * DEGREE : decimal->nearest();
  }

  std::string unit_;
};
}  // namespace pkm_workspace
