// SPDX-License-Identifier: BSD-3-Clause
#include "includes.h"

namespace pkm_workspace
{
namespace firmware
{
std::vector<SourceLine> Includes::expand(const std::vector<SourceLine>& lines)
{
  std::vector<SourceLine> all;
  for (const SourceLine& line : lines)
  {
    const std::string name = name_(line.text);
    if (name.empty())
      all.push_back(line);
    else
      include(line, name, all);
  }
  return all;
}

void Includes::include(const SourceLine& line, const std::string& name, std::vector<SourceLine>& all)
{
  if (!names_.insert(name).second)
    return reading_.refuse(line.place, quoted(trimmed(line.text)),
                           " includes that file a second time; take the line out");
  const Entry naming = { line.place, "include " + name, "" };
  const std::vector<SourceLine> included = expand(otherLines(source_, naming, name, reading_));
  all.insert(all.end(), included.begin(), included.end());
}
}  // namespace firmware
}  // namespace pkm_workspace
