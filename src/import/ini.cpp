// SPDX-License-Identifier: BSD-3-Clause
#include "ini.h"

#include <algorithm>

namespace pkm_workspace
{
namespace firmware
{
namespace
{
bool isBlank(char c)
{
  return c == ' ' || c == '\t';
}

/// A semicolon begins a comment at the beginning of a line or after a blank.
std::string withoutComment(const std::string& text, bool hash_begins_comment)
{
  for (std::size_t k = 0; k < text.size(); ++k)
  {
    const bool after_blank = k == 0 || isBlank(text[k - 1]);
    if ((text[k] == '#' && (hash_begins_comment || after_blank)) || (text[k] == ';' && after_blank))
      return text.substr(0, k);
  }
  return text;
}

class IniReader
{
public:
  IniReader(const IniDialect& dialect, Reading& reading) : dialect_(dialect), reading_(reading) {}

  void read(const SourceLine& line)
  {
    const std::string text = withoutComment(line.text, dialect_.hash_begins_comment);
    const std::string content = trimmed(text);
    if (content.empty())
      return;
    if (dialect_.indented_lines_continue && isBlank(text[0]) && !entries_.empty() && continues_)
      entries_.back().text += (entries_.back().text.empty() ? "" : " ") + content;
    else if (content[0] == '[')
      readSection(content, line.place);
    else
      readEntry(content, line.place);
  }

  std::vector<Entry> entries() const { return entries_; }

private:
  void readSection(const std::string& content, const SourcePlace& place)
  {
    continues_ = false;
    section_ = sectionOf(content);
    if (!section_.empty())
      return;
    section_ = "[";  // of no name: what follows is told of no more
    reading_.refuse(place, quoted(content), " begins a section that has no name or no end; expected [name]");
  }

  void readEntry(const std::string& content, const SourcePlace& place)
  {
    const std::size_t separator = content.find_first_of(dialect_.separators);
    const std::string key = trimmed(content.substr(0, separator));
    continues_ = true;
    if (separator == std::string::npos || key.empty())
      reading_.refuse(place, quoted(content), " is neither a [section] nor a key with a value; expected key ",
                      dialect_.separators[0], " value");
    else if (section_.empty())
      reading_.refuse(place, quoted(key), " stands before the first [section]; is the beginning of the file missing?");
    else
      entries_.push_back({ place, section_ + " " + (dialect_.lower_case_keys ? lowered(key) : key),
                           trimmed(content.substr(separator + 1)) });
  }

  const IniDialect& dialect_;
  Reading& reading_;
  std::string section_;
  bool continues_ = false;
  std::vector<Entry> entries_;
};
}  // namespace

std::string sectionOf(const std::string& line)
{
  const std::string content = trimmed(line);
  const std::size_t end = content.find(']');
  return startsWith(content, "[") && end != std::string::npos && trimmed(content.substr(end + 1)).empty()
             ? trimmed(content.substr(1, end - 1))
             : "";
}

std::vector<Entry> readIni(const std::vector<SourceLine>& lines, const IniDialect& dialect, Reading& reading)
{
  IniReader reader(dialect, reading);
  for (const SourceLine& line : lines)
    reader.read(line);
  return reader.entries();
}
}  // namespace firmware
}  // namespace pkm_workspace
