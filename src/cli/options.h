// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "pkm_workspace/region/largest_region.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
struct GivenMachine;

/// The options of one command: each is declared once, with the variable that it sets, its unit and range; parsing, the
/// help text with ranges and defaults, and the refusals follow from that. What the variable holds is the default; a
/// number out of its own range is none.
///
/// There are only long options, so that negative numbers are numbers: --point -0.1 0 0.2.
class Options
{
public:
  /// What an option was given, once.
  struct Given
  {
    std::string name;
    Words words;
    std::optional<std::vector<Eigen::Vector3d>> points = {};  ///< in place of words, by programs
  };
  /// What is known of an option, for who gives values that are no words yet.
  struct Kind
  {
    std::string values;  ///< names of the values, separated by blanks; empty of a flag
    bool is_repeatable;
    bool is_list;       ///< whether it takes any number of words
    bool takes_points;  ///< whether points may take the place of the file that it names
    bool for_each_leg;  ///< whether it takes three times as many words, too
  };

  /// @param describes whether describe() will be called
  /// @param machines that the command is about, in place of its options --urdf
  explicit Options(bool describes = false, std::vector<const GivenMachine*> machines = {})
    : describes_(describes), machines_(std::move(machines))
  {
    options_.reserve(100);
  }
  const std::vector<const GivenMachine*>& machines() const { return machines_; }
  Words names() const;
  std::optional<Kind> kindOf(const std::string& name) const;

  void flag(const std::string& name, bool& target, const std::string& help);
  void onOff(const std::string& name, bool& target, const std::string& help);
  void choice(const std::string& name, std::string& target, const Words& allowed, const std::string& help);
  /// One of an enumeration, by names in its order.
  template <class Choice, std::size_t N>
  void choice(const std::string& name, Choice& target, const std::array<const char*, N>& names, const std::string& help)
  {
    addChoice(name, static_cast<std::size_t>(target), { names.begin(), names.end() }, help,
              [&target](std::size_t index) { target = static_cast<Choice>(index); });
  }
  void text(const std::string& name, std::string& target, const std::string& value, const std::string& help);
  void texts(const std::string& name, Words& target, const std::string& values, const std::string& help);
  /// May be given several times. @p read may throw std::invalid_argument with the reason.
  void repeated(const std::string& name, const std::string& values, const std::string& help,
                const std::function<void(const Words&)>& read);
  /// The same with one word or more each time.
  void lists(const std::string& name, const std::string& values, const std::string& help,
             const std::function<void(const Words&)>& read);
  /// Takes the words that @p values names. @p read may throw std::invalid_argument with the reason.
  void words(const std::string& name, const std::string& values, const std::string& help,
             const std::function<void(const Words&)>& read);
  /// Takes the words that @p values names for all legs, or three times as many, leg after leg. @p read gets them as
  /// given, and may throw std::invalid_argument with the reason.
  void legs(const std::string& name, const std::string& values, const std::string& help,
            const std::function<void(const Words&)>& read);
  /// The same, that may be given several times.
  void repeatedLegs(const std::string& name, const std::string& values, const std::string& help,
                    const std::function<void(const Words&)>& read);
  void number(const std::string& name, double& target, const Quantity& quantity, const std::string& help);
  void number(const std::string& name, std::optional<double>& target, const Quantity& quantity,
              const std::string& help);
  /// From 1 to @p upper.
  template <class Integer>
  void count(const std::string& name, Integer& target, std::int64_t upper, const std::string& help)
  {
    addCount(name, target, upper, help, [&target](std::int64_t value) { target = static_cast<Integer>(value); });
  }
  void vector(const std::string& name, std::optional<Eigen::Vector3d>& target, const std::string& values,
              const Quantity& quantity, const std::string& help);
  void pair(const std::string& name, std::optional<std::array<double, 2>>& target, const std::string& values,
            const Quantity& quantity, const std::string& help);
  /// Two numbers, the least one first.
  void range(const std::string& name, std::optional<RatioRange>& target, const Quantity& quantity,
             const std::string& help);
  /// The points of a file, which @p read reads.
  void points(const std::string& name, std::vector<Eigen::Vector3d>& target, const std::string& help,
              const std::function<std::vector<Eigen::Vector3d>(const std::string&)>& read = readPoints);
  void box(const std::string& name, std::optional<Box>& target, const std::string& help);

  /// Asks for the options of these names.
  void require(const Words& names);
  /// A condition on the options of these names, looked at unless one of them was refused or is missing. What it appends
  /// is told with those that were given in front.
  void check(const Words& names, const std::function<void(Problems&)>& condition);
  bool given(const std::string& name) const;
  /// Whether there is an option of this name.
  bool has(const std::string& name) const { return find(name) != nullptr; }
  /// A word before all options is the value of this one.
  void lead(const std::string& name) { leading_ = name; }
  /// " FILE" where there is such an option, for help texts.
  std::string leadingWord() const { return leading_.empty() ? "" : " " + find(leading_)->values; }

  /// Sets the variables. @throws std::invalid_argument with everything that is wrong, one problem a line
  void parse(const Words& words);
  /// The same of what is no command line.
  void parse(const std::vector<Given>& all);
  /// Writes one entry for each option.
  void describe(std::ostream& stream) const;

private:
  /// Sets the variable, or throws std::invalid_argument with the reason.
  using Reader = std::function<void(const Words&)>;
  struct Option
  {
    std::string name;
    std::string values;  ///< names of the values, separated by blanks
    std::string help;
    Reader read;
    std::function<void(const std::vector<Eigen::Vector3d>&)> take_points = {};
    bool repeatable = false;
    bool is_list = false;
    bool for_each_leg = false;
    bool required = false;
    bool given = false;
    bool refused = false;
    Words words = {};  ///< as given

    void set(const Given& now, Problems& problems);
    std::string miscounted() const;
    std::string asGiven() const;
  };
  struct Condition
  {
    Words names;
    std::function<void(Problems&)> check;
  };

  void add(const std::string& name, const std::string& values, const std::string& help, const Reader& read);
  void addChoice(const std::string& name, std::size_t index, const Words& names, const std::string& help,
                 const std::function<void(std::size_t)>& set);
  void addCount(const std::string& name, std::int64_t value, std::int64_t upper, const std::string& help,
                const std::function<void(std::int64_t)>& set);
  const Option* find(const std::string& name) const;
  Option* find(const std::string& name);
  std::vector<Given> split(const Words& words, Problems& problems) const;
  std::string unknown(const std::string& name) const;
  void finish(const std::vector<Given>& all, Problems& problems);
  /// Helps with what follows from the rest; nothing where nobody reads them.
  std::string extended(const std::string& help, const char* more) const;
  std::string ranged(const std::string& help, const char* between, const Quantity& quantity) const;
  std::string numberHelp(const std::string& help, double value, const Quantity& quantity) const;
  void checkCondition(const Condition& condition, Problems& problems) const;

  std::vector<Option> options_;
  mutable std::unordered_map<std::string, std::size_t> places_;  ///< of the options, by name
  std::vector<Condition> conditions_;
  std::string leading_;
  bool describes_;
  std::vector<const GivenMachine*> machines_;
};
}  // namespace cli
}  // namespace pkm_workspace
