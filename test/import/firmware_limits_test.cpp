// SPDX-License-Identifier: BSD-3-Clause
// What is written is read as the firmware reads it, in its precision: what that lets pass lies in the region.
#include "pkm_workspace/import/firmware_limits.h"

#include <gtest/gtest.h>

#include <regex>

#include "pkm_workspace/interval/decimal.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
/// The one number after this pattern at the beginning of a line [mm].
double valueAfter(const std::string& pattern, const std::string& text)
{
  const std::regex line("(?:^|\n)" + pattern + "(-?[0-9.]+)(?= S1\n|\n)");
  const auto begin = std::sregex_iterator(text.begin(), text.end(), line);
  EXPECT_EQ(std::distance(begin, std::sregex_iterator()), 1) << pattern << " in\n" << text;
  return begin == std::sregex_iterator() ? 0.0 : *parseNumber((*begin)[1]);
}

/// Within the region, by less than 3 micrometres, in double and in single precision. @param sign -1 for a lower limit
void expectWithin(double millimetres, double metres, double sign, const std::string& text)
{
  constexpr double MARLIN_SLACK = 0.0001;  // mm, that its radius is exceeded by
  for (const double value : { millimetres, static_cast<double>(static_cast<float>(millimetres)) })
  {
    EXPECT_LT(sign * value + MARLIN_SLACK, sign * 1000.0 * metres) << text;
    EXPECT_GT(sign * value + 0.003, sign * 1000.0 * metres) << text;
  }
}

struct RoundFormat
{
  const char* name;
  const char* radius;
  const char* lowest;
};

const RoundFormat ROUND_FORMATS[] = {
  { "klipper", "print_radius: ", "minimum_z_position: " },
  { "marlin", "#define PRINTABLE_RADIUS ", "#define Z_MIN_POS " },
  { "reprapfirmware", "M665 B", "M208 Z" },
};
}  // namespace

TEST(FirmwareLimits, holdNothingOutOfACylinder)
{
  test::Random random(test::SEED);
  for (int k = 0; k < test::cases(200); ++k)
  {
    HeldRegion region;
    region.radius = random.once(4) ? 0.05 : random.uniform(1e-5, 2.0);
    region.box.lower.z() = random.once(4)   ? 0.0
                           : random.once(4) ? random.uniform(-1e-5, 1e-5)
                                            : random.uniform(-3.0, 3.0);
    region.box.upper.z() = region.box.lower.z() + 1.0;
    for (const RoundFormat& format : ROUND_FORMATS)
    {
      const std::string text = writeLimits(format.name, region, {}).text;
      expectWithin(valueAfter(format.radius, text), *region.radius, 1.0, text);
      expectWithin(valueAfter(format.lowest, text), region.box.lower.z(), -1.0, text);
    }
  }
}

TEST(FirmwareLimits, holdNothingOutOfABox)
{
  test::Random random(test::SEED);
  for (int k = 0; k < test::cases(200); ++k)
  {
    HeldRegion region;
    for (int axis = 0; axis < 3; ++axis)
    {
      region.box.lower[axis] = random.uniform(-2.0, 2.0);
      region.box.upper[axis] = region.box.lower[axis] + random.uniform(1e-5, 2.0);
    }
    const std::string text = writeLimits("linuxcnc", region, {}).text;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::string section = std::string("\\[AXIS_") + "XYZ"[axis] + "\\]\n";
      const double lower = valueAfter(section + "MIN_LIMIT = ", text);
      const double upper = valueAfter(section + "MIN_LIMIT = [0-9.-]+\nMAX_LIMIT = ", text);
      expectWithin(lower, region.box.lower[axis], -1.0, text);
      expectWithin(upper, region.box.upper[axis], 1.0, text);
    }
  }
}

TEST(FirmwareLimits, keepCommentsInComments)
{
  HeldRegion region;
  region.radius = 0.1;
  region.box.upper.z() = 1.0;
  for (const RoundFormat& format : ROUND_FORMATS)
  {
    const std::string text = writeLimits(format.name, region, { "a\nM665 B500\rprint_radius: 500" }).text;
    EXPECT_NE(text.find("a M665 B500 print_radius: 500\n"), std::string::npos) << text;
    EXPECT_NEAR(valueAfter(format.radius, text), 100.0, 0.003);
  }
}

TEST(FirmwareLimits, refuseWhatAFirmwareCannotHold)
{
  HeldRegion region;
  region.box.upper = Eigen::Vector3d::Ones();
  test::expectThrow<std::invalid_argument>([&] { writeLimits("klipper", region, {}); }, "radius about the z axis");
  region.radius = 0.1;
  test::expectThrow<std::invalid_argument>([&] { writeLimits("linuxcnc", region, {}); }, "range of each axis");
  region.radius = 1e-6;
  test::expectThrow<std::invalid_argument>([&] { writeLimits("marlin", region, {}); }, "the region is too small");
  test::expectThrow<std::invalid_argument>([&] { writeLimits("grbl", region, {}); }, "cannot be written for 'grbl'");
}
}  // namespace pkm_workspace
