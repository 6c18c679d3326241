// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
std::string withDefault(const std::string& help, const std::string& value)
{
  return help + " [default " + value + "]";
}
}  // namespace

std::string Options::extended(const std::string& help, const char* more) const
{
  return describes_ ? help + more : "";
}

std::string Options::ranged(const std::string& help, const char* between, const Quantity& quantity) const
{
  return describes_ ? help + between + quantity.describe() : "";
}

std::string Options::numberHelp(const std::string& help, double value, const Quantity& quantity) const
{
  const std::string text = ranged(help, "; ", quantity);
  if (!describes_ || !quantity.allows(value))
    return text;
  return withDefault(text, exact(value) + (quantity.unit.empty() ? "" : " " + quantity.unit));
}

void Options::add(const std::string& name, const std::string& values, const std::string& help, const Reader& read)
{
  Option option;
  option.name = name;
  option.values = values;
  option.help = describes_ ? help : "";
  option.read = read;
  options_.push_back(std::move(option));
}

void Options::flag(const std::string& name, bool& target, const std::string& help)
{
  add(name, "", help, [&target](const Words&) { target = true; });
}

void Options::onOff(const std::string& name, bool& target, const std::string& help)
{
  add(name, "on|off", withDefault(help, target ? "on" : "off"), [&target](const Words& words) {
    target = readChoice(words[0], { "on", "off" }) == "on";
  });
}

void Options::choice(const std::string& name, std::string& target, const Words& allowed, const std::string& help)
{
  add(name, joined(allowed, "|"), target.empty() ? help : withDefault(help, target),
      [&target, allowed](const Words& words) { target = readChoice(words[0], allowed); });
}

void Options::addChoice(const std::string& name, std::size_t index, const Words& names, const std::string& help,
                        const std::function<void(std::size_t)>& set)
{
  add(name, joined(names, "|"), withDefault(help, names[index]), [set, names](const Words& words) {
    const auto chosen = std::find(names.begin(), names.end(), readChoice(words[0], names));
    set(static_cast<std::size_t>(chosen - names.begin()));
  });
}

void Options::text(const std::string& name, std::string& target, const std::string& value, const std::string& help)
{
  add(name, value, help, [&target](const Words& words) { target = readText(words[0]); });
}

void Options::texts(const std::string& name, Words& target, const std::string& values, const std::string& help)
{
  add(name, values, help, [&target](const Words& words) { target = readTexts(words); });
}

void Options::words(const std::string& name, const std::string& values, const std::string& help,
                    const std::function<void(const Words&)>& read)
{
  add(name, values, help, [read](const Words& all) { read(readTexts(all)); });
}

void Options::repeated(const std::string& name, const std::string& values, const std::string& help,
                       const std::function<void(const Words&)>& read)
{
  words(name, values, extended(help, "; may be given several times"), read);
  options_.back().repeatable = true;
}

void Options::lists(const std::string& name, const std::string& values, const std::string& help,
                    const std::function<void(const Words&)>& read)
{
  repeated(name, values, help, read);
  options_.back().is_list = true;
}

void Options::legs(const std::string& name, const std::string& values, const std::string& help,
                   const std::function<void(const Words&)>& read)
{
  words(name, values, extended(help, "; for all legs, or three times"), read);
  options_.back().for_each_leg = true;
}

void Options::repeatedLegs(const std::string& name, const std::string& values, const std::string& help,
                           const std::function<void(const Words&)>& read)
{
  legs(name, values, help, read);
  options_.back().repeatable = true;
}

void Options::number(const std::string& name, double& target, const Quantity& quantity, const std::string& help)
{
  add(name, "NUMBER", numberHelp(help, target, quantity),
      [&target, quantity](const Words& words) { target = readNumbers(words, quantity)[0]; });
}

void Options::number(const std::string& name, std::optional<double>& target, const Quantity& quantity,
                     const std::string& help)
{
  add(name, "NUMBER", ranged(help, "; ", quantity),
      [&target, quantity](const Words& words) { target = readNumbers(words, quantity)[0]; });
}

void Options::addCount(const std::string& name, std::int64_t value, std::int64_t upper, const std::string& help,
                       const std::function<void(std::int64_t)>& set)
{
  const std::string text = help + "; from 1 to " + std::to_string(upper);
  add(name, "COUNT", value >= 1 ? withDefault(text, std::to_string(value)) : text,
      [set, upper](const Words& words) { set(readCount(words[0], upper)); });
}

void Options::vector(const std::string& name, std::optional<Eigen::Vector3d>& target, const std::string& values,
                     const Quantity& quantity, const std::string& help)
{
  add(name, values, ranged(help, "; each ", quantity), [&target, quantity](const Words& words) {
    const std::vector<double> numbers = readNumbers(words, quantity);
    target = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  });
}

void Options::pair(const std::string& name, std::optional<std::array<double, 2>>& target, const std::string& values,
                   const Quantity& quantity, const std::string& help)
{
  add(name, values, ranged(help, "; each ", quantity), [&target, quantity](const Words& words) {
    const std::vector<double> numbers = readNumbers(words, quantity);
    target = std::array<double, 2>{ numbers[0], numbers[1] };
  });
}

void Options::range(const std::string& name, std::optional<RatioRange>& target, const Quantity& quantity,
                    const std::string& help)
{
  add(name, "LO HI", extended(ranged(help, "; each ", quantity), ", LO <= HI"),
      [&target, quantity](const Words& words) {
        const std::vector<double> numbers = readNumbers(words, quantity);
        if (!(numbers[0] <= numbers[1]))
          throw std::invalid_argument("LO is larger than HI");
        target = RatioRange{ numbers[0], numbers[1] };
      });
}

void Options::points(const std::string& name, std::vector<Eigen::Vector3d>& target, const std::string& help,
                     const std::function<std::vector<Eigen::Vector3d>(const std::string&)>& read)
{
  add(name, "FILE", help, [&target, read](const Words& words) { target = read(readText(words[0])); });
  options_.back().take_points = [&target](const std::vector<Eigen::Vector3d>& points) { target = points; };
}

void Options::box(const std::string& name, std::optional<Box>& target, const std::string& help)
{
  add(name, "X0 X1 Y0 Y1 Z0 Z1", extended(ranged(help, "; each ", LENGTH), ", X0 <= X1, Y0 <= Y1, Z0 <= Z1"),
      [&target](const Words& words) { target = readBox(words); });
}

void Options::require(const Words& names)
{
  for (const std::string& name : names)
  {
    Option* const option = find(name);
    option->required = true;
    option->help = "required: " + option->help;
  }
}

void Options::check(const Words& names, const std::function<void(Problems&)>& condition)
{
  conditions_.push_back({ names, condition });
}

const Options::Option* Options::find(const std::string& name) const
{
  if (places_.size() != options_.size())
    for (std::size_t k = places_.size(); k < options_.size(); ++k)
      places_.emplace(options_[k].name, k);
  const auto place = places_.find(name);
  return place == places_.end() ? nullptr : &options_[place->second];
}

Options::Option* Options::find(const std::string& name)
{
  return const_cast<Option*>(static_cast<const Options*>(this)->find(name));
}

Words Options::names() const
{
  Words names;
  for (const Option& option : options_)
    names.push_back(option.name);
  return names;
}

std::optional<Options::Kind> Options::kindOf(const std::string& name) const
{
  const Option* const option = find(name);
  if (option == nullptr)
    return std::nullopt;
  return Kind{ option->values, option->repeatable, option->is_list, bool(option->take_points), option->for_each_leg };
}

bool Options::given(const std::string& name) const
{
  const Option* const option = find(name);
  return option != nullptr && option->given;
}
}  // namespace cli
}  // namespace pkm_workspace
