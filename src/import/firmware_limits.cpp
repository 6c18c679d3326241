// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/firmware_limits.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"

// What each firmware makes of its limits: Klipper's klippy/kinematics/delta.py (check_move), Marlin's
// src/module/motion.cpp (update_software_endstops, apply_motion_limits), RepRapFirmware's
// src/Movement/Kinematics/LinearDeltaKinematics.cpp (LimitPosition) and its issue 997, LinuxCNC's
// src/emc/motion/command.c (inRange).

namespace pkm_workspace
{
namespace
{
/// Single precision misses less than that of lengths below 10 m, and so does the slack of Marlin's radius [m].
constexpr double MARGIN = 1e-6;
constexpr int MICROMETRE_DIGITS = 6;

/// "109.998" of "0.109998".
std::string inMillimetres(const std::string& metres)
{
  std::string digits;
  std::copy_if(metres.begin(), metres.end(), std::back_inserter(digits), [](char c) { return c >= '0' && c <= '9'; });
  std::string whole = digits.substr(0, digits.size() - 3);
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
  return (metres[0] == '-' ? "-" : "") + whole + "." + digits.substr(digits.size() - 3);
}

std::string inward(double limit, bool is_lower)
{
  const Interval margin(MARGIN);
  return inMillimetres(is_lower ? roundedUp((Interval(limit) + margin).upper(), MICROMETRE_DIGITS)
                                : roundedDown((Interval(limit) - margin).lower(), MICROMETRE_DIGITS));
}

using Values = std::vector<std::pair<std::string, std::string>>;

std::string klipper(const Values& values)
{
  return "[printer]\n" + values[0].first + ": " + values[0].second + "\n" + values[1].first + ": " + values[1].second +
         "\n";
}

std::string marlin(const Values& values)
{
  return "#define " + values[0].first + " " + values[0].second + "\n#define " + values[1].first + " " +
         values[1].second + "\n#define MIN_SOFTWARE_ENDSTOPS\n#define MIN_SOFTWARE_ENDSTOP_Z\n";
}

std::string repRapFirmware(const Values& values)
{
  return "M665 B" + values[0].second + "\nM208 Z" + values[1].second + " S1\nM564 S1\n";
}

std::string linuxCnc(const Values& values)
{
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis)
    text += std::string("[AXIS_") + "XYZ"[axis] + "]\nMIN_LIMIT = " + values[2 * axis].second +
            "\nMAX_LIMIT = " + values[2 * axis + 1].second + "\n";
  return text;
}

struct LimitFormat
{
  const char* name;
  const char* comment;  ///< what a line of comment begins with
  bool is_round;
  std::array<const char*, 6> keys;
  std::string (*write)(const Values& values);
  std::vector<std::string> hints;
};

const LimitFormat LIMIT_FORMATS[] = {
  { "klipper", "# ", true, { "print_radius", "minimum_z_position" }, klipper, { "Replace these keys of [printer]." } },
  { "marlin",
    "// ",
    true,
    { "PRINTABLE_RADIUS", "Z_MIN_POS" },
    marlin,
    { "Replace these lines of Configuration.h. Older releases: DELTA_PRINTABLE_RADIUS in place of PRINTABLE_RADIUS.",
      "X_MIN_POS, X_MAX_POS, Y_MIN_POS, Y_MAX_POS have to be -(PRINTABLE_RADIUS) and PRINTABLE_RADIUS, as they "
      "come." } },
  { "reprapfirmware",
    "; ",
    true,
    { "M665 B", "M208 Z" },
    repRapFirmware,
    { "At the end of config.g, after M665, M666 and M208, and after M501.",
      "Release 3.5.1 does not hold M665 B (issue 997 of Duet3D/RepRapFirmware)." } },
  { "linuxcnc",
    "# ",
    false,
    { "AXIS_X MIN_LIMIT", "AXIS_X MAX_LIMIT", "AXIS_Y MIN_LIMIT", "AXIS_Y MAX_LIMIT", "AXIS_Z MIN_LIMIT",
      "AXIS_Z MAX_LIMIT" },
    linuxCnc,
    { "Replace these keys of the INI file, where LINEAR_UNITS = mm.",
      "LinuxCNC looks at the ends of moves: an arc with both ends in the box may leave it." } },
};

const LimitFormat& limitFormat(const std::string& name)
{
  const auto* const found = std::find_if(std::begin(LIMIT_FORMATS), std::end(LIMIT_FORMATS),
                                         [&](const LimitFormat& format) { return format.name == name; });
  if (found == std::end(LIMIT_FORMATS))
    throw std::invalid_argument("limits cannot be written for '" + name + "'");
  return *found;
}

void refuseEmpty(const std::string& lower, const std::string& upper)
{
  if (*parseNumber(lower) >= *parseNumber(upper))
    throw std::invalid_argument("the region is too small: rounded inward, its limits " + lower + " and " + upper +
                                " mm leave nothing; give one of 0.01 mm or more");
}

std::string withoutBreaks(std::string line)
{
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  return line;
}
}  // namespace

std::vector<std::string> limitFormats()
{
  std::vector<std::string> names;
  for (const LimitFormat& format : LIMIT_FORMATS)
    names.emplace_back(format.name);
  return names;
}

bool holdsCylinders(const std::string& format)
{
  return limitFormat(format).is_round;
}

FirmwareLimits writeLimits(const std::string& name, const HeldRegion& region, const std::vector<std::string>& comments)
{
  const LimitFormat& format = limitFormat(name);
  if (format.is_round != region.radius.has_value())
    throw std::invalid_argument(
        name + " holds a " +
        (format.is_round ? "radius about the z axis, and no box" : "range of each axis, and no radius"));
  FirmwareLimits limits;
  const auto add = [&](double value, bool is_lower) {
    limits.values.emplace_back(format.keys[limits.values.size()], inward(value, is_lower));
  };
  if (region.radius)
  {
    add(*region.radius, false);
    add(region.box.lower.z(), true);
    refuseEmpty("0", limits.values[0].second);
  }
  for (int axis = 0; axis < 3 && !region.radius; ++axis)
  {
    add(region.box.lower[axis], true);
    add(region.box.upper[axis], false);
    refuseEmpty(limits.values.rbegin()[1].second, limits.values.back().second);
  }
  for (const auto* const lines : { &comments, &format.hints })
    for (const std::string& line : *lines)
      limits.text += format.comment + withoutBreaks(line) + "\n";
  limits.text += format.write(limits.values);
  return limits;
}
}  // namespace pkm_workspace
