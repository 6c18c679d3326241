// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_block.h"

#include <algorithm>
#include <stdexcept>

namespace pkm_workspace
{
namespace gcode
{
namespace
{
struct CodeGroup
{
  int code;
  Group group;
};
constexpr CodeGroup G_CODES[] = {
  { 0, Group::MOTION },         { 10, Group::MOTION },        { 20, Group::MOTION },     { 30, Group::MOTION },
  { 800, Group::MOTION },       { 170, Group::PLANE },        { 180, Group::PLANE },     { 190, Group::PLANE },
  { 200, Group::UNITS },        { 210, Group::UNITS },        { 900, Group::DISTANCE },  { 910, Group::DISTANCE },
  { 901, Group::ARC_DISTANCE }, { 911, Group::ARC_DISTANCE }, { 930, Group::FEED_MODE }, { 940, Group::FEED_MODE },
  { 430, Group::TOOL_LENGTH },  { 490, Group::TOOL_LENGTH },  { 540, Group::SYSTEM },    { 550, Group::SYSTEM },
  { 560, Group::SYSTEM },       { 570, Group::SYSTEM },       { 580, Group::SYSTEM },    { 590, Group::SYSTEM },
  { 591, Group::SYSTEM },       { 592, Group::SYSTEM },       { 593, Group::SYSTEM },    { 40, Group::ONCE },
  { 100, Group::ONCE },         { 280, Group::ONCE },         { 290, Group::ONCE },      { 300, Group::ONCE },
  { 530, Group::ONCE },         { 920, Group::ONCE },         { 921, Group::ONCE },      { 922, Group::ONCE },
  { 923, Group::ONCE },         { 400, Group::NOTHING },      { 610, Group::NOTHING },   { 611, Group::NOTHING },
  { 640, Group::NOTHING },      { 970, Group::NOTHING },      { 980, Group::NOTHING },   { 990, Group::NOTHING },
};

/// M codes that leave the path alone: those that share a line with moves, and those of printers that own it.
constexpr int M_BESIDE[] = { 0, 1, 3, 4, 5, 7, 8, 9, 48, 49 };
constexpr int M_ALONE[] = { 17,  73,  75,  76,  77,  82,  83,  104, 105, 106, 107, 108, 109, 110, 115, 117, 118, 140,
                            141, 190, 191, 201, 203, 204, 205, 207, 221, 300, 302, 400, 486, 572, 862, 900, 907 };
/// Filament changes, and motors without current.
constexpr int M_LOSES_ALONE[] = { 18, 84, 600 };

template <std::size_t N>
bool isOneOf(const int (&numbers)[N], int number)
{
  return std::find(std::begin(numbers), std::end(numbers), number) != std::end(numbers);
}

constexpr const char* USED = "EFHIJKLNPQRSTXYZ";
constexpr const char* OTHER_AXES = "ABCUVW";
constexpr const char* LIST = "docs/gcode.md lists what is read";

bool isIn(const char* letters, char letter)
{
  return std::string_view(letters).find(letter) != std::string_view::npos;
}

bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

/// Hands out the words of a line; comments are left out.
class WordReader
{
public:
  explicit WordReader(std::string_view line) : line_(line) {}

  /// @return false at the end of the line
  bool next(char& letter, std::string_view& number)
  {
    skip();
    if (at_ == line_.size() || (line_[at_] == '*' && has_number_of_line_))  // a check sum
      return false;
    letter = static_cast<char>(line_[at_] & ~0x20);  // in capitals
    if (letter < 'A' || letter > 'Z')
      refuse();
    if (letter == 'E' && at_ > 0 && isIn(".0123456789", line_[at_ - 1]))
      throw std::invalid_argument(
          "is E a word of its own here, or an exponent? A blank before it says so; exponents are "
          "not read");
    ++at_;
    skip();
    const std::size_t begin = at_;
    while (at_ < line_.size() && isIn("+-.0123456789", line_[at_]))
      ++at_;
    number = line_.substr(begin, at_ - begin);
    if (number.empty() && at_ < line_.size() && isIn("#[<", line_[at_]))
      refuse();
    has_number_of_line_ = has_number_of_line_ || letter == 'N';
    return true;
  }

private:
  void skip()
  {
    while (at_ < line_.size() && (isBlank(line_[at_]) || line_[at_] == '(' || line_[at_] == ';'))
    {
      const char first = line_[at_++];
      if (first == ';')
        at_ = line_.size();
      if (first != '(')
        continue;
      const std::size_t end = line_.find_first_of("()", at_);
      if (end == std::string_view::npos || line_[end] == '(')
        throw std::invalid_argument("a comment that begins with ( has to end with ), and comments do not nest");
      at_ = end + 1;
    }
  }

  [[noreturn]] void refuse() const
  {
    const char c = line_[at_];
    if (isIn("#[<", c))
      throw std::invalid_argument("parameters and expressions are not read; write numbers");
    if (c == '/')
      throw std::invalid_argument("whether a line behind / counts depends on a switch; remove the line, or the /");
    const bool is_printable = c > ' ' && c <= '~';
    throw std::invalid_argument((is_printable ? "'" + std::string(1, c) + "'" : std::string("a character")) +
                                " begins no word; " + LIST);
  }

  const std::string_view line_;
  std::size_t at_ = 0;
  bool has_number_of_line_ = false;
};

/// Ten times a number with one decimal at most.
int codeOf(char letter, std::string_view number)
{
  constexpr std::size_t LONGEST = 6;
  int code = 0;
  std::size_t decimals = 0;
  bool has_point = false;
  for (const char c : number.substr(0, LONGEST))
  {
    const bool is_digit = c >= '0' && c <= '9';
    if (is_digit)
      code = 10 * code + (c - '0');
    decimals += is_digit && has_point ? 1 : 0;
    if ((!is_digit && (c != '.' || has_point)) || decimals > 1)
      code = NO_CODE;
    has_point = has_point || c == '.';
    if (code == NO_CODE)
      break;
  }
  if (code == NO_CODE || number.empty() || number.size() > LONGEST)
    throw std::invalid_argument(std::string(1, letter) + std::string(number) + " is not a code; " + LIST);
  return decimals == 0 ? 10 * code : code;
}

[[noreturn]] void refuseCode(char letter, int code)
{
  throw std::invalid_argument(nameOf(letter, code) + " is not among the codes that are read, and may move the tool; " +
                              LIST);
}
}  // namespace

std::string nameOf(char letter, int code)
{
  return letter + std::to_string(code / 10) + (code % 10 == 0 ? "" : "." + std::to_string(code % 10));
}

Block::Block(const std::string& line)
{
  codes_.fill(NO_CODE);
  WordReader words(line);
  char letter = 0;
  std::string_view number;
  while (words.next(letter, number))
  {
    if (letter == 'M' && addM(number))
      return;
    if (letter == 'G')
      addG(number);
    else if (letter != 'M')
      add(letter, number);
    has_words_ = has_words_ || (letter != 'N' && letter != 'M');
  }
}

void Block::addG(std::string_view number)
{
  const int code = codeOf('G', number);
  const auto* const known = std::find_if(std::begin(G_CODES), std::end(G_CODES),
                                         [code](const CodeGroup& entry) { return entry.code == code; });
  if (known == std::end(G_CODES))
    refuseCode('G', code);
  if (known->group == Group::NOTHING)
  {
    others_.push_back(code);
    return;
  }
  int& place = codes_[static_cast<std::size_t>(known->group)];
  if (place != NO_CODE)
    throw std::invalid_argument(nameOf('G', place) + " and " + nameOf('G', code) + " exclude each other in a line");
  place = code;
}

bool Block::addM(std::string_view number)
{
  const int code = codeOf('M', number);
  const int whole = code % 10 == 0 || code / 10 == 862 ? code / 10 : NO_CODE;  // M862.3 asks which printer this is
  const bool loses_alone = isOneOf(M_LOSES_ALONE, whole);
  const bool owns_line = loses_alone || isOneOf(M_ALONE, whole);
  if (owns_line && (!m_codes_.empty() || !others_.empty() || has_words_))
    throw std::invalid_argument(nameOf('M', code) + " must stand in a line of its own");
  if (whole == 2 || whole == 30)
    effect_ = Effect::END;
  else if (loses_alone || whole == 6)
    effect_ = std::max(effect_, Effect::LOSES);
  else if (whole == 220)
    effect_ = std::max(effect_, Effect::SPEED);
  else if (!owns_line && !isOneOf(M_BESIDE, whole))
    refuseCode('M', code);
  m_codes_.push_back(code);
  return owns_line;
}

void Block::add(char letter, std::string_view number)
{
  if (isIn(OTHER_AXES, letter))
    throw std::invalid_argument(std::string(1, letter) + ": this machine has the axes X, Y and Z only");
  const bool is_homed = isIn("XYZ", letter) && code(Group::ONCE) == 280;  // printers home X and Y by G28 X Y
  if (number.empty() && !is_homed)
    throw std::invalid_argument(std::string(1, letter) + " has no number; " + LIST);
  if (!isIn(USED, letter))
    throw std::invalid_argument(letter + std::string(number) + " is not among the words that are read; " + LIST);
  std::string_view& value = values_[static_cast<std::size_t>(letter - 'A')];
  if (!value.empty())
    throw std::invalid_argument(std::string(1, letter) + " is given twice in the line");
  value = number.empty() ? "0" : number;
}

bool Block::hasAny(const char* letters) const
{
  for (; *letters != 0; ++letters)
    if (has(*letters))
      return true;
  return false;
}

std::string_view Block::take(char letter)
{
  taken_ |= std::uint32_t(1) << static_cast<unsigned>(letter - 'A');
  return values_[static_cast<std::size_t>(letter - 'A')];
}

void Block::requireAllTaken() const
{
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (has(letter) && (taken_ >> static_cast<unsigned>(letter - 'A') & 1U) == 0)
      throw std::invalid_argument(letter + std::string(values_[static_cast<std::size_t>(letter - 'A')]) +
                                  " is without effect in this line");
}
}  // namespace gcode
}  // namespace pkm_workspace
