// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/machine/description.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Writes a machine as a URDF that readUrdf() reads and rviz shows: rails, sliders, the two bars of each parallelogram
/// (side branches on hinges of their own), platform and tool. All frames are parallel to the root's, the link
/// "base_link".
///
/// A machine whose numbers are doubles (the Orthoglide) is read back bit for bit, any other to enclosures that overlap
/// its own: where an enclosure has a width, a double inside it is written.
///
/// URDF wants joint limits. An end that the machine leaves open gets the nearest round number that is not reached: the
/// reachable points lie in the ellipsoid sum |q_i|^2 <= sum L_i^2, which bounds every joint. Where
/// the rails are nearly parallel, nothing bounds them: the limit is then L away from the zero configuration.
/// It wants their speeds and forces, too: of a joint without any, 0 is written, which says that nothing is known.
/// @throws std::invalid_argument when the joints have no names, or one name twice
std::string writeUrdf(const Machine& machine);

/// Writes a machine by its measured numbers, to be read and edited by people: a yaw and a radius lead to each rail, the
/// strut's length and the tool are numbers of their own. The zero is solved: at joint values 0 the machine stands
/// assembled. With a mount the root is the link "world", else "base_link".
/// @throws std::invalid_argument when a number is out of range or the struts do not meet at joint values 0
std::string writeUrdf(const MachineDescription& machine);
}  // namespace pkm_workspace
