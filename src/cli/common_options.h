// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "options.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace cli
{
/// What is in a URDF and not used, and what was made of it that a user may not expect.
Words remarksOn(const UrdfMachine& urdf);

/// The tolerances that options give one machine: those of a file count where there is no option of their kind.
struct ToleranceWish
{
  GivenTolerances by_option;
  std::optional<GivenTolerances> by_file;

  GivenTolerances both() const;
};

/// --urdf, --rails, --tcp-links, --tool-link, --tool: read while the options are, so that all problems are told at
/// once.
class MachineOptions
{
public:
  void declare(Options& options);
  /// @pre the options have been parsed @throws std::bad_optional_access in conditions on a machine that was refused
  const Machine& machine() const { return urdf().machine; }
  /// The same with what else its URDF says.
  const UrdfMachine& urdf() const { return urdf_.value(); }
  /// With which it was read. @pre as above
  const UrdfOptions& names() const { return names_; }
  Words warnings() const
  {
    Words all = remarksOn(*urdf_);
    all.insert(all.end(), remarks_.begin(), remarks_.end());
    return all;
  }
  const Words& notes() const { return notes_; }
  /// --keep-out-collisions.
  void declareCollisions(Options& options);
  /// Adds them to the zones, where asked for. @pre as above
  void addCollisions(Criterion& criterion, Problems& problems) const;
  /// Adds to the warnings.
  void remark(const std::string& text) { remarks_.push_back(text); }
  /// Adds to the notes.
  void note(const std::string& text) { notes_.push_back(text); }

private:
  void read(const Options& options, Problems& problems);
  void take(const GivenMachine& given);

  std::string path_;
  UrdfOptions names_;
  ToleranceWish tolerances_;
  std::optional<UrdfMachine> urdf_;
  bool keeps_out_collisions_ = false;
  Words remarks_;
  Words notes_;
};

constexpr const char* AFTER_URDF = "; after the --urdf it is about";

/// The same for several machines: --urdf once for each of them, with names of its own after it.
class MachinesOptions
{
public:
  void declare(Options& options);
  /// After each --urdf, those of its machine.
  void declareTolerances(Options& options);
  /// In the order given. @pre the options have been parsed
  const std::vector<UrdfMachine>& machines() const { return machines_; }
  /// How many were asked for, read or not.
  std::size_t count() const { return given_ + requests_.size(); }
  Words warnings() const;

private:
  struct Request
  {
    std::string path;
    UrdfOptions names;
    ToleranceWish tolerances;
  };

  /// The machine that was named last. @throws std::invalid_argument where there is none
  Request& latest();

  /// Sets what @p member names of the machine that was named last.
  template <class Member>
  std::function<void(const Words&)> setterOf(Member member);
  template <class Member>
  void declareNames(Options& options, const std::string& name, const std::string& values, const std::string& help,
                    Member member);

  std::size_t given_ = 0;  ///< of the machines: those that were read before
  std::vector<Request> requests_;
  std::vector<UrdfMachine> machines_;
};

/// --set, --aspect, one option for each bound, --joint-limits. Sets the criterion, the default too.
/// "psi-min" of "psi_min".
std::string optionOf(std::string name);

/// What is known of the joints, each one number for all legs, or three. @param has which of it there is an option for
void declareJointData(Options& options, Criterion& criterion, const std::function<bool(const JointDatum&)>& has);
/// Refuses what of that counts for nothing that the criterion asks for.
void requireEffect(Options& options, const Criterion& criterion);

/// --tolerance-length and so on, --tolerances.
/// @param wish whose they are @param about what is said of that in their help
void declareTolerances(Options& options, const std::function<ToleranceWish&()>& wish, const std::string& about = "");
/// Their names.
Words toleranceOptions();

/// --keep-in, --keep-out, --zones, --tool-radius.
void declareZones(Options& options, Criterion& criterion);

void declareCriterion(Options& options, Criterion& criterion);
/// The same for one machine, with --psi auto: remarks on the bounds that it chose, and on default ones that do not suit
/// the machine. @pre the machine's options are declared before @param counts whether the question has a criterion at
/// all
void declareCriterion(
    Options& options, Criterion& criterion, MachineOptions& machine,
    const std::function<bool()>& counts = [] { return true; });
/// Their names.
const Words& criterionOptions();

/// --accuracy of a size.
class AccuracyOption
{
public:
  void declare(Options& options, const std::string& help);
  /// What was asked for, or the default for the machine and the shape [m].
  double valueFor(const Machine& machine, const Shape& shape) const
  {
    return accuracy_ ? *accuracy_ : defaultAccuracy(machine, shape);
  }

private:
  std::optional<double> accuracy_;
};

constexpr const char* MULTI_PRECISION_HELP = "goes on in 50 digits where doubles leave something undecided";

constexpr std::int64_t MOST_BOXES = 1000000000000;

/// What --time-limit is without being given: nobody waits for ever who did not ask to [s].
constexpr double TIME_LIMIT = 60.0;

/// --time-limit. Sets the default, too.
void declareTimeLimit(Options& options, double& time_limit);
/// --time-limit, --max-boxes, --max-memory, --threads.
void declareBudget(Options& options, Budget& budget);
/// A file that will be written: one that cannot be is refused before anything is computed.
void declareOutput(Options& options, const std::string& name, std::string& path, const std::string& help);
}  // namespace cli
}  // namespace pkm_workspace
