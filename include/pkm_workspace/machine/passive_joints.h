// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
/// A stop of a passive hinge: the hinge is within its limit where n . direction >= least, for the strut's vector n.
struct StrutStop
{
  std::string joint;         ///< name of the hinge
  bool is_upper;             ///< whether the limit is the upper one
  double limit;              ///< [rad]
  IntervalVector direction;  ///< without unit
  Interval least;            ///< [m]
};

/// What is known of the joints that no motor drives: part of a leg of any kind.
struct PassiveJoints
{
  std::vector<StrutStop> stops = {};          ///< of its hinges
  std::vector<std::string> open_hinges = {};  ///< why a limit of a hinge is no such stop, one sentence each
  /// Along the strut, from its driven end to the platform, where its ball joints are not tilted, of any length > 0;
  /// empty: as at zero.
  std::vector<IntervalVector> ball_axes = {};
};

/// Its numbers, digit by digit: "" where there are none.
std::string exactText(const PassiveJoints& joints);
/// The same where vectors are turned.
void turn(const IntervalMatrix& rotation, PassiveJoints& joints);
/// Those of a leg between two others: hinges that differ count as unknown.
PassiveJoints between(const PassiveJoints& first, const PassiveJoints& last);
/// Why no leg is between two with these; "" where there is one.
std::string differenceOf(const PassiveJoints& first, const PassiveJoints& last);
}  // namespace pkm_workspace
