// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "pkm_workspace/import/firmware.h"
#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// The text of a file in test/data/firmware/.
inline std::string sample(const std::string& name)
{
  std::ifstream file(std::string(PKM_WORKSPACE_SOURCE_DIR) + "/test/data/firmware/" + name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// The text with the one place of @p was replaced.
inline std::string edited(std::string text, const std::string& was, const std::string& is)
{
  const std::size_t at = text.find(was);
  if (at == std::string::npos || text.find(was, at + 1) != std::string::npos)
    throw std::logic_error("'" + was + "' is not in the text once");
  return text.replace(at, was.size(), is);
}

inline FirmwareMachine imported(const std::string& text, const std::string& format = "")
{
  return importFirmware({ "machine.cfg", text }, format);
}

inline void expectImportRefused(const std::string& text, const std::string& pattern, const std::string& format = "")
{
  SCOPED_TRACE(pattern);
  expectThrow<std::invalid_argument>([&] { imported(text, format); }, pattern);
}

/// One place of a text, what stands there instead, and what the refusal says.
struct Spoil
{
  const char* was;
  const char* is;
  const char* pattern;
};

inline void expectEditsRefused(const std::string& text, const std::vector<Spoil>& spoils)
{
  for (const Spoil& spoil : spoils)
    expectImportRefused(edited(text, spoil.was, spoil.is), spoil.pattern);
}

/// The reason for which a key was left aside; empty where it was not.
inline std::string reasonFor(const FirmwareMachine& machine, const std::string& key)
{
  for (const LeftAside& left : machine.left_aside)
    if (left.key == key)
      return left.reason;
  return "";
}

/// The meaning of the value that was taken of a key; empty where none was.
inline std::string meaningOf(const FirmwareMachine& machine, const std::string& key)
{
  for (const TakenValue& taken : machine.taken)
    if (taken.key == key)
      return taken.meaning;
  return "";
}

/// The machine as its URDF has it, in the axes of its towers.
inline Machine machineOf(MachineDescription description)
{
  description.mount.reset();
  return readUrdf(writeUrdf(description)).machine;
}

/// Carriages for a tool at (x, y, z), in millimetres, as a firmware has them.
using Carriages = std::function<std::array<double, 3>(double x, double y, double z)>;

/// Cranks for a tool at (x, y, z) [mm], in radians, as a firmware has them; not finite where it is out of reach.
using Cranks = std::function<std::array<double, 3>(double x, double y, double z)>;

/// Holds the machine against the firmware's own formula at 1000 points that it reaches within @p radius of the middle,
/// and between these heights [mm].
inline void expectSameCranks(const MachineDescription& description, double radius, double lowest, double highest,
                             const Cranks& firmware)
{
  const Machine machine = machineOf(description);
  Random random(SEED);
  int reached = 0;
  for (int k = 0; reached < 1000 && k < 5000; ++k)
  {
    const double x = random.uniform(-radius, radius);
    const double y = random.uniform(-radius, radius);
    const double z = random.uniform(lowest, highest);
    const std::array<double, 3> wanted = firmware(x, y, z);
    const auto angles = inverseKinematics(machine, Eigen::Vector3d(x, y, z) * 1e-3);
    const bool reaches = std::isfinite(wanted[0] + wanted[1] + wanted[2]);
    ASSERT_EQ(reaches, angles.has_value()) << "seed " << SEED << ", point " << k;
    reached += reaches ? 1 : 0;
    for (int i = 0; angles && i < 3; ++i)
      EXPECT_NEAR(std::remainder((*angles)[i] - wanted[static_cast<std::size_t>(i)], 2.0 * M_PI), 0.0, 1e-9)
          << "seed " << SEED << ", point " << k;
  }
  EXPECT_EQ(reached, 1000);
}

/// Holds the machine against the firmware's own formula at 1000 points within @p radius of the middle [mm].
inline void expectSameKinematics(const MachineDescription& description, double radius, const Carriages& firmware)
{
  const Machine machine = machineOf(description);
  Random random(SEED);
  for (int k = 0; k < 1000; ++k)
  {
    const double x = random.uniform(-radius, radius);
    const double y = random.uniform(-radius, radius);
    const double z = random.uniform(-20.0, 300.0);
    const std::array<double, 3> wanted = firmware(x, y, z);
    const auto rho = inverseKinematics(machine, Eigen::Vector3d(x, y, z) * 1e-3);
    ASSERT_TRUE(rho) << "seed " << SEED << ", point " << k;
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR((*rho)[i], wanted[static_cast<std::size_t>(i)] * 1e-3, 1e-9) << "seed " << SEED << ", point " << k;
  }
}
}  // namespace test
}  // namespace pkm_workspace
