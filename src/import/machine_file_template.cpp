// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/import/machine_file.h"

namespace pkm_workspace
{
namespace
{
const char* const HEAD =
    R"(# A machine with three legs that do not let its platform turn: fill in what you measured, then
#   pkm urdf --from FILE --output machine.urdf
# Angles are degrees, lengths the unit below. What begins with "# " may be left out.
# Legs may be of other kinds, and mixed: kind is rail, telescope or crank; pkm urdf --template --kind KIND shows what
# each is made of.
name: my_machine
unit: m                      # m or mm

# What the three legs share. Each leg has axes of its own: outwards, sideways (counter-clockwise), up.
all_legs:
)";

const char* const RAILS = R"(  # kind: rail               # a strut of fixed length on a slider
  rail_radius: 0.130         # from the middle of the machine to the strut's joint on the slider
  platform_radius: 0.030     # from the middle of the platform to the strut's other joint
  travel: [0, 0.35]          # joint values that the slider can take
  # home: 0.35               # joint value of the slider when the machine is homed; without it 0
  # home_height: 0.65        # height of the slider then; without it the tool touches z = 0 at the lower ends
  # lean: [0, 0]             # of the rail from the vertical: outwards, sideways
  # slider_joint: [0, 0, 0]  # of the strut, seen from the rail at rail_radius: outwards, sideways, up
  # platform_joint: [0, 0, 0]  # of the strut, seen from its place on the circle of platform_radius
  # joint_speed_max: 0.5     # largest speed of the slider [m/s]; without it none is known
  # joint_effort_max: 100    # largest force on the slider [N]; without it none is known
  # working_mode: -1         # -1: the strut hangs below its slider, 1: it stands on it
)";

const char* const TELESCOPES = R"(  kind: telescope            # a strut of variable length
  base_radius: 0.500         # from the middle of the machine to the foot, about which the strut turns
  # base_height: 0           # height of the foot; without it 0
  platform_radius: 0.100     # from the middle of the platform to the strut's other joint
  travel: [-0.3, 0.3]        # joint values: by how much the strut can be longer than at joint value 0
  # platform_joint: [0, 0, 0]  # of the strut, seen from its place on the circle of platform_radius
  # joint_speed_max: 0.5     # largest speed of the strut's growth [m/s]; without it none is known
  # joint_effort_max: 1500   # largest force along the strut [N]; without it none is known
)";

const char* const CRANKS = R"(  kind: crank                # a forearm at the end of a crank
  base_radius: 0.164         # from the middle of the machine to the crank's axis
  # base_height: 0           # height of the axis; without it 0
  crank: 0.524               # from the axis to the forearm's joint
  # crank_zero: 0            # how far the crank points down from level at joint value 0
  # turn: 1                  # 1: larger joint values turn it further down, -1: up
  # axis_lean: 0             # how far the axis rises, counter-clockwise around the machine
  platform_radius: 0.044     # from the middle of the platform to the forearm's other joint
  travel: [-35, 85]          # joint values that the crank can take, in degrees
  # platform_joint: [0, 0, 0]  # of the forearm, seen from its place on the circle of platform_radius
  # joint_speed_max: 10      # largest speed of the crank [rad/s]; without it none is known
  # joint_effort_max: 200    # largest torque on the crank [N m]; without it none is known
  # working_mode: -1         # -1: the forearm hangs below its crank, 1: it stands on it
)";

/// @param what is measured, with its three lengths @param joint a name
std::string legs(const std::string& what, const char* const (&lengths)[3], const std::string& joint)
{
  const std::string place = "    # joint: " + joint + R"(
    # x: 0.5                 # its place, in place of a radius; with it no angle is needed
    # y: 0
)";
  return R"(
# What each has of its own; every key of all_legs may stand here, too.
legs:
  - angle: 0                 # where the leg stands around the machine, counter-clockwise from x
    length: )" +
         std::string(lengths[0]) + what + place + "  - angle: 120.4\n    length: " + lengths[1] +
         "\n  - angle: 239.7\n    length: " + lengths[2] + "\n";
}

const char* const MOUNT = R"(mount: [0, 0, 0.75]          # where the machine stands in the frame "world"
mount_rpy: [0, 0, 15]        # and how it is turned there: roll, pitch, yaw
)";
}  // namespace

std::string machineFileTemplate(LegDescription::Kind kind)
{
  const std::string tool = "\ntool: [0, 0, -0.040]         # the tool point, seen from the middle of the platform\n";
  const std::string side =
      R"(# assembly: lower            # upper: the platform is above rails that lie, where both are possible
)";
  if (kind == LegDescription::Kind::TELESCOPE)
    return std::string(HEAD) + TELESCOPES +
           legs("           # of the strut at joint value 0, from joint to joint\n", { "0.8000", "0.8004", "0.7995" },
                "strut_1         # name of the joint that lengthens it") +
           "\ntool: [0, 0, 0.100]          # the tool point, seen from the middle of the platform\n"
           "assembly: upper              # the platform is above the feet; lower: it hangs below\n" +
           "mount: [0, 0, 0]             # where the machine stands in the frame \"world\"\n"
           "mount_rpy: [0, 0, 15]        # and how it is turned there: roll, pitch, yaw\n";
  if (kind == LegDescription::Kind::CRANK)
    return std::string(HEAD) + CRANKS +
           legs("           # of the forearm, from joint to joint\n", { "1.2440", "1.2437", "1.2442" },
                "crank_1         # name of the crank's joint") +
           tool + MOUNT;
  return std::string(HEAD) + RAILS +
         legs("           # of the strut, from joint to joint\n", { "0.2690", "0.2688", "0.2691" },
              "rail_1          # name of the rail's joint") +
         tool + side + MOUNT;
}
}  // namespace pkm_workspace
