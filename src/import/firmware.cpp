// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/firmware.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "formats.h"
#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/whole_file.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
constexpr std::size_t LARGEST_FIRMWARE = std::size_t(16) << 20;  ///< [bytes]

constexpr Format FORMATS[] = {
  { "klipper", "Klipper's printer.cfg", isKlipper, readAs<LinearDelta, readKlipper> },
  { "marlin", "Marlin's Configuration.h", isMarlin, readAs<LinearDelta, readMarlin> },
  { "marlin-report", "Marlin's answer to M503 or M665", isMarlinReport, readAs<LinearDelta, readMarlinReport> },
  { "reprapfirmware", "RepRapFirmware's config.g or config-override.g", isRepRapFirmware,
    readAs<LinearDelta, readRepRapFirmware> },
  { "linuxcnc", "the INI file of LinuxCNC's lineardeltakins or rotarydeltakins", isLinuxCnc, readLinuxCnc },
  { "grblhal", "grblHAL's answer to $$, of a rotary delta", isGrblHal, readAs<RotaryDelta, readGrblHal> },
};

std::string titles()
{
  std::vector<std::string> words;
  for (const Format& format : FORMATS)
    words.push_back(std::string(format.name) + " (" + format.title + ")");
  return joined(words, ", ");
}

const Format& formatNamed(const std::string& name)
{
  const auto* const found =
      std::find_if(std::begin(FORMATS), std::end(FORMATS), [&](const Format& format) { return format.name == name; });
  if (found == std::end(FORMATS))
    throw std::invalid_argument("the format " + quoted(name) + " is not known; allowed: " + titles());
  return *found;
}

const Format& recognised(const Source& source)
{
  std::vector<std::string> names;
  for (const Format& format : FORMATS)
    if (format.recognises(source.lines))
      names.push_back(format.name);
  if (names.size() == 1)
    return formatNamed(names[0]);
  if (names.empty())
    throw std::invalid_argument(source.text.name + ": the text looks like none of the formats that are read: " +
                                titles() + "; name the one that it is");
  throw std::invalid_argument(source.text.name + ": the text may be each of " + joined(names, ", ") +
                              "; name the one that it is");
}

/// The text of a file in the same folder, or below it.
std::optional<std::string> besides(const std::string& path, const std::string& name)
{
  const std::filesystem::path file = std::filesystem::path(path).parent_path() / name;
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    return std::nullopt;
  return readWholeFile(file.string(), LARGEST_FIRMWARE);
}
}  // namespace

std::vector<SourceLine> otherLines(const Source& source, const Entry& naming, const std::string& name, Reading& reading)
{
  const std::optional<std::string> content = source.text.other ? source.text.other(name) : std::nullopt;
  if (content)
    return sourceLines(name, *content, reading.problems);
  reading.left_aside.push_back(
      { naming.place, naming.key,
        "the file " + quoted(name) + " was not read: it is not in the folder of " + source.text.name });
  return {};
}
}  // namespace firmware

std::vector<std::string> firmwareFormats()
{
  std::vector<std::string> names;
  for (const firmware::Format& format : firmware::FORMATS)
    names.emplace_back(format.name);
  return names;
}

FirmwareMachine importFirmware(const FirmwareText& text, const std::string& format)
{
  firmware::Reading reading;
  reading.file = text.name;
  const firmware::Source source = { text, firmware::sourceLines(text.name, text.content, reading.problems) };
  throwProblems(reading.problems);
  const firmware::Format& used = format.empty() ? firmware::recognised(source) : firmware::formatNamed(format);
  const MachineDescription machine = used.read(source, reading, std::string(used.name) + "_delta");
  return { used.name, machine, reading.taken, reading.left_aside };
}

FirmwareMachine importFirmwareFile(const std::string& path, const std::string& format)
{
  const std::string content = readWholeFile(path, firmware::LARGEST_FIRMWARE);
  return importFirmware({ path, content, [&](const std::string& name) { return firmware::besides(path, name); } },
                        format);
}
}  // namespace pkm_workspace
