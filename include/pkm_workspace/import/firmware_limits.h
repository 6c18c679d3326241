// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pkm_workspace/interval/box.h"

namespace pkm_workspace
{
/// A region all of whose points are proved, as a controller can hold one: a cylinder about the z axis, or a box.
struct HeldRegion
{
  std::optional<double> radius;  ///< of the cylinder [m]
  Box box;                       ///< [m]; of a cylinder only z counts
};

/// Limits in the words of a firmware (docs/firmware.md).
struct FirmwareLimits
{
  std::string text;                                         ///< for the configuration, with comments
  std::vector<std::pair<std::string, std::string>> values;  ///< what it sets: key, and number [mm]
};

/// Names of the formats that are known.
std::vector<std::string> limitFormats();

/// Whether it holds cylinders about the z axis; otherwise it holds boxes.
bool holdsCylinders(const std::string& format);

/// Millimetres with three digits, rounded inward by more than what single precision and the firmwares' own slack let
/// pass: what the limits let pass lies in the region.
/// @param format one of limitFormats() @param comments lines that are written above the limits
/// @throws std::invalid_argument for a region of the other kind, or too small to be rounded
FirmwareLimits writeLimits(const std::string& format, const HeldRegion& region,
                           const std::vector<std::string>& comments);
}  // namespace pkm_workspace
