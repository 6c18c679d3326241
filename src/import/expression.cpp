// SPDX-License-Identifier: BSD-3-Clause
#include "expression.h"

#include <array>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "source_lines.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
using Value = std::optional<Decimal>;
constexpr int DEEPEST = 100;

/// Operators of two numbers, those that bind least first.
const std::vector<std::vector<std::string>> OPERATORS = { { "||" },       { "&&" },
                                                          { "==", "!=" }, { "<=", ">=", "<", ">" },
                                                          { "+", "-" },   { "*" } };

bool isWord(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

Value truth(bool value)
{
  return Decimal(value ? 1 : 0);
}

/// @pre both are decided
Value combined(const std::string& sign, const Decimal& a, const Decimal& b)
{
  if (sign == "+")
    return a + b;
  if (sign == "-")
    return a - b;
  if (sign == "*")
    return a * b;
  if (sign == "==" || sign == "!=")
    return truth((a == b) == (sign == "=="));
  if (sign == "<" || sign == ">=")
    return truth((a < b) == (sign == "<"));
  return truth((b < a) == (sign == ">"));
}

/// One side of && or || may decide the whole.
Value joinedTruth(bool either, const Value& a, const Value& b)
{
  for (const Value& side : { a, b })
    if (side && (*side == 0) != either)
      return truth(either);
  return a && b ? truth(!either) : std::nullopt;
}

/// What is malformed is thrown as std::invalid_argument.
class Parser
{
public:
  Parser(const std::string& text, const Names& names) : text_(text), names_(names) {}

  Value parse()
  {
    const Value value = level(0);
    skip();
    if (at_ != text_.size())
      throw std::invalid_argument(text_);
    return value;
  }

private:
  void skip()
  {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
      ++at_;
  }

  bool take(const std::string& sign)
  {
    skip();
    if (text_.compare(at_, sign.size(), sign) != 0)
      return false;
    at_ += sign.size();
    return true;
  }

  std::string takeSign(const std::vector<std::string>& signs)
  {
    for (const std::string& sign : signs)
      if (take(sign))
        return sign;
    return "";
  }

  Value level(std::size_t index)
  {
    if (index == OPERATORS.size())
      return unary();
    Value value = level(index + 1);
    for (std::string sign = takeSign(OPERATORS[index]); !sign.empty(); sign = takeSign(OPERATORS[index]))
    {
      const Value other = level(index + 1);
      if (index < 2)
        value = joinedTruth(index == 0, value, other);
      else
        value = value && other ? combined(sign, *value, *other) : std::nullopt;
    }
    return value;
  }

  Value unary()
  {
    if (++depth_ > DEEPEST)
      throw std::invalid_argument(text_);
    const std::string sign = takeSign({ "-", "+", "!" });
    Value value = sign.empty() ? primary() : unary();
    if (value && sign == "-")
      value = -*value;
    if (value && sign == "!")
      value = truth(*value == 0);
    --depth_;
    return value;
  }

  Value primary()
  {
    if (take("("))
    {
      const Value value = level(0);
      if (!take(")"))
        throw std::invalid_argument(text_);
      return value;
    }
    const std::string word = takeWord();
    if (word.empty())
      throw std::invalid_argument(text_);
    const bool is_number = std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '.';
    if (is_number)
      return number(word);
    if (word == "defined" && !take("("))
      return names_.call(word, takeWord());
    if (word != "defined" && !take("("))
      return names_.value(word);
    const std::size_t end = text_.find(')', at_);
    if (end == std::string::npos)
      throw std::invalid_argument(text_);
    const std::string arguments = text_.substr(at_, end - at_);
    at_ = end + 1;
    return names_.call(word, arguments);
  }

  std::string takeWord()
  {
    skip();
    const std::size_t begin = at_;
    const auto is_power = [&] {
      const bool signs = text_[at_] == '-' || text_[at_] == '+';
      return signs && at_ > begin && std::isdigit(static_cast<unsigned char>(text_[begin])) != 0 &&
             (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
    };
    while (at_ < text_.size() && (isWord(text_[at_]) || is_power()))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// A C literal may end with f. Hexadecimal and octal ones are not what a length is written in.
  static Value number(std::string word)
  {
    if (word.find('.') != std::string::npos && (word.back() == 'f' || word.back() == 'F'))
      word.pop_back();
    const Value value = Decimal::parse(word);
    const bool octal = word.size() > 1 && word[0] == '0' && std::isdigit(static_cast<unsigned char>(word[1])) != 0 &&
                       word.find('.') == std::string::npos;
    if (!value || octal)
      throw std::invalid_argument(word);
    return value;
  }

  const std::string& text_;
  const Names& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
};
}  // namespace

std::optional<Decimal> evaluateExpression(const std::string& text, const Names& names)
{
  try
  {
    return Parser(text, names).parse();
  }
  catch (const std::invalid_argument&)
  {
    return std::nullopt;
  }
  catch (const std::overflow_error&)
  {
    return std::nullopt;
  }
}
}  // namespace firmware
}  // namespace pkm_workspace
