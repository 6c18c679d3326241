// SPDX-License-Identifier: BSD-3-Clause
#include "source_lines.h"

#include <algorithm>

#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
std::string toText(const SourcePlace& place)
{
  return place.line == 0 ? place.file : place.file + ":" + std::to_string(place.line);
}

namespace firmware
{
namespace
{
constexpr std::size_t MOST_LINES = 200000;
constexpr std::size_t LONGEST = 10000;

/// Bytes of the character of UTF-8 that begins there; 0 where none does.
std::size_t characterSize(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t k) { return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80)
    return 1;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((byte(k) & 0xC0U) != 0x80)
      return 0;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool no_character = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
  return overlong || no_character ? 0 : size;
}

std::string validUtf8(const std::string& text)
{
  std::string valid;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t size = characterSize(text, at);
    valid += size == 0 ? "\xEF\xBF\xBD" : text.substr(at, size);
    at += std::max<std::size_t>(1, size);
  }
  return valid;
}
}  // namespace

std::vector<SourceLine> sourceLines(const std::string& file, const std::string& content, Problems& problems)
{
  std::vector<SourceLine> lines;
  if (startsWith(content, "\xFF\xFE") || startsWith(content, "\xFE\xFF") || content.find('\0') != std::string::npos)
  {
    complain(problems, file, ": this is not UTF-8 text: it is UTF-16, or has zero bytes; save it as UTF-8");
    return lines;
  }
  for (std::size_t begin = startsWith(content, "\xEF\xBB\xBF") ? 3 : 0; begin < content.size();)
  {
    const std::size_t end = std::min(content.find_first_of("\r\n", begin), content.size());
    lines.push_back({ { file, lines.size() + 1 }, validUtf8(content.substr(begin, end - begin)) });
    if (lines.size() > MOST_LINES || end - begin > LONGEST)
    {
      complain(problems, toText(lines.back().place), ": no more than ", MOST_LINES, " lines of ", LONGEST,
               " bytes are read; is this the configuration of a firmware?");
      return {};
    }
    begin = end + (content.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

std::string trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\v\f");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t\v\f") + 1 - begin);
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

bool startsWith(const std::string& text, const std::string& beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

std::string quoted(const std::string& text)
{
  return "'" + shortened(text, 80) + "'";
}
}  // namespace firmware
}  // namespace pkm_workspace
