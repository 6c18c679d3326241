// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "command.h"
#include "mesh_options.h"
#include "pkm_workspace/tasks/paving.h"

namespace pkm_workspace
{
namespace cli
{
/// What there is to say of pavings.
struct Paved
{
  /// Of the set in both aspects where that was asked for, then in the machine's own aspect and in the other one.
  std::vector<PavingReport> reports;
  std::size_t asked = 0;  ///< which of them was asked for; it tells what ended one of them early
  MeshOptions mesh;
  std::int64_t most_listed = 0;  ///< boxes that are listed in the JSON object
};

/// What pkm pave says; what is long refers to @p paved.
Answer answerOf(const Machine& machine, const Paved& paved);
}  // namespace cli
}  // namespace pkm_workspace
