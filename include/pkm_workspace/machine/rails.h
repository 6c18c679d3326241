// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>

#include "pkm_workspace/machine/leg.h"

namespace pkm_workspace
{
// Which rails of a machine share a direction. Legs that do not slide share none.

/// 1 where two rails are known to have the same direction, -1 for the opposite one, otherwise 0: their numbers say so,
/// or both axes are exact. Enclosures that are the same are no reason.
int parallelSense(const Leg& a, const Leg& b);

/// Numbers for SlidingStrut::direction. @param sense what parallelSense() is to be for legs i and j < i
std::array<int, 3> sharedDirections(const std::function<int(std::size_t i, std::size_t j)>& sense);
/// The same for legs that are to keep the directions that these share, when they are turned all together.
std::array<int, 3> sharedDirections(const std::array<Leg, 3>& legs);
/// Gives the rails these numbers.
void setDirections(std::array<Leg, 3>& legs, const std::array<int, 3>& numbers);

/// What the numbers of the axes do not tell: which rails are parallel that do not look so, or are not that do; "" for
/// none.
std::string directionsText(const std::array<Leg, 3>& legs);

/// Legs that share a direction get what their enclosures of it have in common.
void uniteAxes(std::array<Leg, 3>& legs, Problems& problems);
}  // namespace pkm_workspace
