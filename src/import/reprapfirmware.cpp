// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "formats.h"
#include "gcode.h"

// RepRapFirmware (Duet3D/RepRapFirmware): src/Movement/Kinematics/LinearDeltaKinematics.cpp. M665 L rods, R radius, H z
// at home, B radius that is printed, X Y Z corrections of the towers' angles; M666 X Y Z home above what H says, A and
// B the bed's slope along x and y in percent: a carriage is at sqrt(...) + z + slope_x x + slope_y y.

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const char* const RRF_JOINTS[] = { "tower_x", "tower_y", "tower_z" };
const long RRF_ANGLES[] = { 210, 330, 90 };  // degrees
const long DEFAULT_PRINT_RADIUS = 80;        // mm

/// M208 has S1 for lower ends; where a value has two numbers, the first one is the lower end.
void addLowestZ(const std::vector<GcodeCommand>& commands, Reading& reading)
{
  for (const GcodeCommand& command : commands)
  {
    if (command.code != "M208")
      continue;
    const auto is_word = [&](const char* key, const char* text) {
      return std::any_of(command.words.begin(), command.words.end(),
                         [&](const Entry& word) { return word.key == key && (*text == '\0' || word.text == text); });
    };
    for (const Entry& word : command.words)
    {
      const std::vector<std::string> ends = split(word.text, ':');
      if (word.key == "Z" && (is_word("S", "1") || ends.size() == 2))
        reading.add({ word.place, "M208 Z", ends[0] });
    }
  }
}

/// One length for all rods, or one for each.
void readRods(Reading& reading, LinearDelta& delta)
{
  const Entry* const rods = reading.find("M665 L");
  if (rods == nullptr)
    return reading.miss("M665 L", "it is the length of the rods in mm");
  const std::vector<std::string> parts = split(rods->text, ':');
  if (parts.size() != 1 && parts.size() != delta.towers.size())
    return reading.refuse(rods->place, "M665 L = ", quoted(rods->text), " is for ", parts.size(),
                          " towers, expected one length, or three with colons between them");
  std::string meaning = "struts:";
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
  {
    if (i < parts.size())
      delta.towers[i].arm = reading.inRange(*rods, parts[i], MILLIMETRES);
    else
      delta.towers[i].arm = delta.towers[0].arm;
    delta.towers[i].place = rods->place;
    meaning += (i == 0 ? " " : ", ") + measure(delta.towers[i].arm.value_or(0), "m");
  }
  reading.take(*rods, meaning);
}

void checkOtherKinematics(Reading& reading)
{
  if (const Entry* const kinematics = reading.find("M669 K"))
  {
    if (kinematics->text == "3")
      reading.take(*kinematics, "a linear delta");
    else
      reading.refuse(kinematics->place, "M669 K = ", quoted(kinematics->text), " is not a linear delta; allowed: 3");
  }
  for (const char* const key : { "M669 X", "M669 Y" })
    if (const Entry* const tower = reading.find(key))
      reading.refuse(tower->place, key, " = ", quoted(tower->text), " sets a fourth tower, expected three");
}

std::string rrfReason(const Entry& entry)
{
  return startsWith(entry.key, "M66") ? "no letter that LinearDeltaKinematics.cpp reads"
                                      : "on a delta only the lower end of Z is used";
}
}  // namespace

bool isRepRapFirmware(const std::vector<SourceLine>& lines)
{
  const std::vector<GcodeCommand> commands = readGcode(lines);
  const auto has = [&](const char* code) {
    return std::any_of(commands.begin(), commands.end(), [&](const GcodeCommand& c) { return c.code == code; });
  };
  return (has("M665") || has("M669")) && !isMarlinReport(lines);
}

void readRepRapFirmware(const Source& source, Reading& reading, LinearDelta& delta)
{
  const std::vector<GcodeCommand> commands = readGcode(source.lines);
  addCommands(commands, { "M665", "M666", "M669", "G20" }, reading);
  addLowestZ(commands, reading);
  checkOtherKinematics(reading);
  readRods(reading, delta);
  const auto radius = reading.needed("M665 R", "radius, across from effector joint to carriage joint", MILLIMETRES,
                                     "it is the radius of the towers in mm");
  const auto height =
      reading.needed("M665 H", "z of the tool at home", SIGNED_MILLIMETRES, "it is z of the tool at home in mm");
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
  {
    Tower& tower = delta.towers[i];
    const std::string letter(1, "XYZ"[i]);
    tower.joint = RRF_JOINTS[i];
    tower.radius = radius;
    tower.angle =
        reading.value("M665 " + letter, "correction of the angle of tower " + letter, TRIM_DEGREES).value_or(0) +
        Decimal(RRF_ANGLES[i]);
    const auto above =
        reading.value("M666 " + letter, "switch of tower " + letter + " above what H says", TRIM_MILLIMETRES);
    if (height)
      tower.home = *height + above.value_or(0);
  }
  delta.slope_x = reading.value("M666 A", "slope of the bed along x", PERCENT).value_or(0);
  delta.slope_y = reading.value("M666 B", "slope of the bed along y", PERCENT).value_or(0);
  delta.print_radius = reading.valueOr("M665 B", "largest distance of the tool from the middle", MILLIMETRES,
                                       Decimal(DEFAULT_PRINT_RADIUS, -3));
  delta.lowest = reading.valueOr("M208 Z", "lowest z of the tool", SIGNED_MILLIMETRES, 0);
  const auto no_limit = [](const Entry& entry) { return entry.key == "M208" ? "" : otherCommand(entry); };
  reading.leaveKinds(no_limit, "no part of the geometry");
  reading.leaveRest(rrfReason);
}
}  // namespace firmware
}  // namespace pkm_workspace
