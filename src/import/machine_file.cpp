// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_file.h"

#include <stdexcept>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/import/machine_draft.h"
#include "yaml_reader.h"

namespace pkm_workspace
{
namespace
{
/// Nobody writes longer ones by hand [bytes].
constexpr std::size_t LARGEST_MACHINE_FILE = 256 * 1024;

class MachineFile : private YamlReader
{
public:
  explicit MachineFile(const std::string& name) : YamlReader(name, "see pkm urdf --template") {}

  MachineDescription read(const std::string& text)
  {
    const YAML::Node root = load(text);
    MapEntries entries = machineEntries();
    entries.push_back({ "name", [this](const YAML::Node& node) { draft_.name = textOf(node, "name"); } });
    entries.push_back({ "unit", [this](const YAML::Node& node) { readUnit(node); } });
    entries.push_back({ "all_legs", [this](const YAML::Node& node) { readAllLegs(node); } });
    entries.push_back({ "legs", [this](const YAML::Node& node) { readLegs(node); } });
    readMap(root, "the file", entries);
    throwProblems(problems());
    return draft_.finished();
  }

private:
  void readUnit(const YAML::Node& node)
  {
    const std::string unit = textOf(node, "unit");
    if (unit == "m" || unit == "mm")
      draft_.unit = unit;
    else
      refuse(node, "unit = '" + shortened(unit, 60) + "', expected m or mm");
  }

  /// The values of a key, as many as it takes; nothing where there are not so many.
  MachineDraft::Texts valuesOf(const DraftKey& key, const YAML::Node& node)
  {
    const std::size_t before = problems().size();
    const MachineDraft::Texts texts = scalarsIn(node, key.name);
    if (texts.size() == key.size || problems().size() > before)
      return texts;
    refuse(node, std::string(key.name) + " needs " +
                     (key.size == 1 ? "one value" : std::to_string(key.size) + " values in brackets") + " (" +
                     key.values + "), got " + std::to_string(texts.size()));
    return {};
  }

  void readMachine(const DraftKey& key, const YAML::Node& node)
  {
    const MachineDraft::Texts texts = valuesOf(key, node);
    if (!texts.empty())
      draft_.setMachine(key, texts, placeOf(node));
  }

  void readLeg(const DraftKey& key, const std::vector<std::size_t>& legs, const YAML::Node& node)
  {
    const MachineDraft::Texts texts = valuesOf(key, node);
    for (const std::size_t leg : legs)
      if (!texts.empty())
        draft_.setLeg(leg, key, texts, placeOf(node), legs.size() > 1);
  }

  MapEntries machineEntries()
  {
    MapEntries entries;
    for (const DraftKey& key : machineKeys())
    {
      const auto read = [this, &key](const YAML::Node& node) { readMachine(key, node); };
      entries.push_back({ key.name, read });
    }
    return entries;
  }

  /// @param legs that the map is about
  MapEntries legEntries(const std::vector<std::size_t>& legs)
  {
    MapEntries entries;
    for (const DraftKey& key : legKeys())
    {
      const auto read = [this, &key, legs](const YAML::Node& node) { readLeg(key, legs, node); };
      if (legs.size() == 1 || key.kind != DraftKey::Kind::NAME)
        entries.push_back({ key.name, read });
    }
    return entries;
  }

  void readAllLegs(const YAML::Node& node)
  {
    if (legs_read_)
      refuse(node, "all_legs must stand before legs, which change single values of it");
    readMap(node, "all_legs", legEntries({ 0, 1, 2 }));
  }

  void readLegs(const YAML::Node& node)
  {
    legs_read_ = true;
    if (!node.IsSequence() || node.size() != 3)
      return refuse(node, "legs must be a list of three, each beginning with a hyphen; got " +
                              (node.IsSequence() ? std::to_string(node.size()) : "no list"));
    for (std::size_t i = 0; i < 3; ++i)
      readMap(node[i], "leg " + std::to_string(i + 1), legEntries({ i }));
  }

  MachineDraft draft_;
  bool legs_read_ = false;
};
}  // namespace

MachineDescription readMachineText(const std::string& text, const std::string& name)
{
  return MachineFile(name).read(text);
}

MachineDescription readMachineFile(const std::string& path)
{
  return readMachineText(readWholeFile(path, LARGEST_MACHINE_FILE), path);
}
}  // namespace pkm_workspace
