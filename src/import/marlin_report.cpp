// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "formats.h"
#include "gcode.h"
#include "marlin_delta.h"

// What Marlin answers to M503 or M665 (MarlinFirmware/Marlin, src/gcode/calibrate/M665.cpp and M666.cpp): L rod, R
// radius, H height, X Y Z trims of the towers' angles, A B C of the rods. Releases from 1.1.1 to 2.0.x report B without
// A and C: the radius of its calibration. M851 is the probe's offset.

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const char* const NOT_REPORTED = "a report does not tell it: taken as 0";

bool hasWord(const GcodeCommand& command, const std::string& letter)
{
  return std::any_of(command.words.begin(), command.words.end(), [&](const Entry& word) { return word.key == letter; });
}

/// Three words of a command.
MarlinDelta::Three threeWords(const std::string& code, const std::string& letters, const std::string& what,
                              const Quantity& quantity, Reading& reading)
{
  MarlinDelta::Three values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = reading.value(code + " " + letters[i], what + " of tower " + "ABC"[i], quantity);
  return values;
}

std::string reportReason(const Entry& entry)
{
  if (entry.key == "M665 B")
    return "the radius of the calibration: without A and C it does not trim a rod";
  return "segments, sensors and modes are not part of the geometry";
}
}  // namespace

bool isMarlinReport(const std::vector<SourceLine>& lines)
{
  const std::vector<GcodeCommand> commands = readGcode(lines);
  return std::any_of(commands.begin(), commands.end(), [](const GcodeCommand& command) {
    return command.code == "M665" && (command.is_report || hasWord(command, "S") || hasWord(command, "A"));
  });
}

void readMarlinReport(const Source& source, Reading& reading, LinearDelta& delta)
{
  addCommands(readGcode(source.lines), { "M665", "M666", "M851", "G20" }, reading);
  MarlinDelta numbers;
  numbers.radius = reading.needed("M665 R", "radius, across from effector joint to carriage joint", MILLIMETRES,
                                  "the answer to M665 or M503 has it");
  numbers.rod = reading.needed("M665 L", "struts", MILLIMETRES, "the answer to M665 or M503 has it");
  numbers.height = reading.needed("M665 H", "z of the tool at home", SIGNED_MILLIMETRES,
                                  "releases before 1.1.3 do not report it: write H and z at home [mm] into the line");
  if (const Entry* const rod = reading.find("M665 L"))
    numbers.place = rod->place;
  numbers.angle_trim = threeWords("M665", "XYZ", "trim of the angle", TRIM_DEGREES, reading);
  if (reading.has("M665 A") || reading.has("M665 C"))
    numbers.rod_trim = threeWords("M665", "ABC", "trim of the strut", TRIM_MILLIMETRES, reading);
  numbers.endstop = threeWords("M666", "XYZ", "home below the switch", MARLIN_ENDSTOP, reading);
  numbers.probe_z =
      reading.value("M851 Z", "z of the probe, by which the tool homes away from H", TRIM_MILLIMETRES).value_or(0);
  applyMarlin(numbers, delta);
  delta.lowest = 0;
  for (const char* const key : { "DELTA_RADIUS_TRIM_TOWER", "Z_MIN_POS" })
    reading.left_aside.push_back({ numbers.place, key, NOT_REPORTED });
  reading.left_aside.push_back({ numbers.place, "DELTA_PRINTABLE_RADIUS",
                                 "a report does not tell it: the lower limits are those of struts that lie flat" });
  reading.leaveKinds(otherCommand, "no part of the geometry");
  reading.leaveRest(reportReason);
}
}  // namespace firmware
}  // namespace pkm_workspace
