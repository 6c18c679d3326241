// SPDX-License-Identifier: BSD-3-Clause
#include "hal.h"

#include <sstream>

namespace pkm_workspace
{
namespace firmware
{
void HalPins::read(const std::vector<SourceLine>& lines)
{
  std::vector<std::string> words;
  SourcePlace place;
  for (const SourceLine& line : lines)
  {
    place = words.empty() ? line.place : place;
    std::string text = trimmed(line.text.substr(0, line.text.find('#')));
    const bool goes_on = !text.empty() && text.back() == '\\';
    if (goes_on)
      text.pop_back();
    std::istringstream stream(text);
    for (std::string word; stream >> word;)
      words.push_back(word);
    if (goes_on)
      continue;
    readCommand(words, place);
    words.clear();
  }
  readCommand(words, place);
}

void HalPins::readCommand(const std::vector<std::string>& words, const SourcePlace& place)
{
  if (words.size() < 2)
    return;
  std::string value;
  for (std::size_t k = 2; k < words.size(); ++k)
    value += (value.empty() ? "" : " ") + words[k];
  if (words[0] == "setp" && startsWith(words[1], prefix_))
    set_.push_back({ place, words[1], value });
  if (words[0] == "sets")
    signals_.push_back({ place, words[1], value });
  if (words[0] == "net")
    for (std::size_t k = 2; k < words.size(); ++k)
      if (startsWith(words[k], prefix_))
        driven_[words[k]] = words[1];
}

std::vector<Entry> HalPins::values() const
{
  std::vector<Entry> values = set_;
  for (const auto& [pin, signal] : driven_)
    for (const Entry& entry : signals_)
      if (entry.key == signal)
        values.push_back({ entry.place, pin, entry.text });
  return values;
}
}  // namespace firmware
}  // namespace pkm_workspace
