// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_reader.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/common/utf8.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
std::string namesOf(const MapEntries& entries)
{
  std::vector<std::string> names;
  for (const MapEntry& entry : entries)
    names.push_back(entry.name);
  return joined(names, ", ");
}
/// Texts of a value, or of a list of them.
std::vector<std::string> scalarsOf(const YAML::Node& node)
{
  std::vector<std::string> texts;
  if (node.IsSequence())
    for (const auto& value : node)
      texts.push_back(value.IsScalar() ? value.Scalar() : "");
  else if (node.IsScalar())
    texts.push_back(node.Scalar());
  return texts;
}
}  // namespace

YAML::Node YamlReader::load(const std::string& text) const
{
  try
  {
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw std::invalid_argument(name_ + ":" + std::to_string(error.mark.line + 1) + ": not valid YAML: " + error.msg);
  }
}

std::string YamlReader::placeOf(const YAML::Node& node) const
{
  return name_ + ":" + std::to_string(std::max(node.Mark().line, 0) + 1);
}

std::string YamlReader::textOf(const YAML::Node& node, const std::string& key)
{
  if (node.IsScalar() && !node.Scalar().empty())
    return printable({ node.Scalar() }, node, key).front();
  refuse(node, key + " needs one value");
  return "";
}

/// The same texts; refused where somebody who reads them could not.
std::vector<std::string> YamlReader::printable(std::vector<std::string> texts, const YAML::Node& node,
                                               const std::string& key)
{
  for (const std::string& text : texts)
    if (const auto byte = unprintableByte(text))
      refuse(node, key + " holds a character that is not printable UTF-8 (byte " + std::to_string(*byte) + ")");
  return texts;
}

void YamlReader::readMap(const YAML::Node& map, const std::string& what, const MapEntries& entries)
{
  if (!map.IsMap())
    return refuse(map, what + " must be a list of keys with their values, as \"length: 0.269\"; " + remedy_);
  std::set<std::string> seen;
  for (const auto& pair : map)
  {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : "";
    const auto known = [&key](const MapEntry& entry) { return entry.name == key; };
    const auto entry = std::find_if(entries.begin(), entries.end(), known);
    if (entry == entries.end())
      refuse(pair.first, "unknown key '" + shortened(key, 60) + "' in " + what + "; its keys are: " + namesOf(entries));
    else if (!seen.insert(key).second)
      refuse(pair.first, "'" + key + "' stands a second time in " + what);
    else
      entry->read(pair.second);
  }
}

std::vector<std::string> YamlReader::scalarsIn(const YAML::Node& node, const std::string& key)
{
  const auto is_nested = [](const YAML::Node& value) { return !value.IsScalar() && !value.IsNull(); };
  if (node.IsMap())
    refuse(node, key + " must be one value or a list of values, as [1, 2, 3], and it is a map");
  else if (node.IsSequence() && std::any_of(node.begin(), node.end(), is_nested))
    refuse(node, key + " must be one value or a list of values, as [1, 2, 3], and it has a list or a map in its list");
  else
    return printable(scalarsOf(node), node, key);
  return {};
}

std::vector<double> YamlReader::numbersIn(const YAML::Node& node, const std::string& key)
{
  std::vector<double> numbers;
  for (const std::string& text : scalarsIn(node, key))
    if (const auto number = parseNumber(text == ".inf" ? "inf" : text))  // as YAML writes it
      numbers.push_back(*number);
    else
      refuse(node, key + " = '" + shortened(text, 60) + "' is not a number");
  return numbers;
}
}  // namespace pkm_workspace
