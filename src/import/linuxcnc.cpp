// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "formats.h"
#include "hal.h"
#include "includes.h"
#include "ini.h"

// LinuxCNC (LinuxCNC/linuxcnc): src/emc/kinematics/lineardeltakins-common.h has tower 0 at (0, R) and the next ones at
// (-R sin 60, -R / 2) and (R sin 60, -R / 2), which is counter-clockwise; joints at z + sqrt(L^2 - ...), plus J0off,
// J1off, J2off where a release has these pins. R and L are pins of the HAL, in the units of the machine like the limits
// of joints, [JOINT_n] MIN_LIMIT and MAX_LIMIT ([AXIS_n] before joints had sections of their own).

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const IniDialect LINUXCNC = { "=", false, false, false };
const std::string PINS = "lineardeltakins.";
const long LINUXCNC_ANGLES[] = { 90, 210, 330 };  // degrees

/// The units of a machine, for lengths of it and for joint values.
struct Units
{
  Quantity length;
  Quantity joint;
  Quantity speed;
};
constexpr Units METRIC = { MILLIMETRES, SIGNED_MILLIMETRES, { "mm/s", 0, 100000, 1, -3, "m/s" } };
constexpr Units IMPERIAL = { { "inches", 1, 4000, 254, -4, "m" },
                             { "inches", -4000, 4000, 254, -4, "m" },
                             { "inches/s", 0, 4000, 254, -4, "m/s" } };

std::string firstWord(const std::string& text)
{
  return text.substr(0, text.find_first_of(" \t"));
}

Units unitsOf(Reading& reading)
{
  const Entry* const units = reading.find("TRAJ LINEAR_UNITS");
  if (units == nullptr)
  {
    reading.miss("[TRAJ] LINEAR_UNITS", "expected mm or inch, the units of the machine");
    return METRIC;
  }
  const bool metric = units->text == "mm" || units->text == "metric";
  const bool imperial = units->text == "in" || units->text == "inch" || units->text == "imperial";
  if (metric || imperial)
    reading.take(*units, metric ? "lengths are millimetres" : "lengths are inches of 0.0254 m");
  else
    reading.refuse(units->place, "TRAJ LINEAR_UNITS = ", quoted(units->text), " is not a unit; allowed: mm, inch");
  return imperial ? IMPERIAL : METRIC;
}

void checkKins(Reading& reading)
{
  const Entry* const kinematics = reading.find("KINS KINEMATICS");
  if (kinematics == nullptr)
    reading.miss("[KINS] KINEMATICS", "expected lineardeltakins; is this the INI file?");
  else if (firstWord(kinematics->text) != "lineardeltakins")
    reading.refuse(kinematics->place, "KINS KINEMATICS = ", quoted(kinematics->text),
                   " is not a linear delta; allowed: lineardeltakins");
  else
    reading.take(*kinematics, "a linear delta");
}

/// A value of the HAL, where [SECTION]KEY or [SECTION](KEY) stands for a value of the INI file.
std::string substituted(const std::string& text, const Reading& reading)
{
  const std::size_t end = text.find(']');
  if (text.empty() || text[0] != '[' || end == std::string::npos)
    return text;
  std::string key = text.substr(end + 1);
  if (key.size() > 1 && key.front() == '(' && key.back() == ')')
    key = key.substr(1, key.size() - 2);
  for (const Entry& entry : reading.entries())
    if (entry.key == text.substr(1, end - 1) + " " + key)
      return entry.text;
  return text;
}

/// The file that "#INCLUDE file" names, in an INI file.
std::string includedByIni(const std::string& line)
{
  return startsWith(line, "#INCLUDE ") ? trimmed(line.substr(9)) : "";
}

/// The file that "source file" names, in a HAL file.
std::string includedByHal(const std::string& line)
{
  const std::string text = trimmed(line.substr(0, line.find('#')));
  return startsWith(text, "source ") ? trimmed(text.substr(7)) : "";
}

/// Adds what the HAL files set. @return whether all of them were read
bool addPins(const Source& source, Reading& reading)
{
  HalPins pins(PINS);
  Includes includes(source, reading, includedByHal);
  bool all = true;
  const std::vector<Entry> entries = reading.entries();
  for (const Entry& entry : entries)
  {
    if (entry.key != "HAL HALFILE" && entry.key != "HAL POSTGUI_HALFILE")
      continue;
    const std::string word = firstWord(entry.text);
    const std::string name = startsWith(word, "LIB:") ? word.substr(4) : word;
    const bool is_tcl = name.size() > 4 && name.substr(name.size() - 4) == ".tcl";
    const std::size_t left = reading.left_aside.size();
    if (is_tcl)
      reading.left_aside.push_back({ entry.place, entry.key, "the file " + quoted(name) + " is Tcl: it is not run" });
    else
      pins.read(includes.expand(otherLines(source, { entry.place, entry.key, name }, name, reading)));
    all = all && reading.left_aside.size() == left;
  }
  for (const Entry& entry : entries)
    if (entry.key == "HAL HALCMD")  // after the files, as LinuxCNC runs them
      pins.read({ { entry.place, entry.text } });
  for (const Entry& pin : pins.values())
    reading.add({ pin.place, pin.key, substituted(pin.text, reading) });
  return all;
}

/// What is not set is the firmware's own, where nothing that was not read can set it.
std::optional<Decimal> pin(const std::string& name, const std::string& what, const Decimal& otherwise, bool all_read,
                           const Units& units, Reading& reading)
{
  const std::string key = PINS + name;
  if (reading.has(key) || !all_read)
    return reading.needed(key, what, units.length,
                          "put the HAL files beside the INI file, or write setp " + key + " into one that is read");
  return reading.assume(key, what, otherwise * Decimal(units.length.factor, units.length.exponent));
}

void readJoint(std::size_t index, const Units& units, Reading& reading, Tower& tower)
{
  const std::string number = std::to_string(index);
  const bool is_old = !reading.has("JOINT_0 MAX_LIMIT") && reading.has("AXIS_0 MAX_LIMIT");
  const std::string section = (is_old ? "AXIS_" : "JOINT_") + number;
  const std::string remedy = "write it into [" + section + "]: the end of the carriage's travel";
  tower.joint = "joint_" + number;
  tower.angle = Decimal(LINUXCNC_ANGLES[index]);
  tower.lower = reading.needed(section + " MIN_LIMIT", "lower limit of joint " + number, units.joint, remedy);
  tower.upper = reading.needed(section + " MAX_LIMIT", "upper limit of joint " + number, units.joint, remedy);
  tower.speed = reading.value(section + " MAX_VELOCITY", "largest speed of joint " + number, units.speed);
  tower.height = -reading.value(PINS + "J" + number + "off", "offset of joint " + number, units.joint).value_or(0);
  if (const Entry* const limit = reading.find(section + " MAX_LIMIT"))
    tower.place = limit->place;
}

void checkPins(Reading& reading)
{
  for (const Entry& entry : reading.entries())
  {
    const std::string name = startsWith(entry.key, PINS) ? entry.key.substr(PINS.size()) : "L";
    if (name != "L" && name != "R" && name != "J0off" && name != "J1off" && name != "J2off")
      reading.refuse(entry.place, entry.key, " = ", quoted(entry.text),
                     " changes the kinematics in a way that is not read; allowed: L, R, J0off, J1off, J2off");
  }
}

std::string linuxcncSection(const Entry& entry)
{
  const std::string section = entry.key.substr(0, entry.key.find_last_of(' '));
  const bool is_told = startsWith(section, "JOINT_") || startsWith(section, "AXIS_") || section == "KINS" ||
                       startsWith(entry.key, PINS) || entry.key == "HAL HALFILE" || entry.key == "HAL HALCMD";
  return is_told ? "" : "[" + section + "]";
}

std::string linuxcncReason(const Entry& entry)
{
  if (entry.key == "HAL HALFILE" || entry.key == "HAL HALCMD")
    return "read for the pins of lineardeltakins only";
  const bool is_tool = startsWith(entry.key, "AXIS_") && entry.key.find("_LIMIT") != std::string::npos;
  return is_tool ? "a limit of the tool, not of a carriage"
                 : "accelerations, homing and further joints are not part of the machine";
}
}  // namespace

bool isLinuxCnc(const std::vector<SourceLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(), [](const SourceLine& line) {
    const std::string section = sectionOf(line.text);
    return section == "KINS" || section == "EMCMOT" || section == "TRAJ";
  });
}

void readLinuxCnc(const Source& source, Reading& reading, LinearDelta& delta)
{
  Includes includes(source, reading, includedByIni);
  for (const Entry& entry : readIni(includes.expand(source.lines), LINUXCNC, reading))
    reading.add(entry);
  checkKins(reading);
  const Units units = unitsOf(reading);
  const bool all_read = addPins(source, reading);
  checkPins(reading);
  const auto arm = pin("L", "struts", 269, all_read, units, reading);
  const auto radius =
      pin("R", "radius, across from effector joint to carriage joint", Decimal(13025, -2), all_read, units, reading);
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
  {
    delta.towers[i].arm = arm;
    delta.towers[i].radius = radius;
    readJoint(i, units, reading, delta.towers[i]);
  }
  reading.leaveKinds(linuxcncSection, "no part of the geometry");
  reading.leaveRest(linuxcncReason);
}
}  // namespace firmware
}  // namespace pkm_workspace
