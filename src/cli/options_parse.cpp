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
namespace style = boost::program_options::command_line_style;

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
  const std::size_t count = countWords(values);
  words = new_words;
  given = true;
  refused = true;
  if (again)
    problems.push_back(asGiven() + ": the option is given a second time");
  else if (words.size() != count)
    problems.push_back(asGiven() + ": needs " + (count == 1 ? "one value" : std::to_string(count) + " values") +
                       (count == 0 ? "" : " (" + values + ")") + ", got " + std::to_string(words.size()));
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
  // Boost takes the words apart, with any number of values for each option; how many there may be is told by set().
  po::options_description known;
  for (const Option& option : options_)
    known.add_options()(option.name.c_str(), po::value<Words>()->multitoken()->zero_tokens());
  const auto parsed = po::command_line_parser(words)
                          .options(known)
                          .style(style::allow_long | style::long_allow_next | style::long_allow_adjacent)
                          .allow_unregistered()
                          .run();
  bool after_unknown = false;
  for (const auto& item : parsed.options)
  {
    if (Option* const option = find(item.string_key))
      option->set(item.value, problems);
    else if (item.unregistered)
      problems.push_back("--" + item.string_key + ": there is no such option");
    else if (!after_unknown)
      problems.push_back("'" + item.original_tokens[0] + "': an option was expected here, which begins with --");
    after_unknown = item.unregistered || (after_unknown && item.string_key.empty());
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
  condition.check(found);
  for (const std::string& problem : found)
    problems.push_back(joined(given, ", ") + (given.empty() ? "" : ": ") + problem);
}

void Options::parse(const Words& words)
{
  Problems problems;
  readWords(words, problems);
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
