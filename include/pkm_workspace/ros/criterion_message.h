// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <pkm_workspace/CriterionRequest.h>
#include <pkm_workspace/Hypotheses.h>

#include <optional>
#include <string>

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/ros/frames.h"

namespace pkm_workspace
{
/// A value of a request; 0 stands for the default.
inline double valueOr(double value, double fallback)
{
  return value == 0.0 ? fallback : value;
}

/// What counts with what is known of the joints: the bounds of a criterion; on a path that is gone along at a speed,
/// the joints' speeds too; or all that a guarantee may be asked for.
enum class JointUse
{
  BOUNDS,
  SPEEDS_TOO,
  ALL
};

/// Reads a criterion.
/// @param machine that bounds are chosen for, where the request asks for that
/// @param defaults what fields without a value stand for; where there is a problem, all but set and aspect
/// @param problems gets one sentence for each value that is unknown, out of range or without effect
Criterion fromMessage(const CriterionRequest& request, const Machine& machine, const Criterion& defaults,
                      Problems& problems, JointUse use = JointUse::BOUNDS);

/// The machine with what a request says of it, ball axes and tolerances, in place of its own; nothing where it says
/// none of that. @throws std::invalid_argument for what no machine has
std::optional<Machine> machineOf(const CriterionRequest& request, const Machine& own);
/// @throws std::invalid_argument where a request gives ball axes that cannot have them, with what is to be done
void requireNoBallAxes(const CriterionRequest& request, const std::string& remedy);
/// The same of tolerances.
void requireNoTolerances(const CriterionRequest& request, const std::string& remedy);

/// Takes what a criterion has from the URDF of one machine's joints out again, so that each of several machines counts
/// with its own. @param given by the node's parameters; what they or the request give stays
void leaveJointsToEach(const CriterionRequest& request, const Machine& machine, const Criterion& given,
                       Criterion& criterion);

/// The box between two corners, or none. @param flag name of the field that @p given comes from
/// @param problems gets one sentence for each corner that is out of range or without effect
std::optional<Box> readCorners(bool given, const geometry_msgs::Point& min_corner,
                               const geometry_msgs::Point& max_corner, const std::string& flag, Problems& problems);

/// The time limit of a request [s]; 0 stands for the node's. @param longest that may be asked for, at least the node's
/// @param problems gets one sentence for what is out of range
double timeLimitOf(double requested, double node, double longest, Problems& problems);

/// @param aspect OWN = 1, OTHER = 2 or BOTH = 3, as all messages number them, or 0 for the fallback
/// @param problems gets one sentence for another number
Criterion::Aspect aspectOf(std::uint8_t aspect, Criterion::Aspect fallback, Problems& problems);

/// What a result holds for. @param accuracy as Hypotheses.msg has it
Hypotheses toMessage(const Premises& premises, double accuracy);
/// What the hypotheses say, their criterion canonical.
Premises fromMessage(const Hypotheses& hypotheses);
/// What a picture holds for, in two short lines: machine and geometry, version, criterion, accuracy.
/// @param precision what the accuracy [m] is called; empty: it is not told
std::string captionOf(const Premises& premises, const std::string& precision, double accuracy);
}  // namespace pkm_workspace
