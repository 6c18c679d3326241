// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "element.h"
#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/tolerances.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The element of <robot> that other readers pass over: <pkm_tolerances tolerance_length="0.0001"/> of all legs, with
/// joint="NAME" of one leg, in place of the former.
constexpr const char* TOLERANCES = "pkm_tolerances";

struct ToleranceElement
{
  int line;
  std::string joint;  ///< empty: of all legs
  std::vector<std::pair<const ToleranceKind*, std::vector<double>>> kinds;
};

/// Those of the text. @param problems gets a sentence for each that says what is not understood
std::vector<ToleranceElement> toleranceElements(const XMLElement& robot, Problems& problems);

/// What they say of these rails. @param problems gets a sentence for each that is about another joint
Tolerances tolerancesOf(const std::vector<ToleranceElement>& elements, const std::array<std::string, 3>& rails,
                        Problems& problems);

/// Their attributes as they are written: one element for all legs where these are alike, else one for each; none where
/// all are zero.
std::vector<std::vector<std::pair<const char*, std::string>>> toleranceAttributes(
    const Tolerances& tolerances, const std::array<std::string, 3>& rails);
}  // namespace urdf_io
}  // namespace pkm_workspace
