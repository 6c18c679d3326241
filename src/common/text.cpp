// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/text.h"

#include <algorithm>
#include <cctype>

namespace pkm_workspace
{
namespace
{
bool beginsCharacter(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}
}  // namespace

std::string shortened(const std::string& text, std::size_t most)
{
  if (text.size() <= most)
    return text;
  std::size_t end = most / 2;
  std::size_t begin = text.size() - most / 2;
  while (end > 0 && !beginsCharacter(text[end]))
    --end;
  while (begin < text.size() && !beginsCharacter(text[begin]))
    ++begin;
  return text.substr(0, end) + " [" + std::to_string(begin - end) + " bytes left out] " + text.substr(begin);
}

bool hasEnding(const std::string& path, const std::string& ending)
{
  return path.size() > ending.size() &&
         std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

std::string sentence(std::string phrase)
{
  if (!phrase.empty())
    phrase.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(phrase.front())));
  return phrase + ".";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator)
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : separator) + words[i];
  return text;
}

std::vector<std::string> linesOf(const std::string& text)
{
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size(); begin += lines.back().size() + 1)
    lines.push_back(text.substr(begin, std::min(text.size(), text.find('\n', begin)) - begin));
  return lines;
}
}  // namespace pkm_workspace
