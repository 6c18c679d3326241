// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion_bytes.h"

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"

namespace pkm_workspace
{
namespace
{
/// Of CRITERION_BOUNDS, those that all files hold; the others follow, with the joint data, where any is asked for.
constexpr std::size_t FIRST_BOUNDS = 5;
/// Of JOINT_DATA, those that go with these; the last follows where it is asked for.
constexpr std::size_t FIRST_DATA = JOINT_DATA.size() - 1;
/// Flags of the last byte that all files hold.
constexpr unsigned LIMITS = 1, MORE = 2, HINGES = 4, ZONES = 8, TILTS = 16;

/// @return one of the first @p count values of the enumeration
template <class Enumeration>
Enumeration takeOneOf(std::size_t count, ByteReader& reader)
{
  const unsigned value = reader.number<std::uint8_t>();
  if (value >= count)
    throw std::runtime_error("a choice has the number " + std::to_string(value));
  return static_cast<Enumeration>(value);
}

void put(const Pose& pose, ByteWriter& writer)
{
  for (const double number : pose.orientation)
    writer.real(number);
  for (const double number : pose.translation)
    writer.real(number);
}

Pose takePose(ByteReader& reader)
{
  Pose pose;
  for (double& number : pose.orientation)
    number = reader.real();
  for (double& number : pose.translation)
    number = reader.real();
  return pose;
}

void put(const Zone& zone, ByteWriter& writer)
{
  writer.number(static_cast<std::uint8_t>(zone.use));
  writer.number(static_cast<std::uint8_t>(zone.kind));
  writer.text(zone.name);
  put(zone.pose, writer);
  put(zone.frame, writer);
  for (const double side : zone.sides)
    writer.real(side);
  writer.real(zone.radius);
  writer.real(zone.height);
  for (const double part : zone.normal)
    writer.real(part);
}

Zone takeZone(ByteReader& reader)
{
  Zone zone;
  zone.use = takeOneOf<Zone::Use>(ZONE_USES.size(), reader);
  zone.kind = takeOneOf<Zone::Kind>(ZONE_KINDS.size(), reader);
  zone.name = reader.text();
  zone.pose = takePose(reader);
  zone.frame = takePose(reader);
  zone.in_root = isElsewhere(zone);
  for (double& side : zone.sides)
    side = reader.real();
  zone.radius = reader.real();
  zone.height = reader.real();
  for (double& part : zone.normal)
    part = reader.real();
  return zone;
}
}  // namespace

Criterion canonical(const Criterion& criterion)
{
  Criterion result = criterion;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (!bound.isAskedBy(criterion))
      result.*bound.value = Criterion().*bound.value;
  for (const JointDatum& datum : JOINT_DATA)
    if (!datum.isAskedBy(criterion))
      result.*datum.values = JointValues{};
  return result;
}

void put(const Criterion& criterion, ByteWriter& writer)
{
  const Criterion values = canonical(criterion);
  const bool has_more = values.boundsMore();
  writer.number(static_cast<std::uint8_t>(values.set));
  writer.number(static_cast<std::uint8_t>(values.aspect));
  for (std::size_t k = 0; k < FIRST_BOUNDS; ++k)
    writer.real(values.*CRITERION_BOUNDS[k].value);
  const bool has_tilts = JOINT_DATA[FIRST_DATA].isAskedBy(values);
  writer.number(static_cast<std::uint8_t>((values.joint_limits ? LIMITS : 0U) | (has_more ? MORE : 0U) |
                                          (values.hinge_limits ? HINGES : 0U) | (values.zones.empty() ? 0U : ZONES) |
                                          (has_tilts ? TILTS : 0U)));
  for (std::size_t k = FIRST_BOUNDS; has_more && k < CRITERION_BOUNDS.size(); ++k)
    writer.real(values.*CRITERION_BOUNDS[k].value);
  for (std::size_t k = 0; has_more && k < FIRST_DATA + (has_tilts ? 1 : 0); ++k)
    for (const double value : values.*JOINT_DATA[k].values)
      writer.real(value);
  if (values.zones.empty())
    return;
  writer.number(static_cast<std::uint8_t>(values.zones.size()));
  for (const Zone& zone : values.zones)
    put(zone, writer);
  writer.real(values.tool_radius);
}

Criterion takeCriterion(ByteReader& reader)
{
  Criterion criterion;
  criterion.set = takeOneOf<Criterion::Set>(SET_NAMES.size(), reader);
  criterion.aspect = takeOneOf<Criterion::Aspect>(ASPECT_NAMES.size(), reader);
  for (std::size_t k = 0; k < FIRST_BOUNDS; ++k)
    criterion.*CRITERION_BOUNDS[k].value = reader.real();
  const auto flags = takeOneOf<unsigned>((LIMITS | MORE | HINGES | ZONES | TILTS) + 1, reader);
  criterion.joint_limits = (flags & LIMITS) != 0;
  criterion.hinge_limits = (flags & HINGES) != 0;
  if ((flags & (HINGES | TILTS)) != 0 && (flags & MORE) == 0)
    throw std::runtime_error("a choice has the number " + std::to_string(flags));
  const bool has_more = (flags & MORE) != 0;
  for (std::size_t k = FIRST_BOUNDS; has_more && k < CRITERION_BOUNDS.size(); ++k)
    criterion.*CRITERION_BOUNDS[k].value = reader.real();
  for (std::size_t k = 0; has_more && k < FIRST_DATA + ((flags & TILTS) != 0 ? 1 : 0); ++k)
    for (double& value : criterion.*JOINT_DATA[k].values)
      value = reader.real();
  if ((flags & ZONES) == 0)
    return criterion;
  criterion.zones.resize(takeOneOf<std::size_t>(MOST_ZONES + 1, reader));
  for (Zone& zone : criterion.zones)
    zone = takeZone(reader);
  criterion.tool_radius = reader.real();
  return criterion;
}

bool operator==(const Criterion& a, const Criterion& b)
{
  ByteWriter bytes_of_a, bytes_of_b;
  put(a, bytes_of_a);
  put(b, bytes_of_b);
  return bytes_of_a.bytes() == bytes_of_b.bytes();
}
}  // namespace pkm_workspace
