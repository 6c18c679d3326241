// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/program_options.hpp>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "options.h"

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
}  // namespace

std::string Options::Option::asGiven() const
{
  return "--" + name + (words.empty() ? "" : " " + joined(words, " "));
}

void Options::Option::set(const Words& new_words, Problems& problems)
{
  const bool again = given && !repeatable;
  const bool refused_before = repeatable && refused;
  const std::size_t count = is_list ? std::max<std::size_t>(new_words.size(), 1) : countWords(values);
  words = new_words;
  given = true;
  refused = true;
  if (again)
    problems.push_back(asGiven() + ": the option is given a second time");
  else if (words.size() != count && !(for_each_leg && words.size() == 3 * count))
    problems.push_back(asGiven() + ": needs " + (count == 1 ? "one value" : std::to_string(count) + " values") +
                       (count == 0 ? "" : " (" + values + ")") +
                       (for_each_leg ? ", or that for each of three legs" : "") + ", got " +
                       std::to_string(words.size()));
  else
    try
    {
      read(words);
      refused = refused_before;
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(asGiven() + ": " + reason.what());
    }
}

void Options::readWords(const Words& words, Problems& problems)
{
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
    if (!is_option)
      problems.push_back(quoted(first == "--" && !values.empty() ? values[0] : first) +
                         ": an option was expected here, which begins with --");
    else if (Option* const option = find(first.substr(2, end - 2)))
      option->set(values, problems);
    else
      problems.push_back(first.substr(0, end) + ": there is no such option");
  }
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
  readWords(all, problems);
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
