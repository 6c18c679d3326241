// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
/// What answers are hunted about: a machine, and what is asked of its points.
struct Subject
{
  Machine machine;
  Criterion criterion;
};

/// Draws a machine of any kind, in any frame, with limits or without, and bounds that its zero configuration keeps,
/// mostly. Nothing where the numbers drawn make no machine.
std::optional<Subject> drawnSubject(Random& random);

/// What is asked, as options of the command and in words.
std::string inWords(const Criterion& criterion);
}  // namespace test
}  // namespace pkm_workspace
