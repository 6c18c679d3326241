// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <boost/crc.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "fuzz/targets.h"
#include "path_text.h"
#include "pkm_workspace/certificate/verify.h"
#include "pkm_workspace/common/byte_order.h"
#include "pkm_workspace/import/firmware.h"
#include "pkm_workspace/import/gcode_job.h"
#include "pkm_workspace/import/machine_file.h"
#include "pkm_workspace/import/tolerance_file.h"
#include "pkm_workspace/import/vertices_file.h"
#include "pkm_workspace/import/zone_file.h"
#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/paving/paving_file.h"
#include "pkm_workspace/urdf_io/joint_values.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
void fuzzUrdf(const std::string& bytes)
{
  isAccepted([&] {
    const UrdfMachine read = readUrdf(bytes);
    jointValues(read, read.machine.zero());
    std::string again;
    if (!isAccepted([&] { again = writeUrdf(read.machine); }))
      return;
    const Machine written = readUrdf(again).machine;
    demand(written.aspect() == read.machine.aspect(), "a machine reads back with its aspect");
    for (int i = 0; i < 3; ++i)
      demand(written.leg(i).joint == read.machine.leg(i).joint, "a machine reads back with its joints");
  });
}

/// What follows from a description is read as a machine.
void demandMachine(const MachineDescription& description)
{
  std::string urdf;
  if (!isAccepted([&] { urdf = writeUrdf(description); }))
    return;
  demand(isAccepted([&] { readUrdf(urdf); }), "what is written of a description is read");
}

void fuzzMachine(const std::string& bytes)
{
  isAccepted([&] { demandMachine(readMachineText(bytes, "machine.yaml")); });
}

/// The first byte chooses the format, or none.
void fuzzFirmware(const std::string& bytes)
{
  if (bytes.empty())
    return;
  const auto formats = firmwareFormats();
  const std::size_t choice = static_cast<unsigned char>(bytes[0]) % (formats.size() + 1);
  const std::string format = choice == formats.size() ? "" : formats[choice];
  const auto other = [&](const std::string& name) {
    return name.size() % 2 == 0 ? std::optional<std::string>() : std::optional<std::string>(bytes.substr(1));
  };
  isAccepted([&] { demandMachine(importFirmware({ "file", bytes.substr(1), other }, format).machine); });
}

bool isFinite(const Eigen::Vector3d& point)
{
  return point.allFinite();
}

void fuzzGcode(const std::string& bytes)
{
  GcodeJob job{ GcodeSetup() };
  std::istringstream stream(bytes);
  for (std::string line; std::getline(stream, line);)
    isAccepted([&] {
      if (const auto move = job.read(line))
        demand(isFinite(move->start) && isFinite(move->end), "moves have numbers");
    });
  job.summary();
}

void fuzzPath(const std::string& bytes)
{
  cli::PathText text;
  Problems problems;
  std::istringstream stream(bytes);
  for (std::string line; std::getline(stream, line);)
    text.read(line, problems);
  for (const std::string& problem : problems)
    demand(!problem.empty(), "a problem is a sentence");
  if (!problems.empty())
    return;
  isAccepted([&] {
    text.handOver([](const PathSegment& segment) {
      demand(isFinite(segment.point(0.0)) && isFinite(segment.point(1.0)), "segments have points");
    });
  });
}

/// Zones, tolerances and vertices: by the first byte.
void fuzzTables(const std::string& bytes)
{
  if (bytes.empty())
    return;
  const std::string text = bytes.substr(1);
  isAccepted([&] {
    switch (static_cast<unsigned char>(bytes[0]) % 3)
    {
      case 0:
        readZoneText(text, "zones.yaml");
        return;
      case 1:
        readToleranceText(text, "tolerances.yaml");
        return;
      default:
        for (const Eigen::Vector3d& vertex : verticesIn(text))
          demand(isFinite(vertex), "vertices have numbers");
    }
  });
}

void fuzzCertificate(const std::string& bytes)
{
  int told = 0;
  isAccepted([&] {
    const Verification found = verifyCertificate(bytes, [&](std::int64_t) { return ++told < 100; });
    demand(!found.verified.empty() || !found.refused.empty(), "a certificate is verified or refused");
    for (const std::string& sentence : found.verified)
      demand(!sentence.empty(), "what is verified is said");
  });
}

/// A file of this version, whole by its size and checksum, around the bytes; so they get to what reads boxes.
std::string pavingFile(const std::string& body)
{
  ByteWriter inner, file;
  inner.text(version());
  const std::string magic = "PKM paving\n";
  file.raw(magic.data(), magic.size());
  file.number(std::uint32_t(2));
  file.number(static_cast<std::uint64_t>(magic.size() + 4 + 8 + inner.bytes().size() + body.size() + 4));
  file.raw(inner.bytes().data(), inner.bytes().size());
  file.raw(body.data(), body.size());
  boost::crc_32_type crc;
  crc.process_bytes(file.bytes().data(), file.bytes().size());
  file.number(static_cast<std::uint32_t>(crc.checksum()));
  return file.bytes();
}

std::string contentOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

/// One paving of the Orthoglide. What is accepted is saved as it was, byte for byte, but for what premises have
/// besides.
void fuzzPaving(const std::string& bytes)
{
  static const std::string PATH =
      (std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid()))).string();
  std::ofstream(PATH, std::ios::binary) << pavingFile(bytes);
  PavingQuery query;
  query.box = Box{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  query.resolution = 0.5;
  isAccepted([&] {
    const auto loaded = loadPavings(PATH, orthoglide(), { query });
    savePavings(PATH, loaded);
    const std::string first = contentOf(PATH);
    savePavings(PATH, loadPavings(PATH, orthoglide(), { query }));
    demand(contentOf(PATH) == first, "a paving is saved as it was loaded");
  });
  std::filesystem::remove(PATH);
}
}  // namespace

const std::vector<FuzzTarget> FUZZ_TARGETS = {
  { "urdf", fuzzUrdf }, { "machine", fuzzMachine }, { "firmware", fuzzFirmware }, { "gcode", fuzzGcode },
  { "path", fuzzPath }, { "tables", fuzzTables },   { "paving", fuzzPaving },     { "certificate", fuzzCertificate },
};
}  // namespace test
}  // namespace pkm_workspace
