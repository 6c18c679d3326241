// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/premises.h"

#include <algorithm>
#include <array>

#include "pkm_workspace/common/name_uuid.h"
#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
using PoseNumbers = std::array<double, 7>;

/// Quaternion x, y, z, w: (0, 0, 0, 1) where it does not turn, else of the two of a rotation the one whose last number
/// that is not 0 is positive; translation [m]. No zero has a sign.
PoseNumbers canonical(const Pose& pose)
{
  std::array<double, 4> turn = pose.orientation;
  if (std::all_of(turn.begin(), turn.begin() + 3, [](double part) { return part == 0.0; }))
    turn = Pose().orientation;
  const auto last = std::find_if(turn.rbegin(), turn.rend(), [](double part) { return part != 0.0; });
  const double sign = *last < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d& shift = pose.translation;
  PoseNumbers numbers = { sign * turn[0], sign * turn[1], sign * turn[2], sign * turn[3],
                          shift.x(),      shift.y(),      shift.z() };
  for (double& number : numbers)
    number += 0.0;  // -0 is 0
  return numbers;
}

std::string text(const Pose& pose)
{
  const PoseNumbers at = canonical(pose);
  return "root link at (" + exact(at[4]) + ", " + exact(at[5]) + ", " + exact(at[6]) +
         ") m, turned by the quaternion (" + exact(at[0]) + ", " + exact(at[1]) + ", " + exact(at[2]) + ", " +
         exact(at[3]) + ")";
}
}  // namespace

std::string Premises::bytes() const
{
  ByteWriter writer;
  put(*this, writer);
  const PoseNumbers numbers = canonical(root);
  if (numbers != canonical(Pose()))
    for (const double number : numbers)
      writer.real(number);
  return writer.bytes();
}

std::string Premises::hash() const
{
  return nameUuid(bytes());
}

bool operator==(const Premises& one, const Premises& other)
{
  return one.bytes() == other.bytes();
}

Criterion within(const Machine& machine, Criterion criterion)
{
  criterion.joint_limits = criterion.joint_limits && machine.hasJointLimits();
  criterion.hinge_limits = criterion.hinge_limits && machine.hasHingeLimits();
  return criterion;
}

Premises premisesOf(const Machine& machine, const Criterion& criterion)
{
  return premisesIn(Pose(), machine, machine.geometryHash(), criterion);
}

Premises premisesIn(const Pose& root, const Machine& machine, const std::string& geometry_hash,
                    const Criterion& criterion)
{
  return { machine.name(),
           geometry_hash,
           within(machine, criterion),
           root,
           version(),
           criterion.ball_tilt_max > 0.0 ? givenBallAxes(machine) : BallAxes(),
           tolerancesOf(machine) };
}

void put(const Premises& premises, ByteWriter& writer)
{
  writer.text(premises.geometry_hash);
  put(premises.criterion, writer);
}

Premises takePremises(ByteReader& reader)
{
  Premises premises;
  premises.geometry_hash = reader.text();
  premises.criterion = takeCriterion(reader);
  return premises;
}

std::vector<Difference> differences(const Premises& one, const Premises& other)
{
  std::vector<Difference> found;
  if (one.geometry_hash != other.geometry_hash)
    found.push_back({ "geometry hash", one.geometry_hash, other.geometry_hash });
  if (!(one.criterion == other.criterion))
    found.push_back({ "criterion", describe(one.criterion), describe(other.criterion) });
  if (canonical(one.root) != canonical(other.root))
    found.push_back({ "frame", text(one.root), text(other.root) });
  return found;
}

std::string describe(const Premises& premises)
{
  constexpr std::size_t ENOUGH = 8;  // digits of a hash to tell machines apart
  Criterion rest = premises.criterion;
  rest.zones.clear();
  rest.tool_radius = 0.0;
  return premises.machine + ", geometry " + premises.geometry_hash.substr(0, ENOUGH) + ", pkm_workspace " +
         premises.version + '\n' + describe(rest) +
         zonesInShort(premises.criterion.zones, premises.criterion.tool_radius);
}
}  // namespace pkm_workspace
