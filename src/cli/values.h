// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
namespace cli
{
using Words = std::vector<std::string>;

/// What stands between blanks, up to a #.
Words wordsOf(const std::string& line);
/// In quotation marks, with what zero bytes would hide.
std::string quoted(std::string word);

/// What a number on the command line may be.
struct Quantity
{
  std::string unit = "";  ///< "m", "s", ...; empty for a number without unit
  double lower = -std::numeric_limits<double>::infinity();
  bool lower_allowed = true;  ///< whether the number may be equal to lower
  double upper = std::numeric_limits<double>::infinity();

  bool allows(double value) const;
  /// "> 0 m", ">= 0 m", "from 1 to 2 m", "a number [m]": for help texts and for refusals.
  std::string describe() const;
};

const Quantity LENGTH{ "m", -FARTHEST, true, FARTHEST };
const Quantity LENGTH_NOT_NEGATIVE{ "m", 0.0 };
const Quantity LENGTH_POSITIVE{ "m", 0.0, false };
const Quantity NUMBER_POSITIVE{ "", 0.0, false };
const Quantity NUMBER_NOT_NEGATIVE{ "", 0.0 };
const Quantity TIME_NOT_NEGATIVE{ "s", 0.0 };

/// Each of these reads the words of one option. @throws std::invalid_argument with the word and what is allowed
std::vector<double> readNumbers(const Words& words, const Quantity& quantity);
std::int64_t readCount(const std::string& word, std::int64_t upper);
std::string readChoice(const std::string& word, const Words& allowed);
std::string readText(const std::string& word);
Words readTexts(const Words& words);
/// The points of a file, one a line as X Y Z [m]; empty lines and what follows a # are skipped.
std::vector<Eigen::Vector3d> readPoints(const std::string& path);
/// Six numbers X0 X1 Y0 Y1 Z0 Z1 [m] with X0 <= X1 and so on.
Box readBox(const Words& words);
}  // namespace cli
}  // namespace pkm_workspace
