// SPDX-License-Identifier: BSD-3-Clause
#include "values.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// The number that a word stands for, or an empty text's worth of trouble: what is wrong with it.
struct Reading
{
  double value = 0.0;
  std::string problem;
};

Reading readNumber(const std::string& word, const Quantity& quantity)
{
  const std::optional<double> number = parseNumber(word);
  Reading reading;
  reading.value = number.value_or(0.0);
  if (!number && word.find(',') != std::string::npos)
    reading.problem = "'" + word + "' has a comma; write a decimal point, and blanks between numbers";
  else if (!number)
    reading.problem = quoted(word) + " is not a number";
  else if (!std::isfinite(*number))
    reading.problem = word + " is not a finite number that fits a double";
  else if (!quantity.allows(*number))
    reading.problem = word + " is out of range";
  return reading;
}

void throwIfAny(const Words& problems)
{
  if (!problems.empty())
    throw std::invalid_argument(joined(problems, "; "));
}
}  // namespace

Words wordsOf(const std::string& line)
{
  constexpr const char* BLANKS = " \t\r\v\f\n";
  const std::string text = line.substr(0, line.find('#'));
  Words words;
  for (std::size_t end = 0, begin; (begin = text.find_first_not_of(BLANKS, end)) != std::string::npos;)
  {
    end = std::min(text.size(), text.find_first_of(BLANKS, begin));
    words.push_back(text.substr(begin, end - begin));
  }
  return words;
}

std::string quoted(std::string word)
{
  for (std::size_t k = word.find('\0'); k != std::string::npos; k = word.find('\0', k))
    word.replace(k, 1, "\\0");
  return "'" + word + "'";
}

bool Quantity::allows(double value) const
{
  return (lower_allowed ? value >= lower : value > lower) && value <= upper;
}

std::string Quantity::describe() const
{
  if (!std::isfinite(lower))
    return unit.empty() ? "a number" : "a number [" + unit + "]";
  if (lower == -upper)
    return "a number [" + unit + "] within " + exact(upper) + " " + unit;
  if (std::isfinite(upper))
    return "from " + exact(lower) + " to " + exact(upper) + (unit.empty() ? "" : " " + unit);
  return (lower_allowed ? ">= " : "> ") + exact(lower) + (unit.empty() ? ", without unit" : " " + unit);
}

std::vector<double> readNumbers(const Words& words, const Quantity& quantity)
{
  std::vector<double> numbers;
  Words problems;
  for (const std::string& word : words)
  {
    const Reading reading = readNumber(word, quantity);
    numbers.push_back(reading.value);
    if (!reading.problem.empty())
      problems.push_back(reading.problem);
  }
  if (!problems.empty())
    problems.push_back("allowed: " + quantity.describe());
  throwIfAny(problems);
  return numbers;
}

std::int64_t readCount(const std::string& word, std::int64_t upper)
{
  char* end = nullptr;
  errno = 0;
  const long long value = std::strtoll(word.c_str(), &end, 10);
  const bool is_number =
      !word.empty() && !std::isspace(static_cast<unsigned char>(word[0])) && end == word.c_str() + word.size();
  if (!is_number || errno == ERANGE || value < 1 || value > upper)
    throw std::invalid_argument((is_number ? word + " is out of range" : "'" + word + "' is not a whole number") +
                                "; allowed: from 1 to " + std::to_string(upper));
  return value;
}

std::string readChoice(const std::string& word, const Words& allowed)
{
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    throw std::invalid_argument("'" + word + "' is not known; allowed: " + joined(allowed, ", "));
  return word;
}

std::string readText(const std::string& word)
{
  if (word.empty())
    throw std::invalid_argument("the text is empty");
  return word;
}

Words readTexts(const Words& words)
{
  Words texts;
  std::transform(words.begin(), words.end(), std::back_inserter(texts), readText);
  return texts;
}

std::vector<Eigen::Vector3d> readPoints(const std::string& path)
{
  std::vector<Eigen::Vector3d> points;
  readLines(path, [&points](const std::string& line, std::size_t number) {
    const Words words = wordsOf(line);
    if (words.empty())
      return;
    const std::string place = "line " + std::to_string(number) + ": ";
    if (words.size() != 3)
      throw std::invalid_argument(place + "needs 3 numbers (X Y Z), got " + std::to_string(words.size()));
    try
    {
      const std::vector<double> numbers = readNumbers(words, LENGTH);
      points.emplace_back(numbers[0], numbers[1], numbers[2]);
    }
    catch (const std::invalid_argument& reason)
    {
      throw std::invalid_argument(place + reason.what());
    }
  });
  if (points.empty())
    throw std::invalid_argument("the file has no point");
  return points;
}

Box readBox(const Words& words)
{
  const std::vector<double> faces = readNumbers(words, LENGTH);
  const Box box{ { faces[0], faces[2], faces[4] }, { faces[1], faces[3], faces[5] } };
  Words problems;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (faces[2 * axis] > faces[2 * axis + 1])
    {
      const std::string letter(1, "XYZ"[axis]);
      problems.push_back(words[2 * axis] + " m is above " + words[2 * axis + 1] + " m; allowed: " + letter +
                         "0 <= " + letter + "1");
    }
  throwIfAny(problems);
  return box;
}
}  // namespace cli
}  // namespace pkm_workspace
