// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/machine.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "pkm_workspace/common/name_uuid.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace
{
bool isBounded(const IntervalVector& v)
{
  return v[0].isBounded() && v[1].isBounded() && v[2].isBounded();
}

IntervalVector timesSense(int sense, const IntervalVector& v)
{
  return sense > 0 ? v : IntervalVector{ -v[0], -v[1], -v[2] };
}

bool isSingle(const IntervalVector& v)
{
  return v[0].isSingle() && v[1].isSingle() && v[2].isSingle();
}

/// 1 for the same numbers, -1 for the opposite ones, otherwise 0.
int senseOfNumbers(const IntervalVector& a, const IntervalVector& b)
{
  return a == b ? 1 : a == timesSense(-1, b) ? -1 : 0;
}

int senseOfDirections(const Leg& a, const Leg& b)
{
  return a.direction == 0 || std::abs(a.direction) != std::abs(b.direction) ? 0 : a.direction == b.direction ? 1 : -1;
}

/// Legs that share a direction get what their enclosures of it have in common.
void uniteAxes(Machine::Legs& legs, Problems& problems)
{
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
      const int sense = senseOfDirections(legs[i], legs[j]);
      if (sense == 0)
        continue;
      IntervalVector& axis = legs[j].axis;
      const IntervalVector other = timesSense(sense, legs[i].axis);
      if (intersects(axis, other))
        axis = { intersection(axis[0], other[0]), intersection(axis[1], other[1]), intersection(axis[2], other[2]) };
      else
        complain(problems, "legs '", legs[j].joint, "' and '", legs[i].joint,
                 "' are said to share a direction, but their axes are apart");
    }
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = i; j-- > 0;)
      if (const int sense = senseOfDirections(legs[i], legs[j]))
        legs[i].axis = timesSense(sense, legs[j].axis);
}

IntervalMatrix projectorAcross(const IntervalVector& axis)
{
  IntervalMatrix projector;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
    {
      const Interval product = row == column ? sqr(axis[row]) : axis[row] * axis[column];
      projector[row][column] = Interval(row == column ? 1.0 : 0.0) - product;
    }
  return projector;
}

/// Lengths of struts [m], and coordinates of rails and platform points: products of a dozen of them stay ordinary
/// numbers.
constexpr double SHORTEST = 1e-9;
constexpr double LARGEST = 1e9;

bool isOrdinary(const IntervalVector& point)
{
  return std::all_of(point.begin(), point.end(), [](const Interval& x) { return x.magnitude() <= LARGEST; });
}

/// Collects what is wrong with one leg by itself.
void validateLeg(const Leg& leg, const std::string& place, Problems& problems)
{
  if (!isBounded(leg.origin) || !isBounded(leg.platform) || !isBounded(leg.axis))
    complain(problems, place, ": rail origin, axis and platform point must be finite numbers");
  else if (!isOrdinary(leg.origin) || !isOrdinary(leg.platform))
    complain(problems, place, ": rail origin and platform point must be within 1e9 m");
  else if (!squaredNorm(leg.axis).contains(1.0))
    complain(problems, place, ": the axis must have unit length, its squared length is ", squaredNorm(leg.axis));
  if (!leg.length.isBounded() || leg.length.upper() < SHORTEST || leg.length.lower() > LARGEST)
    complain(problems, place, ": strut length ", leg.length, " m must be from 1e-9 m to 1e9 m");
  if (leg.working_mode != 1 && leg.working_mode != -1)
    complain(problems, place, ": working mode ", leg.working_mode, " must be +1 or -1");
  if (leg.limits.isEmpty())
    complain(problems, place, ": the joint limits leave no value");
}

void throwRefusal(const std::string& machine, const Problems& problems)
{
  throwProblems(problems, "machine '" + machine + "' is refused:");
}

/// The certain sign of det A at the zero configuration. @throws std::invalid_argument where there is none
int aspectAt(const Machine& machine)
{
  Problems problems;
  const auto& zero = machine.zero();
  const auto configuration = configurationAt(machine, zero);
  if (!configuration)
    complain(problems, "zero configuration: a strut does not reach the tool point (", zero.transpose(), ") m");
  else
  {
    for (int i = 0; i < 3; ++i)
      if (configuration->eta[static_cast<std::size_t>(i)].contains(0.0))
        complain(problems, "leg '", machine.leg(i).joint,
                 "': its strut is across its rail at zero (serial singularity)");
    if (configuration->det_a.contains(0.0))
      complain(problems, "zero configuration: the struts lie in parallel planes, det A = 0 (parallel singularity)");
  }
  throwRefusal(machine.name(), problems);
  return configuration->det_a.certainlyPositive() ? 1 : -1;
}
}  // namespace

Machine::Machine(std::string name, Legs legs, const Eigen::Vector3d& zero)
  : name_(std::move(name)), legs_(std::move(legs)), zero_(zero)
{
  Problems problems;
  for (const auto& leg : legs_)
    validateLeg(leg, "leg '" + leg.joint + "'", problems);
  uniteAxes(legs_, problems);
  if (!zero.allFinite() || zero.cwiseAbs().maxCoeff() > LARGEST)
    complain(problems, "zero configuration: the tool point must be finite, within 1e9 m");
  throwRefusal(name_, problems);
  for (std::size_t i = 0; i < 3; ++i)
  {
    centers_[i] = legs_[i].origin - legs_[i].platform;
    projectors_[i] = projectorAcross(legs_[i].axis);
  }
  aspect_ = aspectAt(*this);
}

int parallelSense(const Leg& a, const Leg& b)
{
  const bool exact = isSingle(a.axis) && isSingle(b.axis);
  return exact ? senseOfNumbers(a.axis, b.axis) : senseOfDirections(a, b);
}

std::array<int, 3> sharedDirections(const std::function<int(std::size_t, std::size_t)>& sense)
{
  std::array<int, 3> numbers = { 0, 0, 0 };
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i && numbers[i] == 0; ++j)
      if (const int found = sense(i, j))
      {
        numbers[j] = numbers[j] == 0 ? static_cast<int>(j) + 1 : numbers[j];
        numbers[i] = found * numbers[j];
      }
  return numbers;
}

std::array<int, 3> sharedDirections(const std::array<Leg, 3>& legs)
{
  return sharedDirections([&legs](std::size_t i, std::size_t j) { return parallelSense(legs[i], legs[j]); });
}

bool Machine::hasParallelRails() const
{
  return parallelSense(legs_[0], legs_[1]) != 0 && parallelSense(legs_[0], legs_[2]) != 0;
}

bool Machine::hasJointLimits() const
{
  return std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) { return leg.limits != Interval::entire(); });
}

double Machine::scale() const
{
  return std::max({ legs_[0].length.upper(), legs_[1].length.upper(), legs_[2].length.upper() });
}

std::string Machine::geometryHash() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::hexfloat << "pkm_workspace geometry 1 aspect " << aspect_;
  const auto withoutSign = [](double x) { return x == 0.0 ? 0.0 : x; };  // -0 is 0
  const auto put = [&](const Interval& x) { text << ' ' << withoutSign(x.lower()) << ' ' << withoutSign(x.upper()); };
  for (const auto& leg : legs_)
  {
    text << " mode " << leg.working_mode;
    for (const auto* vector : { &leg.origin, &leg.axis, &leg.platform })
      std::for_each(vector->begin(), vector->end(), put);
    put(leg.length);
    put(leg.limits);
  }
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (parallelSense(legs_[i], legs_[j]) != senseOfNumbers(legs_[i].axis, legs_[j].axis))
        text << " not parallel " << i << ' ' << j;
  return nameUuid(text.str());
}
}  // namespace pkm_workspace
