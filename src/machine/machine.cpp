// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/machine.h"

#include <algorithm>

#include "numbers.h"
#include "pkm_workspace/common/name_uuid.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
/// Collects what is wrong with one leg by itself.
void validateLeg(const Leg& leg, const std::string& place, Problems& problems)
{
  visitLeg([&](const auto& kind) { validate(kind, place, problems); }, leg.kind);
  if (leg.limits.isEmpty())
    complain(problems, place, ": the joint limits leave no value");
  else if (problems.empty())
    visitLeg([&](const auto& kind) { validateLimits(kind, leg.limits, place, problems); }, leg.kind);
  const std::pair<double, const char*> drive[] = { { leg.speed, "speed" }, { leg.effort, "effort" } };
  for (const auto& [most, what] : drive)
    if (!(most > 0.0))
      complain(problems, place, ": the largest ", what, " of its motor = ", most, ", expected more than 0 (",
               what == drive[0].second ? std::string(unitOf(leg)) + "/s"
               : hasAngle(leg)         ? "N m"
                                       : "N",
               "), or infinity where none is known");
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
  const auto prepare = [](const Leg& leg) {
    return visitLeg([](const auto& kind) -> EnclosedLeg { return pkm_workspace::enclosed(kind); }, leg.kind);
  };
  for (std::size_t i = 0; i < 3; ++i)
  {
    Leg meant = legs_[i];
    if (auto* const strut = std::get_if<SlidingStrut>(&meant.kind))
      strut->tolerance = {};
    enclosed_[i] = prepare(legs_[i]);
    meant_[i] = prepare(meant);
  }
  aspect_ = aspectAt(*this);
}

const IntervalVector& Machine::center(int i) const
{
  return visitLeg([](const auto& kind) -> const IntervalVector& { return kind.center; }, enclosed(i));
}

bool Machine::hasParallelRails() const
{
  return parallelSense(legs_[0], legs_[1]) != 0 && parallelSense(legs_[0], legs_[2]) != 0;
}

bool Machine::hasTolerances() const
{
  return std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) { return !toleranceOf(leg).isZero(); });
}

bool Machine::hasJointLimits() const
{
  return std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) { return leg.limits != Interval::entire(); });
}

bool Machine::hasHingeLimits() const
{
  return std::any_of(legs_.begin(), legs_.end(), [](const Leg& leg) {
    return !passiveJoints(leg).stops.empty() || !passiveJoints(leg).open_hinges.empty();
  });
}

std::vector<IntervalVector> Machine::ballAxes(int i) const
{
  const std::vector<IntervalVector>& given = passiveJoints(leg(i)).ball_axes;
  return given.empty()
             ? std::vector<IntervalVector>{ configurationAt(*this, zero_)->strut[static_cast<std::size_t>(i)] }
             : given;
}

double Machine::scale() const
{
  double scale = 0.0;
  for (const EnclosedLeg& leg : enclosed_)
    scale = std::max(scale, lengthOf(leg).upper());
  return scale;
}

std::string Machine::geometryHash() const
{
  std::string text = "pkm_workspace geometry 1 aspect " + std::to_string(aspect_);
  for (const auto& leg : legs_)
    text += visitLeg([](const auto& kind) { return exactText(kind); }, leg.kind) + exactText(leg.limits);
  return nameUuid(text + directionsText(legs_));
}
}  // namespace pkm_workspace
