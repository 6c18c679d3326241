// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/tolerance_file.h"

#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
#include "yaml_reader.h"

namespace pkm_workspace
{
namespace
{
/// [bytes]
constexpr std::size_t LARGEST_TOLERANCE_FILE = 64 * 1024;

class ToleranceFileReader : private YamlReader
{
public:
  explicit ToleranceFileReader(const std::string& name) : YamlReader(name, "see docs/tolerances.md") {}

  GivenTolerances read(const std::string& text)
  {
    MapEntries entries;
    for (const ToleranceKind& kind : TOLERANCE_KINDS)
      entries.push_back({ kind.name, [this, &kind](const YAML::Node& node) { readKind(kind, node); } });
    readMap(load(text), "the file", entries);
    throwProblems(problems());
    return tolerances_;
  }

private:
  void readKind(const ToleranceKind& kind, const YAML::Node& node)
  {
    const std::size_t before = problems().size();
    const std::vector<double> numbers = numbersIn(node, kind.name);
    if (problems().size() > before)
      return;
    try
    {
      tolerances_.set(kind, numbers);
    }
    catch (const std::invalid_argument& reason)
    {
      refuse(node, reason.what());
    }
  }

  GivenTolerances tolerances_;
};
}  // namespace

GivenTolerances readToleranceText(const std::string& text, const std::string& name)
{
  return ToleranceFileReader(name).read(text);
}

GivenTolerances readToleranceFile(const std::string& path)
{
  return readToleranceText(readWholeFile(path, LARGEST_TOLERANCE_FILE), path);
}
}  // namespace pkm_workspace
