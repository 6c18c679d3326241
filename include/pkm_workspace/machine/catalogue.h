// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// The Orthoglide (paper, section 3.1): rails along x, y and z that meet at the origin, a_i = -L e_i, b_i = 0.
/// Zero configuration: the isotropic one, tool point at the origin.
/// @param length strut length L [m], from 1e-9 to 1e9 @throws std::invalid_argument otherwise
Machine orthoglide(double length = 1.0);

/// The Orthoglide built in Nantes: L = 0.31058 m, for a cube of 0.2 m around the center of the largest one. The joint
/// limits are what that cube needs, to the next tenth of a millimetre: about 0.257 m of travel.
Machine orthoglidePrototype();

/// The UraneSX (paper, section 3.1): rails along z at 0 and +-120 degrees on a circle of radius R, platform points on a
/// circle of radius r; only R - r matters. Sliders above the tool: the struts point down the rails' axis, s = -1.
/// Zero configuration: sliders in the plane z = 0, tool point on the axis below them.
/// @param rail_radius R [m], a double or an enclosure (R = 7/13 + lambda in the paper)
/// @param platform_radius r [m] @param length strut length L [m], from 1e-9 to 1e9
/// @throws std::invalid_argument also unless 0 < R - r < L, or when a radius is larger than 1e9 m
Machine uranesx(const Interval& rail_radius, const Interval& platform_radius, double length = 1.0);

/// What a Delta measures [m], doubles or enclosures: its cranks turn about axes that are tangents of a circle, and its
/// forearms end on one of the platform.
struct DeltaDimensions
{
  Interval base_radius = 0.164;          ///< of the circle that the cranks' axes touch
  Interval crank = 0.524;                ///< r: from its axis to the forearm
  Interval forearm = 1.244;              ///< L
  Interval platform_radius = 0.044;      ///< of the circle of the forearms' lower ends
  Interval limits = Interval::entire();  ///< of the joints [rad]; none: they turn all around
};

/// Joint limits of a Delta where nothing else is said: chosen, not measured [rad].
const Interval DELTA_TRAVEL{ -0.6, 1.5 };

/// A rotary Delta (R. Clavel), hanging: cranks at 0 and +-120 degrees, level and outward at joint value 0, which turns
/// them downward; the platform below. The defaults are those of an ABB FlexPicker IRB 360-1/1600 as R. L. Williams II
/// has them ("The Delta Parallel Robot: Kinematics Solutions", Ohio University, 2016: w_B, L, l, u_P).
/// @throws std::invalid_argument where a number is not from 1e-9 m to 1e9 m, or the forearms do not reach at zero
Machine delta(const DeltaDimensions& dimensions = {});

/// What a tripod of struts of variable length measures [m], doubles or enclosures.
struct TripodDimensions
{
  Interval base_radius = 0.5;      ///< of the circle of the feet, in the plane z = 0
  Interval platform_radius = 0.1;  ///< of the circle of the struts' upper ends
  Interval length = 0.8;           ///< of the struts at joint value 0
  Interval limits{ -0.3, 0.3 };    ///< of the joints
};

/// A tripod with feet at 0 and +-120 degrees, standing: its platform is kept from turning, and above.
/// @throws std::invalid_argument where a number is not from 1e-9 m to 1e9 m, or the struts do not reach at zero
Machine tripod(const TripodDimensions& dimensions = {});

/// One leg of each kind, on paper only: a slider along x, a strut of variable length along y, and a crank of 0.5 m
/// whose forearm stands along z. All struts are 1 m long and meet at the origin, isotropic there but for the units.
Machine mixedLegs();

/// R = 7/13 and r = 3/26 for L = 1, the dimensions of the paper's section 4.3.
Machine uranesx();
}  // namespace pkm_workspace
