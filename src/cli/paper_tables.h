// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "comparison.h"

namespace pkm_workspace
{
namespace cli
{
/// One figure of the paper beside ours.
struct PaperRow
{
  std::string place;  ///< "table 2", "section 4.3"
  std::string what;
  std::string paper;          ///< as printed
  std::string ours;           ///< its bracket, or what is proved
  Interval bracket;           ///< as numbers, where it has one
  std::optional<bool> holds;  ///< within one unit of the last digit that is printed; nothing where that is open
};

/// Sections 4.3 and 4.4 of the paper, tables 1 to 4, computed anew.
/// @param accuracy of sizes [m] @param budget its time limit is shared evenly by all regions and studies
std::vector<PaperRow> paperRows(double accuracy, const Budget& budget, const Tell& tell);
}  // namespace cli
}  // namespace pkm_workspace
