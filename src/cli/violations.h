// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
/// What of the criterion a point violates, one phrase each with the value and its bound, for people: in floating point.
/// Empty for a good point, and for a bad one that only exact arithmetic tells from a good one.
Words violations(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p);
}  // namespace cli
}  // namespace pkm_workspace
