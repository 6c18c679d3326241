// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_draft.h"

namespace pkm_workspace
{
namespace
{
using Kind = DraftKey::Kind;
constexpr unsigned RAIL = DraftKey::RAIL, CRANK = DraftKey::CRANK, FIXED = DraftKey::TELESCOPE | CRANK;

const std::vector<DraftKey> LEG_KEYS = {
  { "kind", Kind::WORD, 1, "rail|telescope|crank",
    "rail: a strut of fixed length on a slider; telescope: a strut of variable length; crank: a forearm on a crank; "
    "without it, rail" },
  { "joint", Kind::NAME, 1, "NAME",
    "name of the joint that a motor moves; without it, rail_1, strut_1 or crank_1, and so on" },
  { "angle", Kind::ANGLE, 1, "ANGLE",
    "where the leg stands around the machine, counter-clockwise from x; without it, 0, 120 and 240 degrees" },
  { "rail_radius", Kind::LENGTH, 1, "R",
    "from the middle of the machine to the strut's joint on the slider at home, or to the rail with --slider-joint",
    RAIL },
  { "base_radius", Kind::LENGTH, 1, "R",
    "from the middle of the machine to the crank's axis, or to the foot of a strut of variable length", FIXED },
  { "x", Kind::LENGTH, 1, "X", "place of rail, crank or foot, with y, in place of a radius" },
  { "y", Kind::LENGTH, 1, "Y", "place of rail, crank or foot, with x, in place of a radius" },
  { "base_height", Kind::LENGTH, 1, "Z", "height of the crank's axis or of the foot; without it, 0", FIXED },
  { "lean", Kind::ANGLE, 2, "OUT SIDE",
    "how far the rail leans from the vertical: outwards first, then counter-clockwise; without it, 0 0", RAIL },
  { "length", Kind::LENGTH, 1, "L",
    "of the strut or forearm, from joint to joint; of a strut of variable length at joint value 0" },
  { "crank", Kind::LENGTH, 1, "r", "of the crank, from its axis to the forearm's joint", CRANK },
  { "crank_zero", Kind::ANGLE, 1, "ANGLE", "how far the crank points down from level at joint value 0; without it, 0",
    CRANK },
  { "turn", Kind::SIGN, 1, "-1|1",
    "1: larger joint values turn the crank down from level and outwards, -1: up; without it, 1", CRANK },
  { "axis_lean", Kind::ANGLE, 1, "ANGLE",
    "how far the crank's axis rises, counter-clockwise around the machine; without it, 0", CRANK },
  { "platform_radius", Kind::LENGTH, 1, "r",
    "from the middle of the platform to the strut's joint; without it 0: R is then the difference of the radii" },
  { "slider_joint", Kind::LENGTH, 3, "OUT SIDE UP",
    "the strut's joint, seen from the slider's place on its rail; without it, 0 0 0", RAIL },
  { "platform_joint", Kind::LENGTH, 3, "OUT SIDE UP",
    "the strut's joint, seen from its place on the platform's circle; without it, 0 0 0" },
  { "travel", Kind::JOINT, 2, "LO HI", "joint values that slider, strut or crank can take" },
  { "home", Kind::LENGTH, 1, "Q",
    "joint value of the slider when the machine is homed, with home_height; without it, 0", RAIL },
  { "home_height", Kind::LENGTH, 1, "Z",
    "height of the slider then; without it, the tool touches z = 0 with all sliders at the lower end", RAIL },
  { "joint_speed_max", Kind::SPEED, 1, "V", "largest speed of its joint; without it, none is known" },
  { "joint_effort_max", Kind::FORCE, 1, "F", "largest force or torque on it; without it, none is known" },
  { "working_mode", Kind::SIGN, 1, "-1|1",
    "-1: the strut hangs below its slider or crank, 1: it stands on it; without it, -1", RAIL | CRANK },
};
}  // namespace

const std::array<const char*, 3> LEG_KINDS = { "rail", "telescope", "crank" };

const std::vector<DraftKey>& legKeys()
{
  return LEG_KEYS;
}

const std::vector<DraftKey>& machineKeys()
{
  static const std::vector<DraftKey> keys = {
    { "tool", Kind::LENGTH, 3, "X Y Z", "the tool point, seen from the middle of the platform; without it, 0 0 0" },
    { "assembly", Kind::WORD, 1, "lower|upper",
      "where the platform is when the struts can meet on both sides (rails that lie, struts of variable length); "
      "without it, lower" },
    { "mount", Kind::LENGTH, 3, "X Y Z", "where the machine stands in a frame \"world\"; without it, there is none" },
    { "mount_rpy", Kind::ANGLE, 3, "ROLL PITCH YAW", "how it is turned there; without it, 0 0 0" },
  };
  return keys;
}
}  // namespace pkm_workspace
