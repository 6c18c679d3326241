// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/import/gcode_job.h"

namespace pkm_workspace
{
/// A job for LinuxCNC's interpreter, the program rs274.
struct Rs274Job
{
  std::string name;                                  ///< of what its lines are of
  std::function<void(const LineTaker& take)> lines;  ///< hands them out
  GcodeSetup setup;                                  ///< what it does not say by itself
  std::function<bool()> is_over;                     ///< asked now and then: whether to give up
  std::function<std::string()> ended_by;             ///< what has made it give up
};

/// Has the program interpret the job, and hands out what it prints: calls of canonical machining functions, for
/// canonicalMoves().
/// @return how many lines the job has
/// @throws std::invalid_argument with the line and the program's reason where it refuses the job, where it is missing
/// or where it was given up, and what the lines and @p take throw
std::size_t interpretByRs274(const Rs274Job& job, const LineTaker& take);

/// Reads these calls as the moves that they stand for. A call that may move the tool, or change how it moves, and is
/// not among those that are read is refused.
std::unique_ptr<MoveReader> canonicalMoves(const GcodeSetup& setup);
}  // namespace pkm_workspace
