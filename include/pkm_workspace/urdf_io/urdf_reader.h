// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/machine/ball_axes.h"
#include "pkm_workspace/machine/tolerances.h"
#include "pkm_workspace/machine/zone.h"

namespace pkm_workspace
{
/// What a URDF may miss its ideal by, in units of the strut length L (angles in rad). None of it weakens a proof: where
/// axes do not meet or are not parallel exactly, the enclosures of the machine grow until they hold all it may do.
namespace urdf_tolerance
{
constexpr double MEET = 1e-5;         ///< distance between the passive axes of one strut end [L]
constexpr double PARALLEL = 1e-5;     ///< angle between an axis at the slider and the one that undoes it [rad]
constexpr double COINCIDE = 1e-4;     ///< distance between tcp frames that are drawn assembled at zero [L]
constexpr double GAP = 1e-2;          ///< distance between them where the struts have to close the rest [L]
constexpr double SINGULARITY = 1e-4;  ///< least |eta| [L] and least |det A| [L_1 L_2 L_3] at zero
}  // namespace urdf_tolerance

/// What a user may name where the reader would otherwise find it.
struct UrdfOptions
{
  std::vector<std::string> rails;  ///< the three prismatic joints (~rails); empty: the only three there are
  std::vector<std::string>
      tcp_links;  ///< one link for each leg, in any order (~tcp_links); empty: the deepest that coincide
  std::string tool_link =
      "";  ///< a link fixed to the platform (~tool_link): the tool point; empty: where the legs meet
  std::optional<Eigen::Vector3d>
      tool = {};  ///< in its place, the tool's tip seen from there, along root axes (~tool) [m]
  /// Of the ball joints (~ball_axes): along each leg's strut from slider to platform where they are not tilted, in the
  /// root frame, of any length; one for all legs or one for each. Empty: as the struts are at joint values 0.
  BallAxes ball_axes = {};
  /// By how much what was built may differ from the URDF (~tolerance_length and so on), in place of what its element
  /// <pkm_tolerances> says: answers are about all such machines.
  GivenTolerances tolerances = {};
};

/// How the value of one joint follows from another: value = factor * (value of source) + offset [m, rad].
struct JointFollower
{
  std::string joint;
  std::string source;
  double factor;
  double offset;
};

/// The passive joints that turn one strut: at angles t0, t1 it is Rot(axes[0], t0) Rot(axes[1], t1) strut.
struct StrutHinges
{
  std::array<std::string, 2> joints;    ///< from the slider on
  std::array<std::string, 2> masters;   ///< the joints that they follow by <mimic>, or themselves
  std::array<double, 2> factors;        ///< their angle for one radian of the master
  std::array<Eigen::Vector3d, 2> axes;  ///< their unit directions at zero, in the root frame
  Eigen::Vector3d strut;                ///< vector from A to B at zero, in the root frame [m]
};

/// A machine, and what else its URDF says that ROS needs to know.
struct UrdfMachine
{
  Machine machine;
  std::string root_link;                     ///< frame of all numbers of the machine
  std::array<std::string, 3> slider_links;   ///< moved by the machine's three joints, in their order
  std::array<std::string, 3> tcp_links;      ///< where the legs meet, one link of each
  std::string tool_point;                    ///< a phrase: which link is the tool point, and why
  std::string gap;                           ///< a phrase: how far from assembled it is drawn at zero; empty: it is
  std::array<StrutHinges, 3> hinges;         ///< for jointValues()
  std::vector<JointFollower> followers;      ///< every joint that follows from the rails and hinges, these included
  std::vector<std::string> warnings;         ///< what is in the URDF and not used, or hardly meant
  std::vector<std::string> moved_links;      ///< all that hang at a joint that is not fixed
  std::vector<Zone> still_collisions;        ///< of the links that do not move: their collision geometry, to keep out
  std::vector<std::string> open_collisions;  ///< of it what is no zone: a phrase for each
  std::array<Interval, 3> drawn_rails;       ///< joint values that each rail is drawn between; empty where it is not
};

/// Reads a closed-loop machine from a URDF (docs/urdf.md): three branches, cut at the platform. Where it is not drawn
/// assembled at joint values 0 to the last digit, its zero configuration is where the struts then meet. Every number of
/// the machine encloses the exact number that the URDF's decimals, read as doubles, stand for. Legs come in the order
/// in which the rails stand in the file or are named. Thread-safe. While urdfdom parses, the process-wide output
/// handler of console_bridge is ours.
/// @throws std::invalid_argument naming everything that is wrong at once, each with its element, value, unit and what
/// is allowed
UrdfMachine readUrdf(const std::string& xml, const UrdfOptions& options = {});

/// Reads the file, then as above. @throws std::invalid_argument also when it cannot be read; the text begins with the
/// path
UrdfMachine readUrdfFile(const std::string& path, const UrdfOptions& options = {});
}  // namespace pkm_workspace
