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

/// R = 7/13 and r = 3/26 for L = 1, the dimensions of the paper's section 4.3.
Machine uranesx();
}  // namespace pkm_workspace
