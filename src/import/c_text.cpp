// SPDX-License-Identifier: BSD-3-Clause
#include "c_text.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
class CommentCutter
{
public:
  explicit CommentCutter(Reading& reading) : reading_(reading) {}

  SourceLine cut(const SourceLine& line)
  {
    SourceLine code = { line.place, "" };
    for (std::size_t at = 0; at < line.text.size();)
      step(line, at, code.text);
    return code;
  }

  void finish()
  {
    if (in_comment_)
      reading_.refuse(begin_, "the comment that begins here has no end; write */ where it ends");
  }

private:
  void step(const SourceLine& line, std::size_t& at, std::string& code)
  {
    const std::string pair = line.text.substr(at, 2);
    if (in_comment_)
    {
      in_comment_ = pair != "*/";
      at += in_comment_ ? 1 : 2;
    }
    else if (pair == "//")
      at = line.text.size();
    else if (pair == "/*")
    {
      in_comment_ = true;
      begin_ = line.place;
      code += ' ';
      at += 2;
    }
    else if (line.text[at] == '"')
      takeString(line, at, code);
    else
      code += line.text[at++];
  }

  void takeString(const SourceLine& line, std::size_t& at, std::string& code)
  {
    std::size_t end = at + 1;
    while (end < line.text.size() && line.text[end] != '"')
      end += line.text[end] == '\\' ? 2 : 1;
    if (end >= line.text.size())
      reading_.refuse(line.place, quoted(trimmed(line.text.substr(at))), " is a text without its closing quote");
    code += line.text.substr(at, end + 1 - at);
    at = end + 1;
  }

  Reading& reading_;
  bool in_comment_ = false;
  SourcePlace begin_;
};
}  // namespace

std::vector<SourceLine> codeLines(const std::vector<SourceLine>& lines, Reading& reading)
{
  CommentCutter cutter(reading);
  std::vector<SourceLine> code;
  bool goes_on = false;
  for (const SourceLine& line : lines)
  {
    SourceLine cut = cutter.cut(line);
    cut.text = trimmed(cut.text);
    const bool continues = !cut.text.empty() && cut.text.back() == '\\';
    if (continues)
      cut.text.pop_back();
    if (goes_on)
      code.back().text += " " + cut.text;
    else if (!cut.text.empty())
      code.push_back(cut);
    goes_on = continues && !code.empty();
  }
  cutter.finish();
  return code;
}
}  // namespace firmware
}  // namespace pkm_workspace
