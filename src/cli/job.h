// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "output.h"
#include "pkm_workspace/tasks/job.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
/// Who reads the words of a job.
enum class Interpreter
{
  OWN,
  RS274
};
constexpr std::array<const char*, 2> INTERPRETERS = { "own", "rs274" };  // as Interpreter

/// --gcode and what a job does not say by itself; what is found about its lines. The file is read while its moves are
/// checked, and never held.
class JobOption
{
public:
  /// @param lists_lines whether there is something to list of its lines
  void declare(Options& options, bool lists_lines);
  bool isGiven() const { return !job_.name.empty(); }

  /// What ends an interpreter that runs beside the command.
  struct End
  {
    std::function<bool()> is_over;
    std::function<std::string()> ended_by;
  };
  /// Makes the task about the job. @param progress is told how far it has come; both have to outlive the task
  void describeTo(PathTask& task, Progress& progress, const End& end);
  /// After the task: what the job is.
  void addTo(Json& json) const;
  void addRows(std::vector<Words>& rows) const;
  /// After the check of a path: which of its lines offend.
  void addOffencesTo(const Machine& machine, Json& json) const;
  void addOffenceRows(std::vector<Words>& rows) const;
  /// One sentence for each line that offends, and for those that are not listed.
  std::string offences(const Machine& machine) const;
  std::string remark() const { return job_.remark(); }

private:
  void declareSetup(Options& options);

  JobTask job_;
  Interpreter interpreter_ = Interpreter::OWN;
};
}  // namespace cli
}  // namespace pkm_workspace
