// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>

#include "caller.h"
#include "options.h"
#include "pkm_workspace/dexterity/unbounded.h"

namespace pkm_workspace
{
struct UrdfMachine;

namespace cli
{
/// Something outside the program failed: the memory, the disk, who reads the answer.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Writes what is too long to be held while it is made.
using Writer = std::function<void(std::ostream&)>;

/// A text that is made when it is read.
class Text
{
public:
  template <class Made, class = std::enable_if_t<std::is_convertible_v<Made, std::string>>>
  Text(const Made& text) : make_([made = std::string(text)] { return made; })
  {}
  Text(std::function<std::string()> make) : make_(std::move(make)) {}
  std::string operator()() const { return make_(); }

private:
  std::function<std::string()> make_;
};

/// A list that is made entry by entry, so that it need not be held.
struct LongList
{
  std::function<bool()> goes_on;  ///< whether there is another entry
  std::function<nlohmann::json()> next;
};
/// Lists of boxes, by name.
using BoxLists = std::map<std::string, std::function<std::vector<Box>()>>;
/// What is long, or known only after that.
using LongMember = std::variant<LongList, BoxLists, std::function<nlohmann::json()>>;

/// What a command prints on standard output: the object with --json, the text without.
struct Answer
{
  nlohmann::json json;
  Text text;
  std::map<std::string, LongMember> long_members = {};  ///< more members of the object, by name, made in their order
  Writer long_text = {};                                ///< what follows the text
};

/// One command of pkm, for one call: its options are its members.
class Command
{
public:
  virtual ~Command() = default;
  /// Who runs it, told before all else.
  void setCaller(Caller& caller) { caller_ = &caller; }
  /// What it does and what its answer means, for the help text.
  virtual std::string description() const = 0;
  /// Command lines that work.
  virtual Words examples() const = 0;
  virtual void declare(Options& options) = 0;
  /// What in the input is not used, for standard error. @pre the options have been parsed
  virtual Words warnings() const { return {}; }
  /// What it chose by itself, for standard error. @pre the options have been parsed
  virtual Words notes() const { return {}; }
  /// What its options can do about a question without a bounded answer.
  virtual Remedy remedy() const { return { "--joint-limits on", "" }; }
  /// What is long refers to the command. @pre the options have been parsed
  /// @throws std::invalid_argument when the question has no answer
  virtual Answer answer() = 0;
  /// Keeps in files what was computed; called last. @pre the answer was printed @throws std::invalid_argument with the
  /// reason
  virtual void save() {}
  /// The machine that it makes, if that is what it does. @pre as above
  virtual const UrdfMachine* made() { return nullptr; }

protected:
  Caller& caller() const { return *caller_; }

private:
  Caller* caller_ = nullptr;
};

struct NamedCommand
{
  const char* name;
  const char* summary;
  std::unique_ptr<Command> (*make)();
};

/// @throws std::invalid_argument where there is none of that name
const NamedCommand& findCommand(const std::string& name);

/// What Python does of the command: becomes a module of its package pkm_workspace, "study" or "report", with these
/// words.
/// @throws Failure where that cannot be
void becomePython(const std::string& module, const Words& words);

std::unique_ptr<Command> makeEvaluate();
std::unique_ptr<Command> makeLargest();
std::unique_ptr<Command> makeCheck();
std::unique_ptr<Command> makePath();
std::unique_ptr<Command> makePlace();
std::unique_ptr<Command> makePave();
std::unique_ptr<Command> makeConnect();
std::unique_ptr<Command> makeCompare();
std::unique_ptr<Command> makeStudy();
std::unique_ptr<Command> makeSingularities();
std::unique_ptr<Command> makeConditioning();
std::unique_ptr<Command> makeGuarantee();
std::unique_ptr<Command> makeTolerate();
std::unique_ptr<Command> makeUrdf();
std::unique_ptr<Command> makeImport();
std::unique_ptr<Command> makeExport();
std::unique_ptr<Command> makeVerify();
}  // namespace cli
}  // namespace pkm_workspace
