// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
namespace test
{
/// Test vectors for interval arithmetic in the format of ITF1788 (Nehmeier, Kiesner; Heimlich): test cases in braces,
/// whose statements read `add [1.0, 2.0] [3.0, infinity] = [4.0, infinity];`. Decorations are read and dropped.
struct ItlLiteral
{
  enum Kind
  {
    INTERVAL,
    NUMBER,
    WORD  ///< true, false, NaN, [nai], names of states, texts in quotes
  };
  Kind kind = WORD;
  Interval interval;
  double number = 0.0;
  std::string word;
};

struct ItlStatement
{
  std::string operation;
  std::vector<ItlLiteral> operands;
  std::vector<ItlLiteral> tightest;  ///< after `=`
  std::vector<ItlLiteral> accurate;  ///< after `<=`: what a result may be at most
  int line = 0;
};

/// Reads one text; what is no such statement is refused with its line.
class ItlReader
{
public:
  explicit ItlReader(std::string text) : text_(std::move(text)) {}

  std::vector<ItlStatement> statements()
  {
    std::vector<ItlStatement> all;
    while (skipBlanks(), at_ < text_.size())
    {
      if (word() != "testcase")
        refuse("expected 'testcase'");
      for (skipBlanks(); !taken("{"); ++at_)
        if (at_ >= text_.size())
          refuse("expected '{'");
      while (!taken("}"))
        all.push_back(statement());
    }
    return all;
  }

private:
  [[noreturn]] void refuse(const std::string& reason) const
  {
    throw std::invalid_argument("line " + std::to_string(line()) + ": " + reason);
  }

  int line() const
  {
    for (; counted_ < at_ && counted_ < text_.size(); ++counted_)
      line_ += text_[counted_] == '\n';
    return line_;
  }

  bool startsWith(const std::string& token) const { return text_.compare(at_, token.size(), token) == 0; }

  void skipBlanks()
  {
    while (at_ < text_.size())
      if (std::isspace(static_cast<unsigned char>(text_[at_])))
        ++at_;
      else if (startsWith("//") || startsWith("#"))
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (startsWith("/*"))
        skipBeyond("*/");
      else
        return;
  }

  void skipBeyond(const std::string& end)
  {
    const std::size_t found = text_.find(end, at_ + 1);
    if (found == std::string::npos)
      refuse("expected '" + end + "'");
    at_ = found + end.size();
  }

  bool taken(const std::string& token)
  {
    skipBlanks();
    if (!startsWith(token))
      return false;
    at_ += token.size();
    return true;
  }

  std::string word()
  {
    skipBlanks();
    const std::size_t first = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' ||
                                  (text_[at_] == '-' && at_ > first)))
      ++at_;
    if (at_ == first)
      refuse("expected a name");
    return text_.substr(first, at_ - first);
  }

  double number()
  {
    skipBlanks();
    const char* const begin = text_.c_str() + at_;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin)
      refuse("expected a number");
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  ItlLiteral interval()
  {
    ItlLiteral literal;
    literal.kind = ItlLiteral::INTERVAL;
    if (taken("empty"))
      literal.interval = Interval::empty();
    else if (taken("entire"))
      literal.interval = Interval::entire();
    else if (taken("nai"))
      literal.kind = ItlLiteral::WORD, literal.word = "nai";
    else
      literal.interval = bounds();
    if (!taken("]"))
      refuse("expected ']'");
    if (startsWith("_"))
      word();
    return literal;
  }

  Interval bounds()
  {
    const double lower = number();
    if (!taken(","))
      refuse("expected ','");
    const double upper = number();
    if (!(lower <= upper))
      refuse("an interval needs lower <= upper");
    return { lower, upper };
  }

  ItlLiteral literal()
  {
    if (taken("["))
      return interval();
    ItlLiteral literal;
    if (startsWith("\""))
    {
      const std::size_t first = at_;
      skipBeyond("\"");
      literal.word = text_.substr(first, at_ - first);
      return literal;
    }
    const char next = at_ < text_.size() ? text_[at_] : ';';
    const bool is_number =
        std::isdigit(static_cast<unsigned char>(next)) || next == '-' || next == '+' || startsWith("infinity");
    if (is_number)
      literal.kind = ItlLiteral::NUMBER, literal.number = number();
    else
      literal.word = word();
    return literal;
  }

  std::vector<ItlLiteral> literals()
  {
    std::vector<ItlLiteral> all;
    for (skipBlanks(); !startsWith(";") && !startsWith("=") && !startsWith("<="); skipBlanks())
      all.push_back(literal());
    return all;
  }

  ItlStatement statement()
  {
    ItlStatement statement;
    statement.operation = word();
    statement.line = line();
    statement.operands = literals();
    if (taken("="))
      statement.tightest = literals();
    if (taken("<="))
      statement.accurate = literals();
    if (!taken(";"))
      refuse("expected ';'");
    if (statement.tightest.empty() && statement.accurate.empty())
      refuse("expected a result");
    return statement;
  }

  std::string text_;
  std::size_t at_ = 0;
  mutable std::size_t counted_ = 0;
  mutable int line_ = 1;
};
}  // namespace test
}  // namespace pkm_workspace
