// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <pkm_workspace/Region.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <functional>
#include <mutex>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/ros/node_context.h"

namespace pkm_workspace
{
/// What rviz shows of a box that somebody asks about: green where every point is proved to be good, red with a bad
/// point where one is, yellow where neither is proved.
/// Its label says its size, the verdict, and what binds: at the bad point, or at the corner that is nearest to a limit.
visualization_msgs::MarkerArray boxMarkers(const Box& box, const ContainmentResult& result,
                                           const PointEvaluator& evaluate, const std::string& frame);

struct BoxFace;
struct Handle;

/// A box to drag and, by a ball before each face, to scale among the interactive markers, its verdict on ~box_markers,
/// latched; its context menu grows it to the largest box of its proportions at its center. At first it stands within
/// the node's region. Thread-safe: a worker of its own does everything, another one grows it.
class BoxMarker
{
public:
  /// The references have to outlive this object, the threads of the context have to end before it.
  BoxMarker(NodeContext& context, interactive_markers::InteractiveMarkerServer& handles);

  /// Shows the verdict by the node's criterion of now.
  void refresh();
  /// Moves it into a region in the frame of the root link, away from its center, unless somebody has led it.
  void placeIn(const Region& region);
  /// @param moved called after each move, by its worker
  void onMove(const std::function<void()>& moved) { moved_ = moved; }
  /// Of its handles, in the frame of the root link [m].
  Eigen::Vector3d lowestPoint() const;

private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void later(const std::function<void()>& job);
  void take(const Feedback& feedback);
  void drag(const Feedback& feedback);
  void grow();
  /// Changes the box, then shows it with its verdict.
  void set(const Box& box);
  void insert(const Handle& handle);
  void showBody();
  Eigen::Vector3d handlePlace(const BoxFace& face) const;

  NodeContext& context_;
  Worker& dragger_;
  Worker& grower_;
  interactive_markers::InteractiveMarkerServer& handles_;
  ros::Publisher markers_;
  std::function<void()> moved_;
  bool is_led_ = false;
  mutable std::mutex mutex_;  ///< of the next one, where others read it
  Box box_;
  Eigen::Vector3d shown_sides_ = Eigen::Vector3d::Zero();  ///< of the body among the interactive markers [m]
};
}  // namespace pkm_workspace
