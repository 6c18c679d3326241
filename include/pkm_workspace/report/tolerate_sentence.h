// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/region/tolerable_factor.h"

namespace pkm_workspace
{
/// What is proved about the factor, where the region fails beyond it, and which machine does.
std::string describe(const TolerableFactor& found, const Machine& machine, const FactorQuery& query);

/// What a leg of one machine differs in from what was meant.
struct LegDifference
{
  std::string joint;
  Eigen::Vector3d slider;    ///< of the strut's end there [m]
  Eigen::Vector3d platform;  ///< [m]
  double length;             ///< of the strut [m]
  double angle;              ///< of the rail [rad]
  Eigen::Vector3d axis;      ///< where the rail runs instead
  double zero;               ///< of the joint [m]; 0 where the joint has no limits that tell
};
std::vector<LegDifference> differences(const Machine& built, const Machine& meant);

/// One machine by what it differs in from what was meant, leg by leg: "rail_x: slider off by (..) m, strut 0.1 m".
std::vector<std::string> differencesInWords(const Machine& built, const Machine& meant);
}  // namespace pkm_workspace
