// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "output.h"
#include "pkm_workspace/import/gcode_job.h"
#include "pkm_workspace/tasks/path.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
/// --gcode and what a job does not say by itself; what is found about its lines. The file is read while its moves are
/// checked, and never held.
class Job
{
public:
  /// @param lists_lines whether there is something to list of its lines
  void declare(Options& options, bool lists_lines);
  bool isGiven() const { return !file_.empty(); }

  /// Makes the task about the job. @param progress is told how far it has come; both have to outlive the task
  void describeTo(PathTask& task, Progress& progress);
  /// After the task: what the job is.
  void addTo(Json& json) const;
  void addRows(std::vector<Words>& rows) const;
  /// After the check of a path: which of its lines offend.
  void addOffencesTo(const Machine& machine, Json& json) const;
  void addOffenceRows(std::vector<Words>& rows) const;
  /// One sentence for each line that offends, and for those that are not listed.
  std::string offences(const Machine& machine) const;
  /// What the message of the path leaves open.
  std::string remark() const;

private:
  using Take = std::function<void(const PathStep&)>;

  void handOver(const Take& take, Progress& progress);
  void handOver(const GcodeMove& move, std::size_t line, const Take& take);
  Interval speedOf(const GcodeMove& move, const PathSegment& segment) const;
  void keep(const SegmentCheck& check);
  std::string place(std::size_t line) const { return file_ + ":" + std::to_string(line); }

  std::string file_;
  GcodeSetup setup_;
  std::optional<double> rapid_feed_;
  std::size_t most_listed_ = 100;

  GcodeSummary summary_;
  std::size_t lines_ = 0;
  std::size_t steps_ = 0;
  std::size_t without_feed_ = 0;  ///< moves
  std::size_t outside_ = 0, undecided_ = 0;
  struct Offence
  {
    Containment verdict;
    PathOffence offence;
  };
  std::vector<Offence> listed_;
};
}  // namespace cli
}  // namespace pkm_workspace
