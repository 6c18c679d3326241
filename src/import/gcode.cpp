// SPDX-License-Identifier: BSD-3-Clause
#include "gcode.h"

#include <algorithm>
#include <cctype>

namespace pkm_workspace
{
namespace firmware
{
namespace
{
bool isLetter(char c)
{
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool isDigit(const std::string& text, std::size_t at)
{
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

char upper(char c)
{
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

/// A line, without what terminals and Marlin put before it and without its comment.
std::string commandsIn(std::string text, bool& is_report)
{
  for (const char* const before : { "Recv:", "RECV:", "echo:" })
  {
    const std::size_t at = text.find(before);
    if (at == std::string::npos)
      continue;
    is_report = true;
    text = text.substr(at + 5);
  }
  bool in_quotes = false;
  for (std::size_t k = 0; k < text.size(); ++k)
  {
    in_quotes = in_quotes != (text[k] == '"');
    if (!in_quotes && (text[k] == ';' || text[k] == '*'))
      return text.substr(0, k);  // a comment, or a check sum
  }
  return text;
}

class LineOfGcode
{
public:
  LineOfGcode(const SourcePlace& place, const std::string& text) : place_(place), text_(text) {}

  /// Nothing of a line that begins with no command.
  std::vector<GcodeCommand> commands()
  {
    std::vector<GcodeCommand> found;
    skip();
    if (at_ < text_.size() && upper(text_[at_]) == 'N' && isDigit(text_, at_ + 1))
      takeWord();  // the number of the line
    skip();
    while (at_ < text_.size())
    {
      const Entry word = takeWord();
      const bool is_command = (word.key == "G" || word.key == "M") && isDigit(word.text, 0);
      const bool is_tool = word.key == "T" && found.empty() && isDigit(word.text, 0);
      if (is_command || is_tool)
        found.push_back({ place_, word.key + word.text, {}, false, false });
      else if (found.empty())
        return {};
      else
        found.back().words.push_back(word);
      skip();
    }
    return found;
  }

private:
  void skip()
  {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
      ++at_;
  }

  /// A letter and the value that follows it, at once or after a blank.
  Entry takeWord()
  {
    if (!isLetter(text_[at_]))
      return { place_, takeUntilBlank(), "" };
    Entry word = { place_, std::string(1, upper(text_[at_++])), "" };
    const std::size_t after_letter = at_;
    skip();
    const bool has_value = at_ < text_.size() && !isLetter(text_[at_]);
    at_ = has_value ? at_ : after_letter;
    if (has_value && (text_[at_] == '"' || text_[at_] == '{'))
      word.text = takeUntil(text_[at_] == '"' ? '"' : '}');
    else if (has_value)
      word.text = takeNumber();
    return word;
  }

  std::string takeUntil(char closing)
  {
    const std::size_t begin = at_;
    at_ = std::min(text_.find(closing, at_ + 1), text_.size() - 1) + 1;
    return text_.substr(begin, at_ - begin);
  }

  std::string takeUntilBlank()
  {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t", at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  std::string takeNumber()
  {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != '\t' && !isLetter(text_[at_]))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  const SourcePlace& place_;
  const std::string& text_;
  std::size_t at_ = 0;
};

bool isCondition(const std::string& text)
{
  const std::string word = trimmed(text).substr(0, trimmed(text).find_first_of(" ("));
  return word == "if" || word == "elif" || word == "else" || word == "while";
}

std::size_t indentOf(const std::string& text)
{
  return std::min(text.find_first_not_of(" \t"), text.size());
}
}  // namespace

std::vector<GcodeCommand> readGcode(const std::vector<SourceLine>& lines)
{
  std::vector<GcodeCommand> all;
  bool is_conditional = false;
  std::size_t indent = 0;  // of the outermost condition
  for (const SourceLine& line : lines)
  {
    bool is_report = false;
    const std::string text = commandsIn(line.text, is_report);
    if (trimmed(text).empty())
      continue;
    is_conditional = is_conditional && indentOf(text) > indent;
    if (!is_conditional && isCondition(text))
    {
      is_conditional = true;
      indent = indentOf(text);
    }
    for (GcodeCommand command : LineOfGcode(line.place, text).commands())
    {
      command.is_conditional = is_conditional;
      command.is_report = is_report;
      all.push_back(command);
    }
  }
  return all;
}

void addCommands(const std::vector<GcodeCommand>& commands, const std::vector<std::string>& codes, Reading& reading)
{
  for (const GcodeCommand& command : commands)
  {
    const bool is_used = std::find(codes.begin(), codes.end(), command.code) != codes.end();
    if (!is_used)
      reading.add({ command.place, command.code, "" });
    else if (command.is_conditional)
      reading.refuse(command.place, command.code,
                     " depends on a condition that this reader does not decide; give a "
                     "file in which it stands alone");
    else if (command.code == "G20")
      reading.refuse(command.place,
                     "G20 sets inches, expected millimetres; set G21 and let the values be reported anew");
    else
      for (const Entry& word : command.words)
        reading.add({ word.place, command.code + " " + word.key, word.text });
  }
}

std::string otherCommand(const Entry& entry)
{
  return entry.key.find(' ') == std::string::npos ? entry.key : "";
}
}  // namespace firmware
}  // namespace pkm_workspace
