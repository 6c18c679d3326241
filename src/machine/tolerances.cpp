// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/tolerances.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/tolerated_strut.h"

namespace pkm_workspace
{
namespace
{
constexpr double MOST_LENGTH = 1e3;  ///< [m]
constexpr double MOST_ANGLE = 0.1;   ///< [rad]

template <double StrutTolerance::*MEMBER>
double* one(StrutTolerance& tolerance)
{
  return &(tolerance.*MEMBER);
}
template <std::array<double, 3> StrutTolerance::*MEMBER>
double* three(StrutTolerance& tolerance)
{
  return (tolerance.*MEMBER).data();
}

std::size_t perLeg(const ToleranceKind& kind)
{
  return kind.is_per_axis ? 3 : 1;
}

/// Nine numbers or three, leg by leg.
std::vector<double> allNumbers(const ToleranceKind& kind, const Tolerances& tolerances)
{
  std::vector<double> all;
  for (StrutTolerance leg : tolerances)
    all.insert(all.end(), kind.values(leg), kind.values(leg) + perLeg(kind));
  return all;
}

void checkRange(const ToleranceKind& kind, const std::vector<double>& numbers)
{
  Problems problems;
  for (const double x : numbers)
    if (!(x >= 0.0) || x > kind.most)
      complain(problems, kind.name, " = ", exact(x), " ", kind.unit, " must be from 0 to ", kind.most, " ", kind.unit);
  throwProblems(problems, "");
}
}  // namespace

const std::array<ToleranceKind, 7> TOLERANCE_KINDS = { {
    { "tolerance_length", "m", MOST_LENGTH, false, &one<&StrutTolerance::length>, "of the struts' lengths" },
    { "tolerance_slider", "m", MOST_LENGTH, true, &three<&StrutTolerance::slider>,
      "of each coordinate of the struts' ends at the sliders" },
    { "tolerance_slider_ball", "m", MOST_LENGTH, false, &one<&StrutTolerance::slider_ball>,
      "of these ends in any direction: a distance" },
    { "tolerance_platform", "m", MOST_LENGTH, true, &three<&StrutTolerance::platform>,
      "of each coordinate of the struts' ends at the platform" },
    { "tolerance_platform_ball", "m", MOST_LENGTH, false, &one<&StrutTolerance::platform_ball>,
      "of these ends in any direction: a distance" },
    { "tolerance_direction", "rad", MOST_ANGLE, false, &one<&StrutTolerance::direction>,
      "of the rails' directions: an angle" },
    { "tolerance_zero", "m", MOST_LENGTH, false, &one<&StrutTolerance::zero>, "of the joints' zeros" },
} };

const ToleranceKind* toleranceKind(const std::string& name)
{
  const auto found = std::find_if(TOLERANCE_KINDS.begin(), TOLERANCE_KINDS.end(),
                                  [&](const ToleranceKind& kind) { return name == kind.name; });
  return found == TOLERANCE_KINDS.end() ? nullptr : &*found;
}

void setTolerance(const ToleranceKind& kind, const std::vector<double>& numbers, Tolerances& tolerances)
{
  const std::size_t each = perLeg(kind), count = numbers.size();
  if (count != 1 && count != 3 && count != 3 * each)
    throw std::invalid_argument(std::string(kind.name) + " has " + std::to_string(count) +
                                " numbers, expected one for all legs, three (one for each leg)" +
                                (each == 3 ? ", or nine (x, y, z of each leg)" : ""));
  checkRange(kind, numbers);
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (std::size_t k = 0; k < each; ++k)
      kind.values(tolerances[leg])[k] = numbers[count == 1 ? 0 : count == 3 ? leg : each * leg + k];
}

void setTolerance(const ToleranceKind& kind, const std::vector<double>& numbers, StrutTolerance& tolerance)
{
  const std::size_t each = perLeg(kind), count = numbers.size();
  if (count != 1 && count != each)
    throw std::invalid_argument(std::string(kind.name) + " has " + std::to_string(count) +
                                " numbers, expected one for a leg" + (each == 3 ? ", or three (x, y, z)" : ""));
  checkRange(kind, numbers);
  for (std::size_t k = 0; k < each; ++k)
    kind.values(tolerance)[k] = numbers[count == 1 ? 0 : k];
}

void GivenTolerances::set(const ToleranceKind& kind, const std::vector<double>& numbers)
{
  Tolerances valid;
  setTolerance(kind, numbers, valid);
  numbers_[indexOf(kind)] = numbers;
}

bool GivenTolerances::isEmpty() const
{
  return std::all_of(numbers_.begin(), numbers_.end(), [](const auto& numbers) { return numbers.empty(); });
}

Tolerances GivenTolerances::over(Tolerances others) const
{
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    if (has(kind))
      setTolerance(kind, numbers(kind), others);
  return others;
}

std::vector<double> numbersOf(const ToleranceKind& kind, const Tolerances& tolerances)
{
  const std::vector<double> all = allNumbers(kind, tolerances);
  const std::size_t each = perLeg(kind);
  const auto leg = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i * each); };
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::equal(leg(i), leg(i) + static_cast<std::ptrdiff_t>(each) - 1, leg(i) + 1))
      return all;
  const std::vector<double> by_leg = { *leg(0), *leg(1), *leg(2) };
  return by_leg[0] == by_leg[1] && by_leg[0] == by_leg[2] ? std::vector<double>{ by_leg[0] } : by_leg;
}

Tolerances tolerancesOf(const Machine& machine)
{
  Tolerances tolerances;
  for (std::size_t i = 0; i < 3; ++i)
    tolerances[i] = toleranceOf(machine.legs()[i]);
  return tolerances;
}

bool areZero(const Tolerances& tolerances)
{
  return std::all_of(tolerances.begin(), tolerances.end(), [](const StrutTolerance& t) { return t.isZero(); });
}

Machine withTolerances(const Machine& machine, const Tolerances& tolerances)
{
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
    setTolerance(tolerances[i], legs[i]);
  return { machine.name(), legs, machine.zero() };
}

Machine withGivenTolerances(const Machine& machine, const GivenTolerances& given)
{
  return given.isEmpty() ? machine : withTolerances(machine, given.over(tolerancesOf(machine)));
}

namespace
{
/// What of a coordinate's parameter is the box's part, the rest the ball's: all of the box where it is beyond it.
double boxShareOf(double parameter, double box)
{
  return box > 0.0 ? std::clamp(parameter / box, -1.0, 1.0) : 0.0;
}

/// Box and ball each move both ends of a strut, by as much of them as belongs to the end.
void moveEnds(SlidingStrut& strut, const StrutSpread& spread, const double* parameter)
{
  const StrutTolerance& by = strut.tolerance;
  const double both_balls = by.slider_ball + by.platform_ball;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const double of_box = boxShareOf(parameter[j], spread.set.box[j]);
    const double reach = by.slider[j] + by.platform[j] + both_balls;
    const double of_balls = both_balls > 0.0 ? (parameter[j] - spread.set.box[j] * of_box) * reach / both_balls : 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      strut.origin[k] += by.axes[k][j] * Interval(by.slider[j] * of_box + by.slider_ball * of_balls);
      strut.platform[k] += by.axes[k][j] * Interval(-by.platform[j] * of_box - by.platform_ball * of_balls);
    }
  }
}

void turnRail(SlidingStrut& strut, const StrutSpread& spread, const double* parameter)
{
  IntervalVector axis = strut.axis;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 2; ++j)
      axis[k] += Interval(parameter[4 + j]) * Interval(spread.axis_slopes[j][k]);
  const Interval length = norm(axis);
  for (std::size_t k = 0; k < 3; ++k)
    strut.axis[k] = axis[k] / length;
  strut.direction = 0;
}
}  // namespace

Machine builtWith(const Machine& machine, const std::array<double, 3 * STRUT_PARAMETERS>& parameters)
{
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
  {
    SlidingStrut& strut = slidingStrut(legs[i]);
    const StrutTolerance by = strut.tolerance;
    const StrutSpread spread = spreadOf(strut);
    const double* const parameter = parameters.data() + i * STRUT_PARAMETERS;
    moveEnds(strut, spread, parameter);
    if (by.direction > 0.0)
      turnRail(strut, spread, parameter);
    strut.length += Interval(by.length) * Interval(parameter[6]);
    const double off = by.zero * parameter[3];
    legs[i].limits = { legs[i].limits.lower() - off, legs[i].limits.upper() - off };
    strut.tolerance = {};
  }
  return { machine.name(), legs, machine.zero() };
}

std::string inWords(const Tolerances& tolerances)
{
  std::string text;
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
  {
    const std::vector<double> numbers = numbersOf(kind, tolerances);
    if (std::all_of(numbers.begin(), numbers.end(), [](double x) { return x == 0.0; }))
      continue;
    text += (text.empty() ? "" : ", ") + std::string(kind.name) + " +-";
    for (std::size_t k = 0; k < numbers.size(); ++k)
      text += (k == 0 ? numbers.size() > 1 ? "(" : "" : ", ") + exact(numbers[k]);
    text += (numbers.size() > 1 ? ") " : " ") + std::string(kind.unit);
  }
  return text;
}
}  // namespace pkm_workspace
