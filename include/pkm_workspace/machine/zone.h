// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/common/problems.h"
#include "pkm_workspace/machine/frame.h"

namespace pkm_workspace
{
/// A body that the tool has to stay within, or out of (docs/conditions.md). Keeping in counts its surface as within,
/// keeping out as outside.
struct Zone
{
  enum class Use
  {
    KEEP_IN,
    KEEP_OUT
  };
  enum class Kind
  {
    BOX,        ///< of these sides about the origin of its pose
    CYLINDER,   ///< about the z axis of its pose, half of its height above and half below the origin
    SPHERE,     ///< about the origin of its pose
    HALF_SPACE  ///< what lies beyond the origin of its pose in the direction of the normal
  };

  Use use = Use::KEEP_OUT;
  Kind kind = Kind::BOX;
  std::string name;                                   ///< for people; may be empty
  Pose pose;                                          ///< where the body stands
  Eigen::Vector3d sides = Eigen::Vector3d::Zero();    ///< of a box, > 0 [m]
  double radius = 0.0;                                ///< of a cylinder or sphere, > 0 [m]
  double height = 0.0;                                ///< of a cylinder, > 0 [m]; infinite where it has no ends
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of a half-space, into it, along the axes of its pose; not 0
  /// Whether all this is given in the frame of the machine's root link, and not in that of the answer.
  bool in_root = false;
  Pose frame;  ///< where the frame in which it is given stands in the frame of the answer
  /// How a proof sees the frame of the answer, where that looks from elsewhere; no part of what is asked.
  std::optional<EnclosedMotion> view;
};

using ZoneKind = Zone::Kind;

/// The names of uses and kinds in options, files, parameters and JSON, in the order of the enumerations.
inline constexpr std::array<const char*, 2> ZONE_USES = { "keep_in", "keep_out" };
inline constexpr std::array<const char*, 4> ZONE_KINDS = { "box", "cylinder", "sphere", "half_space" };

/// A criterion has so many at the most.
constexpr std::size_t MOST_ZONES = 32;

/// Whether the zone is given in another frame than that of the answer.
bool isElsewhere(const Zone& zone);

/// "box 'column' with center (0, 0, 0.1) m and sides (0.2, 0.2, 0.2) m".
std::string describe(const Zone& zone);

/// The same in few words: its name, or its kind and place.
std::string title(const Zone& zone);

/// Appends one sentence for each thing that is wrong: too many zones, numbers out of range, a radius that leaves
/// nothing of a zone to keep in.
/// @param tool_radius [m]
void validateZones(const std::vector<Zone>& zones, double tool_radius, Problems& problems);

/// Appends a sentence where a radius counts for no zone.
void requireEffect(double tool_radius, const std::vector<Zone>& zones, Problems& problems);

/// All zones of the kinds of use that there are, in words: ", tool kept in ..., out of ..., with a radius of 0.01 m".
std::string zonesInWords(const std::vector<Zone>& zones, double tool_radius);

/// Adds zones that are the collision geometry of a machine's surroundings; appends a sentence for each phrase of what
/// is no zone, or where there is nothing. @param switched_on what asks for it
void addCollisions(const std::vector<Zone>& collisions, const std::vector<std::string>& open,
                   const std::string& switched_on, std::vector<Zone>& zones, Problems& problems);

/// How many there are, for pictures: ", tool within 1 zone and out of 3 zones, tool radius 0.01 m".
std::string zonesInShort(const std::vector<Zone>& zones, double tool_radius);

/// Zones that are given in the frame of the root link, seen from another frame. @param root the root link there
std::vector<Zone> seenFrom(const Pose& root, std::vector<Zone> zones);
}  // namespace pkm_workspace
