// SPDX-License-Identifier: BSD-3-Clause
#include "defines.h"

#include <algorithm>
#include <cctype>

#include "c_text.h"

namespace pkm_workspace
{
namespace firmware
{
namespace
{
constexpr int MOST_NAMES = 20;            ///< that stand for one another
constexpr int MOST_EVALUATIONS = 100000;  ///< of one file: sums of sums grow without end

/// The first word, and what follows it.
std::pair<std::string, std::string> cutWord(const std::string& text)
{
  const auto is_end = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_'; };
  const auto end = std::find_if(text.begin(), text.end(), is_end);
  return { { text.begin(), end }, { end, text.end() } };
}
}  // namespace

Defines::Defines(const std::vector<SourceLine>& lines, Reading& reading)
{
  for (const SourceLine& line : codeLines(lines, reading))
    read(line, reading);
  for (const Branch& branch : branches_)
    reading.refuse(branch.line.place, quoted(branch.line.text), " has no #endif; is the end of the file missing?");
}

void Defines::read(const SourceLine& line, Reading& reading)
{
  if (line.text[0] != '#')
    return;
  const auto [word, rest] = cutWord(trimmed(line.text.substr(1)));
  if (word == "if")
    open(line, rest);
  else if (word == "ifdef")
    open(line, "defined(" + trimmed(rest) + ")");
  else if (word == "ifndef")
    open(line, "!defined(" + trimmed(rest) + ")");
  else if (word == "elif" || word == "else")
    turn(line, rest, word == "else", reading);
  else if (word == "endif" && branches_.empty())
    reading.refuse(line.place, "this #endif has no #if; is the beginning of the file missing?");
  else if (word == "endif")
    branches_.pop_back();
  else if (word == "define" && state() != State::SKIPPED)
    define(line, trimmed(rest), reading);
  else if (word == "undef" && state() == State::TAKEN)
    undefine(trimmed(rest));
  else if (word == "undef" && state() == State::UNDECIDED)
    undecided_[trimmed(rest)] = toText(branches_.back().line.place) + ": " + branches_.back().line.text;
}

void Defines::define(const SourceLine& line, const std::string& rest, Reading& reading)
{
  const auto [name, value] = cutWord(rest);
  if (name.empty())
    return reading.refuse(line.place, quoted(line.text), " defines no name; expected #define NAME value");
  if (state() == State::UNDECIDED)
    undecided_[name] = toText(branches_.back().line.place) + ": " + branches_.back().line.text;
  else if (value.empty() || value[0] != '(')
    active_.push_back({ line.place, name, trimmed(value) });
}

void Defines::undefine(const std::string& name)
{
  active_.erase(std::remove_if(active_.begin(), active_.end(), [&](const Entry& entry) { return entry.key == name; }),
                active_.end());
  undecided_.erase(name);
}

Defines::State Defines::stateOf(const Branch& branch, const std::string& condition) const
{
  if (branch.around == State::SKIPPED || branch.had_taken)
    return State::SKIPPED;
  const std::optional<Decimal> value = evaluate(condition, 0);
  if (value && *value == 0)
    return State::SKIPPED;
  return value && !branch.had_undecided ? branch.around : State::UNDECIDED;
}

void Defines::open(const SourceLine& line, const std::string& condition)
{
  Branch branch = { state(), State::TAKEN, false, false, false, line };
  branch.now = stateOf(branch, condition);
  branches_.push_back(branch);
}

void Defines::turn(const SourceLine& line, const std::string& condition, bool is_else, Reading& reading)
{
  if (branches_.empty() || branches_.back().had_else)
    return reading.refuse(line.place, quoted(line.text), " follows no #if; is the beginning of the file missing?");
  Branch& branch = branches_.back();
  branch.had_taken = branch.had_taken || branch.now == State::TAKEN;
  branch.had_undecided = branch.had_undecided || branch.now == State::UNDECIDED;
  branch.had_else = is_else;
  branch.now = stateOf(branch, is_else ? "1" : condition);
}

std::string Defines::undecided(const std::string& name) const
{
  const auto found = undecided_.find(name);
  return found == undecided_.end() ? "" : found->second;
}

const Entry* Defines::find(const std::string& name) const
{
  const auto found =
      std::find_if(active_.rbegin(), active_.rend(), [&](const Entry& entry) { return entry.key == name; });
  return found == active_.rend() ? nullptr : &*found;
}

bool Defines::isEnabled(const std::string& name) const
{
  const Entry* const entry = find(name);
  return entry != nullptr && (entry->text.empty() || entry->text == "1" || entry->text == "true");
}

std::optional<Decimal> Defines::evaluate(const std::string& text, int depth) const
{
  if (depth > MOST_NAMES || ++evaluations_ > MOST_EVALUATIONS)
    return std::nullopt;
  const auto value = [&](const std::string& name) -> std::optional<Decimal> {
    const Entry* const entry = find(name);
    used_.insert(name);
    if (name == "true" || name == "false")
      return Decimal(name == "true" ? 1 : 0);
    if (entry == nullptr || !undecided(name).empty())
      return std::nullopt;
    return evaluate(entry->text, depth + 1);
  };
  return evaluateExpression(
      text, { value, [this](const std::string& name, const std::string& arguments) { return call(name, arguments); } });
}

std::optional<Decimal> Defines::call(const std::string& function, const std::string& arguments) const
{
  const std::vector<std::string> names = split(arguments, ',');
  if (std::any_of(names.begin(), names.end(), [&](const std::string& name) { return !undecided(name).empty(); }))
    return std::nullopt;
  const auto enabled =
      std::count_if(names.begin(), names.end(), [&](const std::string& name) { return isEnabled(name); });
  const auto all = static_cast<std::ptrdiff_t>(names.size());
  const auto truth = [](bool value) { return Decimal(value ? 1 : 0); };
  if (function == "defined")
    return truth(find(names[0]) != nullptr);
  if (function == "ENABLED" || function == "ANY" || function == "EITHER")
    return truth(enabled > 0);
  if (function == "ALL" || function == "BOTH")
    return truth(enabled == all);
  if (function == "DISABLED" || function == "NONE")
    return truth(enabled == 0);
  return std::nullopt;
}
}  // namespace firmware
}  // namespace pkm_workspace
