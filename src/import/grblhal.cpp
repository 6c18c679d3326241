// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "formats.h"

// grblHAL (grblHAL/core): kinematics/delta.c has cranks at 270, 30 and 150 degrees, in radians from level, larger ones
// further down; settings.h numbers its settings from $640 on. Its text calls $643 and $644 radii, but its formulas take
// them, as those of mzavatsky on which they are based and FluidNC's base_triangle_mm do, for sides of equilateral
// triangles whose inscribed circles the axes and the forearms' ends touch: radius = side tan(30 degrees) / 2. The
// largest rates $110 to $112 are in rad/min.

namespace pkm_workspace
{
namespace firmware
{
namespace
{
const long GRBLHAL_ANGLES[] = { 270, 30, 150 };  // degrees
constexpr Quantity RATE = { "rad/min", 0, 100000, 1, 0, "rad/min" };

/// 1 / sqrt(12), the radius of the inscribed circle of an equilateral triangle with the side 1.
const Decimal& radiusOfSide()
{
  static const Decimal radius = *Decimal::parse("0.28867513459481288225457439025097872782");
  return radius;
}

/// A line "$643=75.000", after which a terminal may explain it.
std::optional<Entry> settingIn(const SourceLine& line)
{
  const std::string text = trimmed(line.text);
  const std::size_t sign = text.find('=');
  if (text.empty() || text[0] != '$' || sign == std::string::npos)
    return std::nullopt;
  return Entry{ line.place, text.substr(0, sign), text.substr(sign + 1, text.find_first_of(" \t(", sign) - sign - 1) };
}

std::optional<Decimal> radiusOf(const std::string& key, const std::string& what, Reading& reading)
{
  const auto side = reading.needed(key, "side of the triangle whose inscribed circle " + what, MILLIMETRES,
                                   "the answer to $$ has it");
  return side ? std::optional<Decimal>(*side * radiusOfSide()) : std::nullopt;
}

void readCrank(std::size_t index, Reading& reading, DrivenCrank& crank)
{
  const std::string key = "$11" + std::to_string(index);
  crank.joint = std::string("motor_") + "abc"[index];
  crank.angle = Decimal(GRBLHAL_ANGLES[index]);
  crank.speed = reading.value(key, "largest rate of " + crank.joint, RATE).value_or(0).nearest() / 60.0;
}

std::string grblHalReason(const Entry& entry)
{
  if (entry.key == "$645" || entry.key == "$647")
    return "a limit of the tool, not of a crank";
  return "no part of the geometry";
}
}  // namespace

bool isGrblHal(const std::vector<SourceLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(), [](const SourceLine& line) {
    const auto setting = settingIn(line);
    return setting && setting->key == "$644";
  });
}

void readGrblHal(const Source& source, Reading& reading, RotaryDelta& delta)
{
  for (const SourceLine& line : source.lines)
    if (const auto setting = settingIn(line))
      reading.add(*setting);
  const std::string remedy = "the answer to $$ has it";
  delta.forearm = reading.needed("$641", "forearms", MILLIMETRES, remedy);
  delta.crank = reading.needed("$642", "cranks", MILLIMETRES, remedy);
  delta.base_radius = radiusOf("$643", "the cranks' axes touch", reading);
  delta.platform_radius = radiusOf("$644", "the forearms' lower ends touch", reading);
  if (const Entry* const forearm = reading.find("$641"))
    delta.place = forearm->place;
  const auto lower = reading.needed("$646", "lower limits, where the cranks are homed", CRANK_DEGREES, remedy);
  const auto upper =
      reading.needed("$648", "upper limits", CRANK_DEGREES, "the answer to $$ of release v0.03 on has it");
  const Entry* const limit = reading.find("$648");
  if (upper && *upper == Decimal(0))
    reading.refuse(limit->place,
                   "$648 = 0 has the firmware compute how far the cranks may turn; write the largest angle "
                   "that they can, in degrees down from level");
  for (std::size_t i = 0; i < delta.cranks.size(); ++i)
  {
    readCrank(i, reading, delta.cranks[i]);
    delta.cranks[i].lower = lower;
    delta.cranks[i].upper = upper;
    delta.cranks[i].place = limit == nullptr ? delta.place : limit->place;
  }
  reading.leaveRest(grblHalReason);
}
}  // namespace firmware
}  // namespace pkm_workspace
