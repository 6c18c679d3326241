// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "pkm_workspace/machine/machine.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// What may be given of a machine of the catalogue; what is not given follows from the rest.
struct Dimensions
{
  std::optional<double> length;                 ///< L [m]
  std::optional<double> rail_radius;            ///< R [m]
  std::optional<double> base_radius;            ///< of cranks and feet [m]
  std::optional<double> crank;                  ///< r [m]
  std::optional<double> platform_radius;        ///< r [m]
  std::optional<double> lambda;                 ///< R / L = 7/13 + lambda
  std::optional<std::array<double, 2>> travel;  ///< joint limits [m, degrees]
  std::array<double, 3> speeds{};               ///< of the joints [m/s, rad/s]; 0: none is known
  std::array<double, 3> efforts{};              ///< on the joints [N, N m]; 0: none is known
};

/// A machine of the catalogue.
struct NamedMachine
{
  const char* name;
  Words dimensions;  ///< the options that it knows
  Machine (*make)(const Dimensions& given);
};

/// Sets the one of this name, as a machine file has it, if there is any.
void setDimension(const std::string& name, const std::vector<double>& numbers, Dimensions& dimensions);

Words machineNames();
/// @pre it is one of these
const NamedMachine& namedMachine(const std::string& name);
/// With what is known of its drives.
Machine makeDriven(const NamedMachine& named, const Dimensions& given);
}  // namespace cli
}  // namespace pkm_workspace
