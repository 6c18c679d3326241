// SPDX-License-Identifier: BSD-3-Clause
#include "named_families.h"

#include <algorithm>
#include <stdexcept>

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// A family of the catalogue.
struct NamedFamily
{
  const char* machine;
  const char* parameter;
  MachineFamily (*make)();
};

const NamedFamily FAMILIES[] = {
  { "uranesx", "R-r", [] { return uranesxByRadius(); } },
  { "uranesx", "lambda", [] { return uranesxByLambda(); } },
  { "delta", "base-radius", [] { return deltaBy(&DeltaDimensions::base_radius, "base-radius"); } },
  { "delta", "crank", [] { return deltaBy(&DeltaDimensions::crank, "crank"); } },
  { "delta", "length", [] { return deltaBy(&DeltaDimensions::forearm, "length"); } },
  { "delta", "platform-radius", [] { return deltaBy(&DeltaDimensions::platform_radius, "platform-radius"); } },
  { "tripod", "base-radius", [] { return tripodBy(&TripodDimensions::base_radius, "base-radius"); } },
  { "tripod", "length", [] { return tripodBy(&TripodDimensions::length, "length"); } },
  { "tripod", "platform-radius", [] { return tripodBy(&TripodDimensions::platform_radius, "platform-radius"); } },
};

/// What stands in one column of them, each once.
Words namesOf(const char* NamedFamily::*column)
{
  Words names;
  for (const NamedFamily& family : FAMILIES)
    if (std::find(names.begin(), names.end(), family.*column) == names.end())
      names.emplace_back(family.*column);
  return names;
}
}  // namespace

Words familyMachines()
{
  return namesOf(&NamedFamily::machine);
}

Words familyParameters()
{
  return namesOf(&NamedFamily::parameter);
}

MachineFamily familyNamed(const std::string& machine, const std::string& parameter)
{
  Words parameters;
  for (const NamedFamily& family : FAMILIES)
    if (machine == family.machine && parameter == family.parameter)
      return family.make();
    else if (machine == family.machine)
      parameters.emplace_back(family.parameter);
  throw std::invalid_argument("--parameter " + parameter + " is none of the " + machine +
                              "; allowed: " + joined(parameters, ", "));
}
}  // namespace cli
}  // namespace pkm_workspace
