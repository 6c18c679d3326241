// SPDX-License-Identifier: BSD-3-Clause
#include "support/exact_machines.h"

#include <Eigen/Geometry>

#include "pkm_workspace/machine/catalogue.h"
#include "support/exact_vector.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;

ExactVector unit(const Vector3d& v)
{
  const ExactVector x = exact(v);
  return (Exact(1.0) / sqrt(dot(x, x))) * x;
}

IntervalVector encloseUnit(const Vector3d& v)
{
  const IntervalVector x = enclose(v);
  return (Interval(1.0) / norm(x)) * x;
}

ExactMachine exactOrthoglide(const std::string& name, double length, const Machine& machine)
{
  std::array<ExactLeg, 3> legs;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d axis = Vector3d::Unit(i);
    legs[static_cast<std::size_t>(i)] = { exact(-length * axis), exact(axis), exact(Vector3d::Zero()), length, 1 };
  }
  return { name, machine, legs };
}

/// Orthoglide assembled on the other side of its parallel singularity.
ExactMachine otherAspect()
{
  const Machine own = orthoglide();
  const Machine other("orthoglide", own.legs(), Vector3d::Constant(-0.546));
  return exactOrthoglide("OrthoglideOtherAspect", 1.0, other);
}

ExactMachine exactUranesx(const std::string& name)
{
  std::array<ExactLeg, 3> legs;
  for (int i = 0; i < 3; ++i)
  {
    const Exact cosine = i == 0 ? Exact(1.0) : Exact(-0.5);
    const Exact sine = Exact(i == 0 ? 0.0 : i == 1 ? 0.5 : -0.5) * sqrt(Exact(3.0));
    const ExactVector direction = { cosine, sine, 0.0 };
    legs[static_cast<std::size_t>(i)] = { (Exact(7.0) / 13.0) * direction, exact(Vector3d::UnitZ()),
                                          (Exact(3.0) / 26.0) * direction, 1.0, -1 };
  }
  return { name, uranesx(), legs };
}

/// A direction at most @p angle away from @p axis [rad].
Vector3d tilted(const Vector3d& axis, double angle, Random& random)
{
  const Vector3d about(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  return Eigen::AngleAxisd(random.uniform(-angle, angle), about.cross(axis).normalized()) * axis;
}

Vector3d nominalAxis(int i, bool cone)
{
  if (!cone)
    return Vector3d::Unit(i);
  const double turn = 2.0 * i * 3.14159 / 3.0;
  return { 0.5 * std::cos(turn), 0.5 * std::sin(turn), 0.866 };
}
}  // namespace

ExactVector exact(const Vector3d& v)
{
  return { v.x(), v.y(), v.z() };
}

bool ExactConfiguration::isReached() const
{
  return !radicand[0].certainlyNegative() && !radicand[1].certainlyNegative() && !radicand[2].certainlyNegative();
}

ExactConfiguration exactConfiguration(const std::array<ExactLeg, 3>& legs, const ExactVector& p)
{
  ExactConfiguration result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const ExactLeg& leg = legs[i];
    const ExactVector offset = p - (leg.origin - leg.platform);
    const Exact along = dot(leg.axis, offset);
    const ExactVector across = offset - along * leg.axis;
    result.radicand[i] = leg.length * leg.length - dot(across, across);
    if (result.radicand[i].certainlyNegative())
      continue;
    result.eta[i] = Exact(leg.working_mode) * sqrt(result.radicand[i]);
    result.strut[i] = across + result.eta[i] * leg.axis;
    result.rho[i] = along - result.eta[i];
  }
  result.det_a = determinant(result.strut[0], result.strut[1], result.strut[2]);
  return result;
}

ExactMachine crookedMachine(const std::string& name, int seed, double scale, const Vector3d& place)
{
  Random random(static_cast<std::uint64_t>(seed));
  const bool cone = seed % 3 == 0;
  Machine::Legs legs;
  std::array<ExactLeg, 3> exact_legs;
  for (int i = 0; i < 3; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const Vector3d axis = random.uniform(0.5, 2.0) * tilted(nominalAxis(i, cone), 9.0 * 3.14159 / 180.0, random);
    const double length = scale * random.uniform(0.7, 1.3);
    const int mode = seed % 2 == 0 && i == 1 ? -1 : 1;
    const Vector3d platform = 0.2 * scale * Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.5);
    const Vector3d strut = length * mode * tilted(axis.normalized(), 0.4, random);
    const Vector3d origin = place + platform - strut;
    legs[k] = { "joint_" + std::to_string(i + 1), Interval::entire(),
                SlidingStrut{ {}, enclose(origin), encloseUnit(axis), enclose(platform), length, mode } };
    exact_legs[k] = { exact(origin), unit(axis), exact(platform), length, mode };
  }
  return { name, Machine(name, legs, place), exact_legs };
}

const std::vector<ExactMachine>& exactMachines()
{
  static const std::vector<ExactMachine> MACHINES = {
    exactOrthoglide("Orthoglide", 1.0, orthoglide()),
    exactOrthoglide("OrthoglidePrototype", 0.31058, orthoglidePrototype()),
    exactOrthoglide("OrthoglideOfAKilometre", 1000.0, orthoglide(1000.0)),
    otherAspect(),
    exactUranesx("UraneSX"),
    crookedMachine("Crooked", 1),
    crookedMachine("CrookedMixedModes", 2),
    crookedMachine("CrookedCone", 3),
    crookedMachine("CrookedSmall", 5, 0.31058),
    crookedMachine("CrookedLarge", 7, 1000.0),
    crookedMachine("CrookedFar", 8, 1.0, { 1000.0, -700.0, 300.0 }),
  };
  return MACHINES;
}
}  // namespace test
}  // namespace pkm_workspace
