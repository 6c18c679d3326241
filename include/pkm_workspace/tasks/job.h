// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/import/gcode_job.h"
#include "pkm_workspace/tasks/path.h"

namespace pkm_workspace
{
/// Names of the work offsets, in the order of GcodeSetup::work_offsets.
constexpr std::array<const char*, GcodeSetup::SYSTEMS> WORK_OFFSETS = { "G54", "G55",   "G56",   "G57",  "G58",
                                                                        "G59", "G59.1", "G59.2", "G59.3" };
/// How far from zero places and lengths of a job's setup may be [m].
constexpr double FARTHEST_SETUP = 1000.0;

/// A job of G-code as a path whose segments have speeds: read line by line while its moves are checked, and never held.
class JobTask
{
public:
  // What is set before describeTo().
  std::string name;                                                    ///< of what its lines are of
  std::function<void(const LineTaker& take)> read_lines;               ///< hands out its lines
  GcodeSetup setup;                                                    ///< what it does not say by itself
  bool is_for_rs274 = false;                                           ///< LinuxCNC's interpreter reads it
  std::function<bool()> is_over;                                       ///< asked while that runs: whether to give up
  std::function<std::string()> ended_by;                               ///< what makes it give up
  std::optional<double> rapid_feed;                                    ///< speed of G0 [m/s]
  std::size_t most_listed = 100;                                       ///< lines that are listed
  std::function<void(std::size_t lines, std::size_t offending)> tell;  ///< now and then, if any

  /// What is said to help: how the asker gives where the tool is, and the speed of G0.
  struct Remedies
  {
    std::string tool_at;
    std::string rapid_feed;
  };
  Remedies remedies;

  /// A line along whose move not all is proved to be good.
  struct Offence
  {
    Containment verdict;
    PathOffence offence;  ///< its segment is the line, from 1 on
  };
  /// What is known of it after the task.
  struct Findings
  {
    GcodeSummary summary;
    std::size_t lines = 0;
    std::size_t steps = 0;
    std::size_t without_feed = 0;  ///< moves
    std::size_t outside = 0, undecided = 0;
    std::vector<Offence> listed;

    std::size_t offending() const { return outside + undecided; }
  };

  /// Makes the task about the job, which has to outlive it. The task throws std::invalid_argument with each line that
  /// is refused, up to a hundred problems.
  void describeTo(PathTask& task);
  const Findings& findings() const { return found_; }
  /// What the message of the path leaves open.
  std::string remark() const;
  /// "job.ngc:3"
  std::string place(std::size_t line) const { return name + ":" + std::to_string(line); }

private:
  using Take = std::function<void(const PathStep&)>;

  void handOver(const Take& take);
  /// @return how many lines the job has
  std::size_t readAll(const LineTaker& read) const;
  void handOver(const GcodeMove& move, std::size_t line, const Take& take);
  Interval speedOf(const GcodeMove& move, const PathSegment& segment) const;
  void keep(const SegmentCheck& check);

  Findings found_;
};
}  // namespace pkm_workspace
