// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/zone_file.h"

#include <stdexcept>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/machine/zone_keys.h"
#include "yaml_reader.h"

namespace pkm_workspace
{
namespace
{
/// [bytes]
constexpr std::size_t LARGEST_ZONE_FILE = 256 * 1024;

class ZoneFileReader : private YamlReader
{
public:
  explicit ZoneFileReader(const std::string& name) : YamlReader(name, "see docs/conditions.md") {}

  ZoneFile read(const std::string& text)
  {
    MapEntries entries = { { "tool_radius", [this](const YAML::Node& node) { readToolRadius(node); } } };
    for (const Zone::Use use : { Zone::Use::KEEP_IN, Zone::Use::KEEP_OUT })
      entries.push_back(
          { ZONE_USES[static_cast<std::size_t>(use)], [this, use](const YAML::Node& node) { readZones(use, node); } });
    readMap(load(text), "the file", entries);
    throwProblems(problems());
    return file_;
  }

private:
  void readToolRadius(const YAML::Node& node)
  {
    const std::vector<double> numbers = numbersIn(node, "tool_radius");
    if (numbers.size() == 1)
      file_.tool_radius = numbers[0];
    else if (problems().empty())
      refuse(node, "tool_radius needs one number [m]");
  }

  void readZones(Zone::Use use, const YAML::Node& node)
  {
    const std::string list = ZONE_USES[static_cast<std::size_t>(use)];
    if (!node.IsSequence())
      return refuse(node, list + " must be a list of zones, each beginning with a hyphen");
    for (const auto& item : node)
      readZone(use, list, item);
  }

  void readZone(Zone::Use use, const std::string& list, const YAML::Node& item)
  {
    const std::size_t before = problems().size();
    std::string kind, name;
    ZoneNumbers numbers;
    MapEntries entries = { { "kind", [&](const YAML::Node& node) { kind = textOf(node, "kind"); } },
                           { "name", [&](const YAML::Node& node) { name = textOf(node, "name"); } } };
    for (const ZoneKey& key : zoneKeys())
      entries.push_back(
          { key.name, [&, key](const YAML::Node& node) { numbers[key.name] = numbersIn(node, key.name); } });
    readMap(item, "a zone of " + list, entries);
    if (problems().size() > before)
      return;
    try
    {
      file_.zones.push_back(pkm_workspace::readZone(use, kind, name, numbers));
    }
    catch (const std::invalid_argument& reason)
    {
      refuse(item, reason.what());
    }
  }

  ZoneFile file_;
};
}  // namespace

ZoneFile readZoneText(const std::string& text, const std::string& name)
{
  return ZoneFileReader(name).read(text);
}

ZoneFile readZoneFile(const std::string& path)
{
  return readZoneText(readWholeFile(path, LARGEST_ZONE_FILE), path);
}
}  // namespace pkm_workspace
