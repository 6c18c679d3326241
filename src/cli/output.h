// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/dexterity/premises.h"
#include "pkm_workspace/machine/machine.h"
#include "pkm_workspace/region/beyond_limits.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/report/definition.h"
#include "values.h"

namespace pkm_workspace
{
namespace cli
{
using Json = nlohmann::json;

/// set, aspect, joint_limits, and each bound that the criterion asks for.
Json toJson(const Criterion& criterion);
/// What every answer says of itself: machine, geometry_hash, version; and the criterion in effect, where there is one.
/// All numbers are in the frame of the machine's root link.
Json contextOf(const Machine& machine);
Json contextOf(const Premises& premises);
Json contextOf(const Machine& machine, const Criterion& criterion);
Json toJson(const Eigen::Vector3d& v);
Json toJson(const Box& box);
/// [lower, upper], null for an end without bound; null for the empty set.
Json toJson(const Interval& interval);
Json toJson(const std::array<Interval, 3>& intervals);
/// The condition, its joint or null, and value, bound and margin in floating point.
Json toJson(const Machine& machine, const Limit& limit);
/// null for an infinity.
Json finite(double value);
/// true for INSIDE, false for OUTSIDE, null for UNDECIDED.
Json toJson(BoxVerdict verdict);

/// One object for each joint: joint; lower, upper, stroke, across as bounds from outside; enclosures of each.
Json toJson(const Machine& machine, const std::array<JointRange, 3>& ranges);

/// Whether its volume is more than 0.
bool isSolid(const Shape& shape);
/// Of a polytope, what the region is with its center: "vertices", times "size".
void addVertices(const Shape& shape, double size, Json& json);
/// "inside", "outside" or "undecided".
std::string name(Containment verdict);
/// "proven", "stopped" or "none".
std::string name(LargestRegion::Status status);
/// One object for each end of the limits that is passed where they are not asked for: joint, limit and by, how far.
Json toJson(const Machine& machine, const std::vector<BeyondLimit>& beyond);
/// The member beyond_limits of an answer without joint limits.
void addLimits(const Machine& machine, const Criterion& criterion, const std::optional<JointReaches>& reaches,
               Json& json);
/// "0.0123 s".
std::string seconds(double value);
/// "(x, y, z) m" with every digit.
std::string describe(const Eigen::Vector3d& v);

/// Writes the file of --output. @throws Failure with the reason
void writeOutput(const std::string& path, const std::string& text);
/// That the URDF of a machine was written, and what to do with it.
std::string wroteMachine(const Machine& machine, const std::string& path);

/// A list as text, made entry by entry so that it need not be held; @p indent is that of the line it begins in.
void writeList(std::size_t count, const std::function<Json(std::size_t)>& entry, int indent, std::ostream& out);
/// The same without a count. @param goes_on whether there is another entry
void writeList(const std::function<bool()>& goes_on, const std::function<Json()>& next, int indent, std::ostream& out);

/// The words of a text in lines of at most 100 columns; nothing of none.
std::string wrapped(const std::string& text);

/// Lines of cells in columns; the first column is aligned to the left, the others as told.
enum class Align
{
  LEFT,
  RIGHT
};
std::string aligned(const std::vector<Words>& rows, Align align);
/// One machine by what its numbers differ in from those that were meant, leg by leg.
Json differencesJson(const Machine& built, const Machine& meant);
}  // namespace cli
}  // namespace pkm_workspace
