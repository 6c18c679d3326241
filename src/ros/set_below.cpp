// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/set_below.h"

#include <algorithm>
#include <limits>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/ros/markers.h"

namespace pkm_workspace
{
namespace
{
/// Where cuts differ: a few hundred at most.
std::vector<double> topsOf(const BoxTree& tree)
{
  std::vector<double> tops;
  const Box& whole = tree.bisection().root();
  constexpr int LEVELS = 32;
  for (int k = 1; k <= LEVELS; ++k)
    tops.push_back(whole.lower.z() + k * whole.width(2) / LEVELS);
  return tops;
}
}  // namespace

SetBelow::SetBelow(NodeContext& context, Interaction& interaction)
  : context_(context)
  , interaction_(interaction)
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("set_markers", 1, true))
{
  interaction.onMove([this] { cutLater(); });
}

void SetBelow::show(const FramedMachine& in, const Workspace& workspace,
                    const std::shared_ptr<const PavingReport>& report, const std::shared_ptr<const SetPicture>& set)
{
  const auto shown = std::make_shared<const Shown>(Shown{ in, workspace, report, set, topsOf(report->paving.tree) });
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shown_ = shown;
  }
  cutLater();
}

void SetBelow::cutLater()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!shown_ || is_waiting_)
    return;
  is_waiting_ = true;
  context_.painter.post([this] { cut(); });
}

double SetBelow::ceilingFor(const Shown& shown) const
{
  const Eigen::Isometry3d from_root = shown.in.toRoot().inverse();
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : interaction_.lowestPoints())
    lowest = std::min(lowest, (from_root * point).z());
  const bool is_flat = shown.report->paving.tree.bisection().root().width(2) == 0.0;
  if (is_flat && onlyJointsChangeAlongRails(*shown.in.machine, shown.report->paving.premises.criterion))
    return lowest;
  const auto above = std::upper_bound(shown.tops.begin(), shown.tops.end(), lowest);
  return above == shown.tops.begin() ? -std::numeric_limits<double>::infinity() : *(above - 1);
}

void SetBelow::cut()
{
  std::shared_ptr<const Shown> shown;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_waiting_ = false;
    shown = shown_;
  }
  const double ceiling = ceilingFor(*shown);
  if (drawn_ == shown && ceiling_ == ceiling)
    return;
  drawn_ = shown;
  ceiling_ = ceiling;
  const Premises premises = shown->in.premises(shown->report->paving.premises.criterion);
  const auto markers = markersOf(*shown->set, premises, *shown->in.machine, shown->workspace, ceiling);
  markers_.publish(inRoot(markers, shown->in, context_.frames.root().frame));
}
}  // namespace pkm_workspace
