// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/machine/description.h"

namespace pkm_workspace
{
/// Where a firmware's file says something.
struct SourcePlace
{
  std::string file;
  std::size_t line = 0;  ///< from 1 on; 0 where it says nothing, and a default of the firmware counts
};
/// "printer.cfg:12"; "printer.cfg" without a line.
std::string toText(const SourcePlace& place);

/// One number that the machine is made of.
struct TakenValue
{
  SourcePlace place;
  std::string key;      ///< as the firmware has it: "stepper_a arm_length"
  std::string written;  ///< the value as the file has it; "not set" for a default of the firmware
  std::string meaning;  ///< what it is, in metres and degrees
};

/// What the file says besides, and why it says nothing of the machine.
struct LeftAside
{
  SourcePlace place;
  std::string key;
  std::string reason;
};

/// A linear or rotary delta as the configuration of its controller describes it.
struct FirmwareMachine
{
  std::string format;          ///< one of firmwareFormats()
  MachineDescription machine;  ///< joint values are the controller's own [m, rad]: docs/firmware.md
  std::vector<TakenValue> taken;
  std::vector<LeftAside> left_aside;
};

/// A file as its firmware reads it.
struct FirmwareText
{
  std::string name;     ///< for places
  std::string content;  ///< UTF-8; what is not counts as text that no value has
  /// The text of a file that this one names, or nothing where it cannot be read; may be empty.
  std::function<std::optional<std::string>(const std::string& name)> other = {};
};

/// Names of the formats that are known.
std::vector<std::string> firmwareFormats();

/// Reads the geometry of a linear or rotary delta from the configuration of its controller (docs/firmware.md).
/// @param format one of firmwareFormats(); empty: recognised from the text
/// @throws std::invalid_argument naming everything that is wrong at once, each with file and line, value, unit, allowed
/// range and remedy
FirmwareMachine importFirmware(const FirmwareText& text, const std::string& format = "");

/// Reads the file, and those that it names from its own folder; then as above.
FirmwareMachine importFirmwareFile(const std::string& path, const std::string& format = "");
}  // namespace pkm_workspace
