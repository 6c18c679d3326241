// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/criterion_bytes.h"

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"

namespace pkm_workspace
{
namespace
{
/// @return one of the first @p count values of the enumeration
template <class Enumeration>
Enumeration takeOneOf(std::size_t count, ByteReader& reader)
{
  const unsigned value = reader.number<std::uint8_t>();
  if (value >= count)
    throw std::runtime_error("a choice has the number " + std::to_string(value));
  return static_cast<Enumeration>(value);
}
}  // namespace

Criterion canonical(const Criterion& criterion)
{
  Criterion result = criterion;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (!bound.isAskedBy(criterion))
      result.*bound.value = Criterion().*bound.value;
  return result;
}

void put(const Criterion& criterion, ByteWriter& writer)
{
  const Criterion values = canonical(criterion);
  writer.number(static_cast<std::uint8_t>(values.set));
  writer.number(static_cast<std::uint8_t>(values.aspect));
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    writer.real(values.*bound.value);
  writer.number(static_cast<std::uint8_t>(values.joint_limits));
}

Criterion takeCriterion(ByteReader& reader)
{
  Criterion criterion;
  criterion.set = takeOneOf<Criterion::Set>(SET_NAMES.size(), reader);
  criterion.aspect = takeOneOf<Criterion::Aspect>(ASPECT_NAMES.size(), reader);
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    criterion.*bound.value = reader.real();
  criterion.joint_limits = takeOneOf<bool>(2, reader);
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
