// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
/// Collects what is wrong with a user's values; each entry is one sentence with value, unit, range and place.
using Problems = std::vector<std::string>;

/// Appends the sentence that the parts make, written one after the other.
template <class... Parts>
void complain(Problems& problems, const Parts&... parts)
{
  TextStream text;
  (text << ... << parts);
  problems.push_back(text.str());
}

/// Throws all problems as one std::invalid_argument, one a line; does nothing when there are none.
/// @param heading a line of its own above them, which are then indented; none where it is empty
void throwProblems(const Problems& problems, const std::string& heading = "");

/// Appends one sentence when a box of the user's is not finite or not in order; @p name says which box.
void validateBox(const char* name, const Box& box, Problems& problems);
/// Appends one sentence unless the value is positive and finite.
void validatePositive(const char* name, double value, const char* unit, Problems& problems);
/// Appends one sentence unless the value is from 1e-15 to 1.
void validateShare(const char* name, double value, const char* unit, Problems& problems);

/// @return the value itself @throws std::invalid_argument with everything that its validate() finds
template <class Values>
const Values& validated(const Values& values)
{
  Problems problems;
  values.validate(problems);
  throwProblems(problems);
  return values;
}
}  // namespace pkm_workspace
