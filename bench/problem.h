// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/region/largest_region.h"

namespace pkm_workspace
{
namespace bench
{
/// A largest region to look for, psi in [0.5, 2].
struct Problem
{
  std::string name;
  Machine machine;
  bool is_square;  ///< parallel to the plane xy; otherwise a cube
  Box centers;     ///< for the ways that need to be told where centers may be [m]
};

Problem orthoglideCube();
Problem uranesxSquare();

/// Our own way, on one thread. @return when proved, or after ten seconds
LargestRegion findByOurWay(const Machine& machine, bool is_square, double accuracy,
                           const Criterion& criterion = Criterion());

/// The box tests that the paper's algorithm is given, with the names of the ways.
std::vector<std::pair<std::string, BoxClassifier>> paperTests(const Machine& machine);
}  // namespace bench
}  // namespace pkm_workspace
