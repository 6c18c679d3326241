// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "closure.h"
#include "pkm_workspace/machine/leg.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// The strut of one leg at zero, in the root frame.
IntervalVector strutOf(const Rail& rail, const ClosedLeg& leg);

/// b of the leg at zero, as transmission factors count it [m].
Interval driveAtZero(const Rail& rail, const ClosedLeg& leg);

/// The leg of a machine. @param tool the tool point, seen from where the legs meet [m]
/// @param problems gets what keeps it from being one
Leg machineLeg(const Model& model, const Rail& rail, const ClosedLeg& closed, const IntervalVector& tool,
               Problems& problems);
}  // namespace urdf_io
}  // namespace pkm_workspace
