// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "formats.h"
#include "includes.h"
#include "ini.h"

// Klipper (Klipper3d/klipper): klippy/kinematics/delta.py has towers at radius * (cos, sin)(angle), the default angles,
// home at position_endstop + sqrt(arm^2 - radius^2) and the bounds of moves; klippy/configfile.py the comments, the
// block of SAVE_CONFIG and its precedence; its Config_Reference.md the units.

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const IniDialect KLIPPER = { ":=", true, true, true };
const std::string SAVED = "#*#";
const long DEFAULT_ANGLES[] = { 210, 330, 90 };  // degrees

bool beginsSaved(const SourceLine& line)
{
  return startsWith(line.text, SAVED + " <") && line.text.find("SAVE_CONFIG") != std::string::npos;
}

/// The lines of the block that a calibration saved, without what makes them comments.
std::vector<SourceLine> savedLines(const std::vector<SourceLine>& lines, Reading& reading)
{
  std::vector<SourceLine> saved;
  bool in_block = false;
  for (const SourceLine& line : lines)
  {
    in_block = in_block || beginsSaved(line);
    const bool is_saved = startsWith(line.text, SAVED);
    if (is_saved && line.text.size() > SAVED.size() && line.text[SAVED.size()] != ' ')
      reading.refuse(line.place, quoted(line.text), " has no blank after #*#, as Klipper writes it; write one");
    else if (in_block && is_saved)
      saved.push_back({ line.place, line.text.substr(std::min<std::size_t>(4, line.text.size())) });
    else if (in_block && !trimmed(line.text).empty())
      reading.refuse(line.place, quoted(line.text),
                     " stands after the beginning of the block of SAVE_CONFIG, whose "
                     "lines begin with #*#: Klipper ignores the whole block then; move "
                     "the line above it");
    else if (!in_block && is_saved)
      reading.refuse(line.place, quoted(line.text),
                     " belongs to a block of SAVE_CONFIG, whose first line is missing: "
                     "#*# <--- SAVE_CONFIG --->");
  }
  const auto is_heading = [](const SourceLine& line) {
    return line.text.find("SAVE_CONFIG") != std::string::npos || startsWith(line.text, "DO NOT EDIT");
  };
  saved.erase(std::remove_if(saved.begin(), saved.end(), is_heading), saved.end());
  return saved;
}

/// All lines but those of the block.
std::vector<SourceLine> regularLines(const std::vector<SourceLine>& lines)
{
  std::vector<SourceLine> regular;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(regular),
               [](const SourceLine& line) { return !startsWith(line.text, SAVED); });
  return regular;
}

/// The file that "[include file]" names.
std::string includedBy(const std::string& line)
{
  const std::string section = sectionOf(line.substr(0, line.find('#')));
  return startsWith(section, "include ") ? trimmed(section.substr(8)) : "";
}

/// What a calibration saved counts in place of what is written above.
void addEntries(const Source& source, Reading& reading)
{
  const std::vector<Entry> saved = readIni(savedLines(source.lines, reading), KLIPPER, reading);
  Includes includes(source, reading, includedBy);
  for (const Entry& entry : readIni(includes.expand(regularLines(source.lines)), KLIPPER, reading))
  {
    const auto same = [&](const Entry& other) { return other.key == entry.key; };
    const auto by = std::find_if(saved.begin(), saved.end(), same);
    if (by == saved.end())
      reading.add(entry);
    else
      reading.left_aside.push_back(
          { entry.place, entry.key, "what SAVE_CONFIG saved in line " + std::to_string(by->place.line) + " counts" });
  }
  for (const Entry& entry : saved)
    reading.add(entry);
}

void checkKinematics(Reading& reading)
{
  const Entry* const kinematics = reading.find("printer kinematics");
  if (kinematics == nullptr)
    reading.miss("[printer] kinematics", "expected kinematics: delta, which is a linear delta");
  else if (kinematics->text != "delta")
    reading.refuse(kinematics->place, "printer kinematics = ", quoted(kinematics->text),
                   " is not a linear delta; allowed: delta");
  else
    reading.take(*kinematics, "a linear delta");
}

/// A value of a tower. What stepper_b and stepper_c lack, they have from stepper_a.
std::optional<Decimal> ofTower(const std::string& section, const std::string& key, const std::string& what,
                               const Quantity& quantity, const std::optional<Decimal>& first, Reading& reading)
{
  const std::string full = section + " " + key;
  if (section == "stepper_a")
    return reading.needed(full, what, quantity, "write it into [stepper_a], in mm");
  if (first && !reading.has(full))
    return reading.assume(full, what, *first);
  return reading.value(full, what, quantity);
}

void readTower(std::size_t index, Reading& reading, LinearDelta& delta)
{
  Tower& tower = delta.towers[index];
  const Tower first = delta.towers[0];
  const std::string& section = tower.joint;
  tower.place = first.place;
  if (const Entry* const arm = reading.find(section + " arm_length"))
    tower.place = arm->place;
  tower.radius = first.radius;
  tower.arm = ofTower(section, "arm_length", "strut of " + section, MILLIMETRES, first.arm, reading);
  tower.home = ofTower(section, "position_endstop", "z of the tool in the middle, with " + section + " at its endstop",
                       SIGNED_MILLIMETRES, first.home, reading);
  const std::string direction = "direction of " + section;
  if (reading.has(section + " angle"))
    tower.angle = reading.value(section + " angle", direction, DEGREES);
  else
    tower.angle = reading.assume(section + " angle", direction, DEFAULT_ANGLES[index], "degrees");
}

std::string klipperReason(const Entry& entry)
{
  if (entry.key == "printer max_velocity" || entry.key == "printer max_z_velocity")
    return "a limit of the tool's speed, not of a carriage's";
  if (startsWith(entry.key, "printer "))
    return "speeds and other settings are not part of the geometry";
  const std::string key = entry.key.substr(entry.key.find(' ') + 1);
  if (key == "position_min" || key == "position_max")
    return "Klipper does not use it for a delta: its limits follow from position_endstop and minimum_z_position";
  return "drives, switches and speeds are not part of the geometry";
}

/// The section of an entry that has nothing to do with the towers; empty otherwise.
std::string otherSection(const Entry& entry)
{
  const std::size_t last_blank = entry.key.find_last_of(' ');
  const std::string section = entry.key.substr(0, last_blank);
  const bool is_asked = section == "printer" || section == "stepper_a" || section == "stepper_b" ||
                        section == "stepper_c" || startsWith(entry.key, "include ");
  return is_asked ? "" : "[" + section + "]";
}
}  // namespace

bool isKlipper(const std::vector<SourceLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(), [](const SourceLine& line) {
    const std::string section = sectionOf(line.text.substr(0, line.text.find('#')));
    return section == "printer" || section == "stepper_a" || section == "stepper_x";
  });
}

void readKlipper(const Source& source, Reading& reading, LinearDelta& delta)
{
  addEntries(source, reading);
  checkKinematics(reading);
  delta.towers[0].radius = reading.needed(
      "printer delta_radius", "radius, across from platform joint to slider joint with the tool in the middle",
      MILLIMETRES, "write it into [printer], in mm");
  delta.towers[0].joint = "stepper_a";
  delta.towers[1].joint = "stepper_b";
  delta.towers[2].joint = "stepper_c";
  for (std::size_t index = 0; index < delta.towers.size(); ++index)
    readTower(index, reading, delta);
  delta.lowest = reading.valueOr("printer minimum_z_position", "lowest z of the tool", SIGNED_MILLIMETRES, 0);
  delta.print_radius = reading.valueOr("printer print_radius", "largest distance of the tool from the middle",
                                       MILLIMETRES, delta.towers[0].radius.value_or(0));
  for (const Tower& tower : delta.towers)
    if (tower.arm && tower.radius && delta.print_radius && *tower.radius < *tower.arm)
      delta.print_radius = std::min(*delta.print_radius, *tower.arm - *tower.radius);
  reading.leaveKinds(otherSection, "no part of the geometry");
  reading.leaveRest(klipperReason);
}
}  // namespace firmware
}  // namespace pkm_workspace
