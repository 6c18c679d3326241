// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>
#include <vector>

#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
/// What may stand in one map of a file: a key, and who reads its value.
struct MapEntry
{
  std::string name;
  std::function<void(const YAML::Node&)> read;
};
using MapEntries = std::vector<MapEntry>;

/// Reads a file in YAML and collects what is wrong with it, each with file and line.
class YamlReader
{
public:
  /// @param name of the file @param remedy where to see what such a file looks like
  YamlReader(const std::string& name, const std::string& remedy) : name_(name), remedy_(remedy) {}

  const Problems& problems() const { return problems_; }

  /// @throws std::invalid_argument where it is not YAML
  YAML::Node load(const std::string& text) const;
  std::string placeOf(const YAML::Node& node) const;
  void refuse(const YAML::Node& node, const std::string& what) { problems_.push_back(placeOf(node) + ": " + what); }
  std::string textOf(const YAML::Node& node, const std::string& key);
  /// One value, or those of a list, as texts. None where what stands there is refused.
  std::vector<std::string> scalarsIn(const YAML::Node& node, const std::string& key);
  /// The same as numbers.
  std::vector<double> numbersIn(const YAML::Node& node, const std::string& key);
  /// Keys that are unknown, or stand a second time, are refused. @param what the map is
  void readMap(const YAML::Node& map, const std::string& what, const MapEntries& entries);

private:
  std::vector<std::string> printable(std::vector<std::string> texts, const YAML::Node& node, const std::string& key);

  std::string name_;
  std::string remedy_;
  Problems problems_;
};
}  // namespace pkm_workspace
