// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "defines.h"
#include "formats.h"
#include "marlin_delta.h"

// Marlin's Configuration.h (MarlinFirmware/Marlin, its comments and src/module/delta.cpp; older releases have three
// names with _1, _2, _3 for what is one list of three now, and MANUAL_Z_HOME_POS for DELTA_HEIGHT).
// src/module/motion.cpp, set_axis_is_at_home(): with a probe, home is its offset away from DELTA_HEIGHT (not from
// MANUAL_Z_HOME_POS).

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const char* const PROBES[] = {
  "BLTOUCH",           "FIX_MOUNTED_PROBE",     "NOZZLE_AS_PROBE",    "Z_PROBE_ALLEN_KEY", "SOLENOID_PROBE",
  "Z_PROBE_SLED",      "RACK_AND_PINION_PROBE", "SENSORLESS_PROBING", "TOUCH_MI_PROBE",    "MAGLEV4",
  "MAG_MOUNTED_PROBE", "BIQU_MICROPROBE_V1",    "BIQU_MICROPROBE_V2", "BD_SENSOR",         "Z_SERVO_ANGLES",
  "Z_PROBE_SERVO_NR"
};

class MarlinReader
{
public:
  MarlinReader(const Defines& defines, Reading& reading) : defines_(defines), reading_(reading) {}

  std::optional<Decimal> value(const std::string& key, const std::string& what, const Quantity& quantity)
  {
    return isDecided(key) ? reading_.value(key, what, quantity) : std::nullopt;
  }

  std::optional<Decimal> needed(const std::string& key, const std::string& what, const Quantity& quantity)
  {
    if (!isDecided(key))
      return std::nullopt;
    return reading_.needed(key, what, quantity, "write #define " + key + " with its length in mm");
  }

  /// A list { A, B, C }, or the names key_1, key_2 and key_3.
  MarlinDelta::Three three(const std::string& key, const std::string& what, const Quantity& quantity)
  {
    MarlinDelta::Three values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = value(key + "_" + std::to_string(i + 1), what + " of tower " + "ABC"[i], quantity);
    if (const Entry* const entry = isDecided(key) ? reading_.find(key) : nullptr)
      readList(*entry, what, quantity, values);
    return values;
  }

  /// The probe's distance from the nozzle along z [m], where there is a probe.
  Decimal probe()
  {
    const auto is_probe = [this](const char* name) {
      const std::vector<Entry>& active = defines_.active();
      return isDecided(name) &&
             std::any_of(active.begin(), active.end(), [&](const Entry& entry) { return entry.key == name; });
    };
    if (std::none_of(std::begin(PROBES), std::end(PROBES), is_probe))
      return 0;
    const std::string key = "NOZZLE_TO_PROBE_OFFSET";
    const std::string what = "z of the probe, seen from the nozzle, by which the tool homes away from DELTA_HEIGHT";
    if (!reading_.has(key))
      return value("Z_PROBE_OFFSET_FROM_EXTRUDER", what, TRIM_MILLIMETRES).value_or(0);
    MarlinDelta::Three offset;
    if (const Entry* const entry = isDecided(key) ? reading_.find(key) : nullptr)
      readList(*entry, "x, y and z of the probe, of which z shifts the tool's height at home,", SIGNED_MILLIMETRES,
               offset);
    return offset[2].value_or(0);
  }

private:
  /// Names in a branch that depends on what the file does not say are told once.
  bool isDecided(const std::string& key)
  {
    const std::string condition = defines_.undecided(key);
    if (!condition.empty() && told_.insert(key).second)
      complain(reading_.problems, condition, ": whether ", key,
               " counts depends on this condition, which the file does "
               "not decide; take the #if and the branches that are not built out");
    return condition.empty();
  }

  void readList(const Entry& entry, const std::string& what, const Quantity& quantity, MarlinDelta::Three& values)
  {
    const std::string& text = entry.text;
    const bool is_list = text.size() > 1 && text.front() == '{' && text.back() == '}';
    const std::vector<std::string> parts = split(is_list ? text.substr(1, text.size() - 2) : "", ',');
    if (parts.size() != values.size())
      return reading_.refuse(entry.place, entry.key, " = ", quoted(text),
                             " is not a list of three numbers; expected { A, "
                             "B, C } in ",
                             quantity.unit);
    std::string meaning = what;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = reading_.inRange(entry, parts[i], quantity);
      meaning += (i == 0 ? " " : ", ") + measure(values[i].value_or(0), quantity.si);
    }
    reading_.take(entry, meaning);
  }

  const Defines& defines_;
  Reading& reading_;
  std::set<std::string> told_;
};

std::string otherDefines(const Entry& entry)
{
  return entry.key.find("DELTA") == std::string::npos ? "other #defines" : "";
}

void readGeometry(MarlinReader& marlin, Reading& reading, LinearDelta& delta)
{
  MarlinDelta numbers;
  numbers.radius = marlin.needed("DELTA_RADIUS", "radius, across from effector joint to carriage joint", MILLIMETRES);
  numbers.rod = marlin.needed("DELTA_DIAGONAL_ROD", "struts", MILLIMETRES);
  const bool is_old = !reading.has("DELTA_HEIGHT") && reading.has("MANUAL_Z_HOME_POS");
  numbers.height =
      marlin.needed(is_old ? "MANUAL_Z_HOME_POS" : "DELTA_HEIGHT", "z of the tool at home", SIGNED_MILLIMETRES);
  numbers.probe_z = is_old ? Decimal(0) : marlin.probe();
  numbers.endstop = marlin.three("DELTA_ENDSTOP_ADJ", "home below the switches:", MARLIN_ENDSTOP);
  numbers.angle_trim = marlin.three("DELTA_TOWER_ANGLE_TRIM", "added to 210, 330 and 90 degrees:", TRIM_DEGREES);
  numbers.radius_trim = marlin.three("DELTA_RADIUS_TRIM_TOWER", "added to the radius:", TRIM_MILLIMETRES);
  numbers.rod_trim = marlin.three("DELTA_DIAGONAL_ROD_TRIM_TOWER", "added to the struts:", TRIM_MILLIMETRES);
  if (const Entry* const rod = reading.find("DELTA_DIAGONAL_ROD"))
    numbers.place = rod->place;
  applyMarlin(numbers, delta);
  for (const char* const key : { "DELTA_PRINTABLE_RADIUS", "PRINTABLE_RADIUS", "DELTA_MAX_RADIUS" })
  {
    const std::optional<Decimal> radius =
        marlin.value(key, "largest distance of the tool from the middle", MILLIMETRES);
    if (radius && (!delta.print_radius || *delta.print_radius < *radius))
      delta.print_radius = radius;
  }
  const std::string lowest = "lowest z of the tool";
  delta.lowest = reading.has("Z_MIN_POS") ? marlin.value("Z_MIN_POS", lowest, SIGNED_MILLIMETRES)
                                          : reading.assume("Z_MIN_POS", lowest, 0);
}
}  // namespace

bool isMarlin(const std::vector<SourceLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(),
                     [](const SourceLine& line) { return startsWith(trimmed(line.text), "#define "); });
}

void readMarlin(const Source& source, Reading& reading, LinearDelta& delta)
{
  const Defines defines(source.lines, reading);
  reading.evaluate = [&](const std::string& text) { return defines.evaluate(text); };
  reading.number_words = "a number, or a sum or product of numbers and of names that the file defines";
  for (const Entry& entry : defines.active())
    reading.add(entry);
  if (!defines.isEnabled("DELTA"))
    return reading.miss("#define DELTA", "only Marlin's linear deltas are read; is it commented out?");
  reading.find("DELTA");
  MarlinReader marlin(defines, reading);
  readGeometry(marlin, reading, delta);
  reading.leaveKinds(otherDefines, "no part of the geometry");
  reading.leaveRest([&](const Entry& entry) {
    return defines.wasUsed(entry.key) ? "goes into other values, or into conditions"
                                      : "calibration, speeds and menus are not part of the geometry";
  });
}
}  // namespace firmware
}  // namespace pkm_workspace
