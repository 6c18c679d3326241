// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "expression.h"
#include "reading.h"

namespace pkm_workspace
{
namespace firmware
{
/// The #defines of a C header that a compiler would see. Branches count where their condition is decided by the file
/// itself: by ENABLED(), DISABLED(), defined(), ANY(), ALL() and the like, numbers and comparisons. What stands in
/// others is undecided.
class Defines
{
public:
  Defines(const std::vector<SourceLine>& lines, Reading& reading);

  /// In their order; undefined ones are gone.
  const std::vector<Entry>& active() const { return active_; }
  /// Why a name is undecided; empty where it is not.
  std::string undecided(const std::string& name) const;
  /// As Marlin's ENABLED(): defined as nothing, 1 or true.
  bool isEnabled(const std::string& name) const;
  std::optional<Decimal> evaluate(const std::string& text) const { return evaluate(text, 0); }
  /// Whether another value was made with it.
  bool wasUsed(const std::string& name) const { return used_.count(name) > 0; }

private:
  enum class State
  {
    TAKEN,
    SKIPPED,
    UNDECIDED
  };
  struct Branch
  {
    State around;  ///< of what the #if stands in
    State now;
    bool had_taken;
    bool had_undecided;
    bool had_else;
    SourceLine line;
  };

  void read(const SourceLine& line, Reading& reading);
  void define(const SourceLine& line, const std::string& rest, Reading& reading);
  void undefine(const std::string& name);
  void open(const SourceLine& line, const std::string& condition);
  void turn(const SourceLine& line, const std::string& condition, bool is_else, Reading& reading);
  State stateOf(const Branch& branch, const std::string& condition) const;
  State state() const { return branches_.empty() ? State::TAKEN : branches_.back().now; }
  const Entry* find(const std::string& name) const;
  std::optional<Decimal> evaluate(const std::string& text, int depth) const;
  std::optional<Decimal> call(const std::string& function, const std::string& arguments) const;

  std::vector<Entry> active_;
  std::map<std::string, std::string> undecided_;  ///< names, and the condition with its place
  std::vector<Branch> branches_;
  mutable std::set<std::string> used_;
  mutable int evaluations_ = 0;
};
}  // namespace firmware
}  // namespace pkm_workspace
