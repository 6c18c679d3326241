// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model.h"
#include "rails.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// A passive joint on the way from a slider to the platform, at zero, in the orientation of the slider's frame.
struct Hinge
{
  std::string joint;
  std::string child_link;
  Direction axis;
  IntervalVector offset;  ///< where it is, seen from the passive joint before it, the first from the slider's frame [m]
  std::string master;     ///< the joint that it follows in the end, or itself
  double factor;          ///< its angle for one radian of the master
};

/// A link that a slider carries, and how the joints lead there. At angles t of the hinges the link is turned by the
/// product of their rotations about their axes at zero, in their order: the wrist undoes the hinges at the slider one
/// by one, last first, exactly where each factor of that product meets its inverse.
struct Station
{
  std::string link;
  Frame frame;                             ///< at zero, in the slider's frame
  std::vector<Hinge> at_slider;            ///< passive joints that turn the strut
  std::vector<Hinge> wrist;                ///< passive joints that undo those: the k-th undoes the k-th from the end
  int fixed_joints = 0;                    ///< since the last passive joint
  IntervalVector offset{ 0.0, 0.0, 0.0 };  ///< where it is, seen from the last passive joint, as in Hinge [m]
  double turn = 0.0;  ///< upper bound of the angle that the wrist leaves, being parallel only nearly [rad]
  std::optional<Direction> extension = {};  ///< of the prismatic joint that lengthens the strut
  std::string problem;  ///< why neither this link nor one below can belong to the platform; empty: nothing found

  /// Whether the link moves without turning, on a strut that has all its freedom.
  bool isOnPlatform() const { return problem.empty() && at_slider.size() >= 2 && wrist.size() == at_slider.size(); }
};

/// All links below the one where a leg's passive joints begin, each after the one that carries it; that link is the
/// first.
std::vector<Station> stationsBelow(const Rail& rail, const Model& model);

/// Says what keeps the links below a slider from being a platform, of the branch that is nearest to it.
std::string whyNoPlatform(const std::vector<Station>& stations);

/// The same for one link. @return empty when it is on the platform
std::string whyNotOnPlatform(const Station& station);

/// What each of the three sliders carries.
using Stations = std::array<std::vector<Station>, 3>;

/// The leg that carries a link, and where; nothing when none does.
std::optional<std::pair<std::size_t, const Station*>> findLink(const std::string& link, const Stations& stations);

/// The names of all links, quoted.
std::string linksOf(const Model& model);
}  // namespace urdf_io
}  // namespace pkm_workspace
