// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "expect_import.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const char* const SAMPLES[] = {
  "klipper.cfg", "marlin_configuration.txt", "marlin_report.txt", "config.g", "ldelta.ini", "rdelta.ini", "grblhal.txt"
};

/// The text with a few bytes, words or lines changed, as an editor or a bad line would.
std::string spoilt(std::string text, Random& random)
{
  static const char* const PIECES[] = { "",    "\n",   "[",    "]",       "=",    ":",    "#if ", "#endif\n",
                                        "(",   "{",    "\"",   "/*",      "-",    "1e60", "0",    "9999",
                                        "nan", "\\\n", "\xC3", "M665 L1", "#*#",  ";",    "[x]",  ",",
                                        "0x1", "\t",   "\r",   ".",       "DELTA" };
  const int changes = random.integer(1, 4);
  for (int k = 0; k < changes && !text.empty(); ++k)
  {
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
    const auto length = static_cast<std::size_t>(random.once(2) ? random.integer(0, 3) : random.integer(0, 60));
    const auto piece = static_cast<std::size_t>(random.integer(0, static_cast<int>(std::size(PIECES)) - 1));
    text.replace(at, length, random.once(4) ? text.substr(at, 2 * length) : PIECES[piece]);
  }
  return text;
}

/// What is read is a machine: every strut reaches, every limit has room.
void expectMachine(const FirmwareMachine& machine)
{
  for (const LegDescription& leg : machine.machine.legs)
  {
    const bool is_rail = leg.kind == LegDescription::Kind::RAIL;
    EXPECT_GT(leg.length, is_rail ? leg.radius : leg.radius + leg.crank - leg.platform_joint.x());
    EXPECT_TRUE(is_rail ? leg.radius > 0.0 : leg.radius >= 0.0 && leg.crank > 0.0);
    EXPECT_LT(leg.lower, leg.upper);
    EXPECT_TRUE(std::isfinite(leg.angle) && std::isfinite(leg.height));
  }
}

TEST(Firmware, SpoiltTextsAreReadOrRefused)
{
  const auto other = [](const std::string& name) { return std::optional<std::string>(sample(name)); };
  for (const char* const name : SAMPLES)
  {
    const std::string text = sample(name);
    const std::string format = importFirmware({ name, text, other }).format;
    Random random(SEED);
    int refused = 0;
    const int times = cases(400);
    for (int k = 0; k < times; ++k)
    {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(SEED) + ", case " + std::to_string(k));
      try
      {
        expectMachine(importFirmware({ name, spoilt(text, random), other }, random.once(2) ? format : ""));
      }
      catch (const std::invalid_argument& reason)
      {
        EXPECT_STRNE(reason.what(), "");
        ++refused;
      }
    }
    EXPECT_GT(refused, times / 20) << name;
    EXPECT_LT(refused, times) << name;
  }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
