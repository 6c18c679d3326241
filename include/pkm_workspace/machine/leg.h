// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "pkm_workspace/machine/crank.h"
#include "pkm_workspace/machine/sliding_strut.h"
#include "pkm_workspace/machine/telescopic_strut.h"

namespace pkm_workspace
{
// The kinds of legs there are: a row here and one in leg_forms.h, and the files that sliding_strut.h, .cpp and
// sliding_strut_forms.h show.

/// What a leg is made of, and the same prepared for its formulas in intervals, with a member `center`: the c of p - c.
using LegKind = std::variant<SlidingStrut, TelescopicStrut, Crank>;
using EnclosedLeg = std::variant<EnclosedStrut, EnclosedTelescope, EnclosedCrank>;

/// One leg: its joint, and what carries the platform.
struct Leg
{
  std::string joint = "";                ///< name of the actuated joint
  Interval limits = Interval::entire();  ///< values that it may take [m]
  LegKind kind = SlidingStrut();
  double speed = INF;   ///< the largest |qdot| that its motor is known to reach [m/s]; INF where none is known
  double effort = INF;  ///< the largest force of its motor [N]; INF where none is known
};

/// Calls the function with the leg as what it is. As std::visit(), whose exception must not be compiled for one
/// instruction set and kept by the linker for all.
template <std::size_t I = 0, class Function, class... Kinds>
inline decltype(auto) visitLeg(const Function& function, const std::variant<Kinds...>& leg)
{
  if constexpr (I + 1 < sizeof...(Kinds))
    if (leg.index() != I)
      return visitLeg<I + 1>(function, leg);
  return function(*std::get_if<I>(&leg));
}

// What every kind tells of a leg: see sliding_strut.h.

inline Interval lengthOf(const EnclosedLeg& leg)
{
  return visitLeg([](const auto& kind) { return lengthOf(kind); }, leg);
}
inline OuterBound outerBound(const EnclosedLeg& leg, const std::optional<Interval>& steepest)
{
  return visitLeg([&](const auto& kind) { return outerBound(kind, steepest); }, leg);
}
inline Interval driveRange(const EnclosedLeg& leg, const std::optional<Interval>& steepest)
{
  return visitLeg([&](const auto& kind) { return driveRange(kind, steepest); }, leg);
}
inline IntervalVector pointsWithin(const EnclosedLeg& leg, const Interval& joints,
                                   const std::optional<Interval>& steepest)
{
  return visitLeg([&](const auto& kind) { return pointsWithin(kind, joints, steepest); }, leg);
}
inline LegReach reachAt(const EnclosedLeg& leg, const IntervalVector& p)
{
  return visitLeg([&](const auto& kind) { return reachAt(kind, p); }, leg);
}
inline LegSphere sphereAt(const EnclosedLeg& leg, double joint)
{
  return visitLeg([joint](const auto& kind) { return sphereAt(kind, joint); }, leg);
}
inline Eigen::Vector3d drivenPoint(const Leg& leg, double joint)
{
  return visitLeg([joint](const auto& kind) { return drivenPoint(kind, joint); }, leg.kind);
}

/// Its joints that no motor drives.
inline const PassiveJoints& passiveJoints(const Leg& leg)
{
  return visitLeg([](const auto& kind) -> const PassiveJoints& { return kind; }, leg.kind);
}
inline PassiveJoints& passiveJoints(Leg& leg)
{
  return const_cast<PassiveJoints&>(passiveJoints(std::as_const(leg)));
}
/// By what its joint velocity is multiplied before transmission factors compare it with others: 1, of an angle [m].
inline Interval driveScale(const Leg& leg)
{
  return visitLeg([](const auto& kind) { return driveScale(kind); }, leg.kind);
}
/// Whether its joint value is an angle [rad], otherwise it is a length [m].
inline bool hasAngle(const Leg& leg)
{
  return visitLeg([](const auto& kind) { return hasAngle(kind); }, leg.kind);
}
/// The unit of its joint value.
inline const char* unitOf(const Leg& leg)
{
  return hasAngle(leg) ? "rad" : "m";
}

/// What the angle of a crank is counted from where its limits are held [rad]; otherwise 0.
inline double referenceOf(const Leg& leg)
{
  const auto* const crank = std::get_if<Crank>(&leg.kind);
  return crank ? crank->reference : 0.0;
}

/// b over |n| cos phi, phi the angle between strut and the way of what the joint moves: 1, but for cranks with a drive
/// scale of their own.
inline Interval gearOf(const Leg& leg)
{
  const auto* const crank = std::get_if<Crank>(&leg.kind);
  return crank && crank->drive_scale > 0.0 ? crank->radius / Interval(crank->drive_scale) : Interval(1.0);
}

/// Of a sliding strut its tolerances; none of the other kinds has any.
const StrutTolerance& toleranceOf(const Leg& leg);
/// @throws std::invalid_argument naming the leg where it is of a kind that has none, and these are not 0
void setTolerance(const StrutTolerance& tolerance, Leg& leg);

/// The leg as a sliding strut. @throws std::invalid_argument naming the leg where it is of another kind
SlidingStrut& slidingStrut(Leg& leg);
const SlidingStrut& slidingStrut(const Leg& leg);
}  // namespace pkm_workspace
