// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "linear_delta.h"
#include "reading.h"
#include "rotary_delta.h"

namespace pkm_workspace
{
namespace firmware
{
/// What a reader is given.
struct Source
{
  const FirmwareText& text;
  std::vector<SourceLine> lines;
};

/// One format: a new one is a file with two functions, declared below, and a row in firmware.cpp.
struct Format
{
  const char* name;
  const char* title;  ///< for messages: "Klipper: printer.cfg"
  bool (*recognises)(const std::vector<SourceLine>& lines);
  /// @param name of the machine @throws std::invalid_argument where anything is wrong
  MachineDescription (*read)(const Source& source, Reading& reading, const std::string& name);
};

/// The machine that a reader of one model finds.
template <class Delta, void (*READ)(const Source&, Reading&, Delta&)>
MachineDescription readAs(const Source& source, Reading& reading, const std::string& name)
{
  Delta delta;
  READ(source, reading, delta);
  checkDelta(delta, reading);
  throwProblems(reading.problems);
  return describe(delta, name);
}

bool isKlipper(const std::vector<SourceLine>& lines);
void readKlipper(const Source& source, Reading& reading, LinearDelta& delta);

bool isMarlin(const std::vector<SourceLine>& lines);
void readMarlin(const Source& source, Reading& reading, LinearDelta& delta);
bool isMarlinReport(const std::vector<SourceLine>& lines);
void readMarlinReport(const Source& source, Reading& reading, LinearDelta& delta);
bool isRepRapFirmware(const std::vector<SourceLine>& lines);
void readRepRapFirmware(const Source& source, Reading& reading, LinearDelta& delta);
bool isLinuxCnc(const std::vector<SourceLine>& lines);
MachineDescription readLinuxCnc(const Source& source, Reading& reading, const std::string& name);
bool isGrblHal(const std::vector<SourceLine>& lines);
void readGrblHal(const Source& source, Reading& reading, RotaryDelta& delta);

/// Lines of a file that the one being read names, once for each name; told as left aside where it cannot be read.
std::vector<SourceLine> otherLines(const Source& source, const Entry& naming, const std::string& name,
                                   Reading& reading);
}  // namespace firmware
}  // namespace pkm_workspace
