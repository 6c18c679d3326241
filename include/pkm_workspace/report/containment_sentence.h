// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/region/containment.h"

namespace pkm_workspace
{
/// Says what is proved about the region c + K(h), why no more is, and what it means for joint limits that were not
/// asked for. The region is called by the name of its shape, and what is told as a bad point elsewhere, "the bad
/// point".
/// @param evaluator of the machine and the criterion that the result is about
/// @param budget that the proof was given
std::string describe(const ContainmentResult& result, const PointEvaluator& evaluator, const Shape& shape,
                     const Eigen::Vector3d& center, double size, const Budget& budget);
}  // namespace pkm_workspace
