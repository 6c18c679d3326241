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
// src/emc/kinematics/rotarydeltakins-common.h has thigh 0 towards -y and the next ones at 30 and 150 degrees; joints
// are degrees from level, larger ones knee-down, whatever the machine's units are.

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const IniDialect LINUXCNC = { "=", false, false, false };
const std::string LINEAR = "lineardeltakins", ROTARY = "rotarydeltakins";
const long LINUXCNC_ANGLES[] = { 90, 210, 330 };  // degrees
const long LINUXCNC_THIGHS[] = { 270, 30, 150 };
constexpr Quantity DEGREE_RATE = { "degrees/s", 0, 100000, 1, 0, "degrees/s" };

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

/// The module that is named; a linear delta's where it is none that is read.
std::string kinsOf(Reading& reading)
{
  const Entry* const kinematics = reading.find("KINS KINEMATICS");
  const std::string name = kinematics == nullptr ? "" : firstWord(kinematics->text);
  if (kinematics == nullptr)
    reading.miss("[KINS] KINEMATICS", "expected lineardeltakins or rotarydeltakins; is this the INI file?");
  else if (name != LINEAR && name != ROTARY)
    reading.refuse(kinematics->place, "KINS KINEMATICS = ", quoted(kinematics->text),
                   " is not a delta; allowed: lineardeltakins, rotarydeltakins");
  else
    reading.take(*kinematics, name == LINEAR ? "a linear delta" : "a rotary delta");
  return name == ROTARY ? ROTARY : LINEAR;
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

/// Adds what the HAL files set of the component. @return whether all of them were read
bool addPins(const Source& source, const std::string& kins, Reading& reading)
{
  HalPins pins(kins + ".");
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
std::optional<Decimal> pin(const std::string& key, const std::string& what, const Decimal& otherwise, bool all_read,
                           const Units& units, Reading& reading)
{
  if (reading.has(key) || !all_read)
    return reading.needed(key, what, units.length,
                          "put the HAL files beside the INI file, or write setp " + key + " into one that is read");
  return reading.assume(key, what, otherwise * Decimal(units.length.factor, units.length.exponent));
}

/// The section of a joint.
std::string sectionOfJoint(std::size_t index, const Reading& reading)
{
  const bool is_old = !reading.has("JOINT_0 MAX_LIMIT") && reading.has("AXIS_0 MAX_LIMIT");
  return (is_old ? "AXIS_" : "JOINT_") + std::to_string(index);
}

/// What both models have of a joint: a tower or a crank.
template <class Joint>
void readJoint(std::size_t index, const Quantity& unit, Reading& reading, Joint& joint)
{
  const std::string number = std::to_string(index);
  const std::string section = sectionOfJoint(index, reading);
  const std::string remedy = "write it into [" + section + "]: the end of the joint's travel";
  joint.joint = "joint_" + number;
  joint.lower = reading.needed(section + " MIN_LIMIT", "lower limit of joint " + number, unit, remedy);
  joint.upper = reading.needed(section + " MAX_LIMIT", "upper limit of joint " + number, unit, remedy);
  if (const Entry* const limit = reading.find(section + " MAX_LIMIT"))
    joint.place = limit->place;
}

void readLinear(bool all_read, const Units& units, Reading& reading, LinearDelta& delta)
{
  const auto arm = pin(LINEAR + ".L", "struts", 269, all_read, units, reading);
  const auto radius = pin(LINEAR + ".R", "radius, across from effector joint to carriage joint", Decimal(13025, -2),
                          all_read, units, reading);
  for (std::size_t i = 0; i < delta.towers.size(); ++i)
  {
    Tower& tower = delta.towers[i];
    const std::string number = std::to_string(i);
    tower.arm = arm;
    tower.radius = radius;
    tower.angle = Decimal(LINUXCNC_ANGLES[i]);
    readJoint(i, units.joint, reading, tower);
    tower.speed =
        reading.value(sectionOfJoint(i, reading) + " MAX_VELOCITY", "largest speed of joint " + number, units.speed);
    tower.height = -reading.value(LINEAR + ".J" + number + "off", "offset of joint " + number, units.joint).value_or(0);
  }
}

void readRotary(bool all_read, const Units& units, Reading& reading, RotaryDelta& delta)
{
  Units with_zero = units;  // a radius may be small
  with_zero.length.least = 0;
  const auto length = [&](const std::string& name, const char* what, long otherwise) {
    const bool is_radius = name == "platformradius" || name == "footradius";
    return pin(ROTARY + "." + name, what, otherwise, all_read, is_radius ? with_zero : units, reading);
  };
  delta.base_radius = length("platformradius", "radius of the cranks' axes", 10);
  delta.crank = length("thighlength", "cranks", 10);
  delta.forearm = length("shinlength", "forearms", 14);
  delta.platform_radius = length("footradius", "radius of the forearms' lower ends", 6);
  delta.place.file = reading.file;
  if (const Entry* const shin = reading.find(ROTARY + ".shinlength"))
    delta.place = shin->place;
  for (std::size_t i = 0; i < delta.cranks.size(); ++i)
  {
    DrivenCrank& crank = delta.cranks[i];
    crank.angle = Decimal(LINUXCNC_THIGHS[i]);
    readJoint(i, CRANK_DEGREES, reading, crank);
    const auto rate = reading.value(sectionOfJoint(i, reading) + " MAX_VELOCITY",
                                    "largest speed of joint " + std::to_string(i), DEGREE_RATE);
    crank.speed = (rate.value_or(0) * radianOfDegree()).nearest();
  }
}

void checkPins(const std::string& kins, Reading& reading)
{
  const std::string allowed =
      kins == LINEAR ? "L, R, J0off, J1off, J2off" : "platformradius, thighlength, shinlength, footradius";
  const std::vector<std::string> names = split(allowed, ',');
  for (const Entry& entry : reading.entries())
    if (startsWith(entry.key, kins + ".") &&
        std::find(names.begin(), names.end(), entry.key.substr(kins.size() + 1)) == names.end())
      reading.refuse(entry.place, entry.key, " = ", quoted(entry.text),
                     " changes the kinematics in a way that is not read; allowed: ", allowed);
}

std::string linuxcncSection(const Entry& entry)
{
  const std::string section = entry.key.substr(0, entry.key.find_last_of(' '));
  const bool is_told = startsWith(section, "JOINT_") || startsWith(section, "AXIS_") || section == "KINS" ||
                       startsWith(entry.key, LINEAR + ".") || startsWith(entry.key, ROTARY + ".") ||
                       entry.key == "HAL HALFILE" || entry.key == "HAL HALCMD";
  return is_told ? "" : "[" + section + "]";
}

std::string linuxcncReason(const Entry& entry)
{
  if (entry.key == "HAL HALFILE" || entry.key == "HAL HALCMD")
    return "read for the pins of the kinematics only";
  const bool is_tool = startsWith(entry.key, "AXIS_") && entry.key.find("_LIMIT") != std::string::npos;
  return is_tool ? "a limit of the tool, not of a joint"
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

MachineDescription readLinuxCnc(const Source& source, Reading& reading, const std::string& name)
{
  Includes includes(source, reading, includedByIni);
  for (const Entry& entry : readIni(includes.expand(source.lines), LINUXCNC, reading))
    reading.add(entry);
  const std::string kins = kinsOf(reading);
  const Units units = unitsOf(reading);
  const bool all_read = addPins(source, kins, reading);
  checkPins(kins, reading);
  LinearDelta linear;
  RotaryDelta rotary;
  kins == LINEAR ? readLinear(all_read, units, reading, linear) : readRotary(all_read, units, reading, rotary);
  reading.leaveKinds(linuxcncSection, "no part of the geometry");
  reading.leaveRest(linuxcncReason);
  kins == LINEAR ? checkDelta(linear, reading) : checkDelta(rotary, reading);
  throwProblems(reading.problems);
  return kins == LINEAR ? describe(linear, name) : describe(rotary, name);
}
}  // namespace firmware
}  // namespace pkm_workspace
