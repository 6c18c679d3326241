// SPDX-License-Identifier: BSD-3-Clause
#include "hunt/subject.h"

#include <algorithm>
#include <sstream>

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/machine/frame.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/every_criterion.h"
#include "support/exact_machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
Machine drawnDelta(Random& random)
{
  const auto near = [&](double value) { return Interval(value * random.uniform(0.8, 1.2)); };
  DeltaDimensions dimensions;
  dimensions.base_radius = near(0.164);
  dimensions.crank = near(0.524);
  dimensions.forearm = near(1.244);
  dimensions.platform_radius = near(0.044);
  if (random.once(2))
    dimensions.limits = Interval(-random.uniform(0.2, 1.5), random.uniform(0.2, 2.0));
  return delta(dimensions);
}

Machine drawnTripod(Random& random)
{
  TripodDimensions dimensions;
  dimensions.base_radius = random.uniform(0.3, 0.8);
  dimensions.platform_radius = random.uniform(0.02, 0.2);
  dimensions.length = random.uniform(0.7, 1.2);
  dimensions.limits = Interval(-random.uniform(0.05, 0.4), random.uniform(0.05, 0.4));
  return tripod(dimensions);
}

Machine drawnKind(Random& random)
{
  const auto seed = static_cast<unsigned>(random.integer(1, 1000000));
  const double scale = std::pow(10.0, random.uniform(-1.5, 1.5));
  switch (random.integer(0, 9))
  {
    case 0:
      return crooked(seed, scale, scale * Eigen::Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), 0.5));
    case 1:
      return crookedMachine("crooked", static_cast<int>(seed), scale).machine;
    case 2:
      return cone();
    case 3:
      return orthoglide(scale);
    case 4:
      return uranesx(Interval(scale * random.uniform(0.3, 0.8)), Interval(scale * random.uniform(0.05, 0.2)), scale);
    case 5:
      return drawnDelta(random);
    case 6:
      return drawnTripod(random);
    case 7:
      return mixed();
    case 8:
      return crookedMix(seed);
    default:
      return crooked(seed);
  }
}

bool hasSlidingStrutsOnly(const Machine& machine)
{
  return std::all_of(machine.legs().begin(), machine.legs().end(),
                     [](const Leg& leg) { return std::holds_alternative<SlidingStrut>(leg.kind); });
}

Machine withDrawnLimits(const Machine& machine, Random& random)
{
  const auto at_zero = inverseKinematics(machine, machine.zero());
  if (!at_zero)
    return machine;
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double unit = std::holds_alternative<Crank>(legs[i].kind) ? 1.0 : machine.scale();
    const double q = (*at_zero)[static_cast<int>(i)];
    legs[i].limits = Interval(q - unit * random.uniform(0.05, 0.5), q + unit * random.uniform(0.05, 0.5));
  }
  return { machine.name(), legs, machine.zero() };
}

Machine drawnMachine(Random& random)
{
  Machine machine = drawnKind(random);
  if (random.once(3))
    machine = withDrawnLimits(machine, random);
  if (random.once(8) && hasSlidingStrutsOnly(machine))
    machine = hinged(machine);
  else if (random.once(3))
    machine = readUrdf(writeUrdf(machine)).machine;
  if (random.once(3) && !machine.hasHingeLimits())
    machine = machineInFrame(machine, randomPose(random, spaceOf(machine)));
  return machine;
}

/// A bound that the value at the zero configuration keeps, mostly.
double drawnBound(const CriterionBound& bound, double at_zero, Random& random)
{
  const double wide = random.uniform(1.02, random.once(2) ? 1.5 : 4.0);
  const double value = bound.is_lower ? at_zero / wide : at_zero * wide;
  return std::min(std::max(value, bound.least), 0.999 * bound.most);
}

void drawFactors(const Machine& machine, Criterion& criterion, Random& random)
{
  const auto at_zero = jacobians(machine, machine.zero());
  if (!at_zero)
    return;
  const Eigen::Vector3d psi = transmissionFactors(*at_zero);
  const auto above = [&] { return random.uniform(1.02, random.once(2) ? 1.5 : 4.0); };
  criterion.psi_min = psi[0] / above();
  criterion.psi_max = psi[2] * above();
  if (random.once(5))
    criterion.force_min = 1.0 / (psi[2] * above());
  if (random.once(5))
    criterion.force_max = above() / psi[0];
  if (random.once(5))
    criterion.kappa_max = psi[2] / psi[0] * above();
}

/// Speeds, forces, stiffness, errors, angles.
void drawMore(const Machine& machine, Criterion& criterion, Random& random)
{
  const Criterion motors = withMotors(machine);
  for (const JointDatum& datum : JOINT_DATA)
    criterion.*datum.values = motors.*datum.values;
  const Eigen::Vector3d& zero = machine.zero();
  const Oracle::Vector there = { zero.x(), zero.y(), zero.z() };
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    const bool is_angle = bound.kind == Limit::Kind::STRUT_ANGLE_MIN || bound.kind == Limit::Kind::STRUT_ANGLE_MAX;
    if (bound.kind < Limit::Kind::TOOL_SPEED_MIN || !random.once(4) || (is_angle && hasTelescopes(machine)))
      continue;
    Limit limit;
    limit.kind = bound.kind;
    limit.leg = -1;
    criterion.*bound.value =
        bound.kind == Limit::Kind::BALL_TILT_MAX
            ? random.uniform(0.2, 0.9)
            : drawnBound(bound, static_cast<double>(Oracle(machine, criterion).valueOf(limit, there)), random);
  }
}

Criterion drawnCriterion(const Machine& machine, Random& random)
{
  Criterion criterion;
  drawFactors(machine, criterion, random);
  if (random.once(3))
    criterion.set = Criterion::Set::REACHABLE;
  if (random.once(criterion.set == Criterion::Set::REACHABLE ? 3 : 10))
    criterion.aspect = static_cast<Criterion::Aspect>(random.integer(0, 2));
  criterion.joint_limits = machine.hasJointLimits() && !random.once(4);
  criterion.hinge_limits = machine.hasHingeLimits();
  if (random.once(3))
    drawMore(machine, criterion, random);
  if (random.once(5))
  {
    criterion.zones = randomZones(random, spaceOf(machine));
    criterion.tool_radius = random.once(2) ? 0.0 : 0.02 * machine.scale();
  }
  return criterion;
}

std::string optionOf(std::string name)
{
  std::replace(name.begin(), name.end(), '_', '-');
  return " --" + name;
}
}  // namespace

std::optional<Subject> drawnSubject(Random& random)
{
  try
  {
    const Machine machine = drawnMachine(random);
    const Criterion criterion = drawnCriterion(machine, random);
    const BoxTest test(machine, criterion);
    return Subject{ machine, criterion };
  }
  catch (const std::invalid_argument&)
  {
    return std::nullopt;
  }
}

std::string inWords(const Criterion& criterion)
{
  std::ostringstream text;
  text.precision(17);
  text << "options: --set " << name(criterion.set) << " --aspect " << name(criterion.aspect) << " --joint-limits "
       << (criterion.joint_limits ? "on" : "off") << " --hinge-limits " << (criterion.hinge_limits ? "on" : "off");
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.isAskedBy(criterion))
      text << optionOf(bound.name) << " " << criterion.*bound.value;
  for (const JointDatum& datum : JOINT_DATA)
    if (criterion.*datum.bound > 0.0)
    {
      text << optionOf(datum.name);
      for (const double value : criterion.*datum.values)
        text << " " << value;
    }
  text << "\nall that is asked: " << describe(criterion) << "\n";
  return text.str();
}
}  // namespace test
}  // namespace pkm_workspace
