// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/program_options.hpp>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "options.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
namespace po = boost::program_options;

constexpr unsigned LINE_LENGTH = 100;

std::size_t countWords(const std::string& text)
{
  std::istringstream stream(text);
  return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(stream), {}));
}

const std::vector<Eigen::Vector3d>& checked(const std::vector<Eigen::Vector3d>& points)
{
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const double x : { points[k].x(), points[k].y(), points[k].z() })
      if (!LENGTH.allows(x))
        throw std::invalid_argument("point " + std::to_string(k) + ": " + exact(x) +
                                    " is out of range; allowed: " + LENGTH.describe());
  if (points.empty())
    throw std::invalid_argument("there is no point");
  return points;
}

/// How many letters are to be put in, taken out or replaced to make one word of the other.
std::size_t lettersBetween(const std::string& one, const std::string& other)
{
  std::vector<std::size_t> row(other.size() + 1);
  for (std::size_t k = 0; k < row.size(); ++k)
    row[k] = k;
  for (std::size_t i = 1; i <= one.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k < row.size(); ++k)
    {
      const std::size_t replaced = diagonal + (one[i - 1] == other[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({ row[k] + 1, row[k - 1] + 1, replaced });
    }
  }
  return row.back();
}
}  // namespace

std::string Options::Option::asGiven() const
{
  return "--" + name + (words.empty() ? "" : " " + joined(words, " "));
}

/// Which number of words is wrong, and how; nothing where it is right.
std::string Options::Option::miscounted() const
{
  const std::size_t count = is_list ? std::max<std::size_t>(words.size(), 1) : countWords(values);
  if (words.size() == count || (for_each_leg && words.size() == 3 * count))
    return "";
  return "needs " + (count == 1 ? "one value" : std::to_string(count) + " values") +
         (count == 0 ? "" : " (" + values + ")") + (for_each_leg ? ", or that for each of three legs" : "") + ", got " +
         std::to_string(words.size());
}

void Options::Option::set(const Given& now, Problems& problems)
{
  const bool again = given && !repeatable;
  const bool refused_before = repeatable && refused;
  words = now.words;
  given = true;
  refused = true;
  try
  {
    if (again)
      throw std::invalid_argument("the option is given a second time");
    if (const std::string problem = now.points ? "" : miscounted(); !problem.empty())
      throw std::invalid_argument(problem);
    if (now.points)
      take_points(checked(*now.points));
    else
      read(words);
    refused = refused_before;
  }
  catch (const std::invalid_argument& reason)
  {
    problems.push_back(asGiven() + ": " + reason.what());
  }
}

std::vector<Options::Given> Options::split(const Words& words, Problems& problems) const
{
  std::vector<Given> all;
  for (std::size_t k = 0; k < words.size();)
  {
    const std::string first = words[k++];
    const bool is_option = first.size() > 2 && first.compare(0, 2, "--") == 0;
    const std::size_t end = std::min(first.size(), first.find('='));
    Words values;
    if (is_option && end < first.size())
      values.push_back(first.substr(end + 1));
    while (k < words.size() && words[k].compare(0, 2, "--") != 0)
      values.push_back(words[k++]);
    if (is_option)
      all.push_back({ first.substr(2, end - 2), values });
    else
      problems.push_back(quoted(first == "--" && !values.empty() ? values[0] : first) +
                         ": an option was expected here, which begins with --");
  }
  return all;
}

/// With the option that was meant, if it is like one.
std::string Options::unknown(const std::string& name) const
{
  const std::string* closest = nullptr;
  std::size_t least = 1 + name.size() / 3;  // letters that may be wrong
  for (const Option& option : options_)
    if (const std::size_t wrong = lettersBetween(name, option.name); wrong < least)
    {
      closest = &option.name;
      least = wrong;
    }
  return "--" + name + ": there is no such option" + (closest != nullptr ? "; did you mean --" + *closest + "?" : "");
}

void Options::checkCondition(const Condition& condition, Problems& problems) const
{
  Words given;
  for (const std::string& name : condition.names)
  {
    const Option* const option = find(name);
    if (option->refused || (option->required && !option->given))
      return;
    if (option->given)
      given.push_back(option->asGiven());
  }
  Problems found;
  try
  {
    condition.check(found);
  }
  catch (const std::bad_optional_access&)
  {
    return;  // it is about what another condition has refused, such as a machine that cannot be read
  }
  for (const std::string& problem : found)
    problems.push_back(joined(given, ", ") + (given.empty() ? "" : ": ") + problem);
}

void Options::parse(const Words& words)
{
  Problems problems;
  Words all = words;
  if (!leading_.empty() && !all.empty() && all[0].compare(0, 2, "--") != 0)
    all.insert(all.begin(), "--" + leading_);
  const std::vector<Given> given = split(all, problems);
  finish(given, problems);
}

void Options::parse(const std::vector<Given>& all)
{
  Problems problems;
  finish(all, problems);
}

void Options::finish(const std::vector<Given>& all, Problems& problems)
{
  for (const Given& one : all)
    if (Option* const option = find(one.name))
      option->set(one, problems);
    else
      problems.push_back(unknown(one.name));
  for (const Option& option : options_)
    if (option.required && !option.given)
      problems.push_back("--" + option.name + " " + option.values + ": the option is missing");
  for (const Condition& condition : conditions_)
    checkCondition(condition, problems);
  throwProblems(problems);
}

void Options::describe(std::ostream& stream) const
{
  po::options_description known("options", LINE_LENGTH, LINE_LENGTH / 2);
  for (const Option& option : options_)
    if (option.values.empty())
      known.add_options()(option.name.c_str(), option.help.c_str());
    else
      known.add_options()(option.name.c_str(), po::value<Words>()->value_name(option.values), option.help.c_str());
  stream << known;
}
}  // namespace cli
}  // namespace pkm_workspace
