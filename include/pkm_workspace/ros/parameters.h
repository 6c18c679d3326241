// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/region/region_wish.h"
#include "pkm_workspace/ros/set_picture.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
/// The most that a time limit may be where a computation can be cancelled [s].
constexpr double LONGEST = 86400.0;

/// Where the bounds of the velocity transmission factors come from: ~psi_min and ~psi_max, or fittingBounds().
enum class PsiChoice
{
  GIVEN,
  AUTO
};
constexpr std::array<const char*, 2> PSI_CHOICES = { "given", "auto" };

/// What the node is configured with: its private parameters. Values with defaults; validate() tells what is wrong.
struct Parameters
{
  Parameters()
  {
    query.budget.time_limit = 60.0;
    query.budget.max_memory = DEFAULT_MEMORY;
    query.criterion = defaultCriterion();
  }

  ShapeWish shape;  ///< ~shape, and what waits for the shape that takes it: ~proportions, ~ratio and so on
  PlaceWish place;  ///< ~search_box, ~center, ~base_z, ~turned
  /// These two, ~set, ~aspect, the bounds of the criterion by their names, ~joint_limits, ~threads, ~max_memory: that
  /// the boxes of one computation may take [bytes], and ~time_limit, which is also the most that a request may ask for:
  /// a service cannot be cancelled. In (0, 86400] [s].
  RegionQuery query;
  double accuracy = 0.0;                            ///< ~accuracy [m], >= 0; 0: defaultAccuracy()
  PsiChoice psi = PsiChoice::GIVEN;                 ///< ~psi
  bool default_psi = true;                          ///< whether neither ~psi_min nor ~psi_max was given
  std::vector<double> joint_acceleration_max = {};  ///< ~joint_acceleration_max of paths [m/s^2], > 0; one or three
  UrdfOptions urdf;                                 ///< ~rails, ~tcp_links, ~tool_link and ~tool
  bool publish_joint_states = true;                 ///< whether the model stands at the region's center
  bool keep_out_collisions = false;                 ///< of the links that do not move
  bool show_paving = true;                          ///< whether the markers show the set that the region lies in
  bool show_boundary = false;                       ///< whether they show its undecided boxes too
  SetStyle set_style = SetStyle::SURFACE;           ///< ~set_style: what a set is drawn as
  SetColors set_colors = SetColors::CONDITION;      ///< ~set_colors: what colours of a set stand for
  std::string certificate_folder = {};              ///< where certificates may be written; empty: nowhere
  double paving_resolution = 0.0;  ///< width of the smallest boxes shown [m], >= 0; 0: defaultResolution()

  /// Appends one sentence for each value that is out of range; it begins with the name of the parameter.
  void validate(Problems& problems) const;
};

/// Reads all private parameters at once.
/// @throws std::invalid_argument naming every one that is unknown, of another type or out of range
Parameters loadParameters(const ros::NodeHandle& private_node);

/// The parameter robot_description, searched from the private namespace upwards: the URDF of the machine.
/// @param as_told by the master the last time, shortly after each change: cheap, for whoever asks again and again
/// @throws std::invalid_argument when there is none
std::string loadDescription(const ros::NodeHandle& private_node, bool as_told = false);
/// Reads it. @throws std::invalid_argument when it is refused
UrdfMachine readMachine(const std::string& xml, const ros::NodeHandle& private_node, const UrdfOptions& options);

/// @return the name of the link in tf, with the tf_prefix that is found from the private namespace upwards
std::string frameOf(const ros::NodeHandle& private_node, const std::string& link);
}  // namespace pkm_workspace
