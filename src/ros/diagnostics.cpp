// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/diagnostics.h"

#include <pkm_workspace/ErrorCode.h>
#include <ros/console.h>

#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace
{
constexpr double CLOCK_PATIENCE = 3.0;  // [s] until a simulation's clock is missed
constexpr const char* CHANGED =
    "robot_description is no longer the one that was read: answers are about the machine of "
    "this geometry, call ~reload for the other one";
constexpr const char* NO_CLOCK =
    "use_sim_time is true and no /clock arrives: stamps are 0, and tf is not up to date; "
    "start the simulation, or set use_sim_time to false";
}  // namespace

Diagnostics::Diagnostics(NodeContext& context)
  : context_(context), updater_(context.node, context.private_node, ros::this_node::getName())
{
  updater_.setHardwareID(context.machine().name() + " " + context.frames.root().geometry_hash);
  updater_.add("geometry", [this](Status& status) { tellGeometry(status); });
  updater_.add("computation", [this](Status& status) { tellComputation(status); });
  updater_.add("clock", [this](Status& status) { tellClock(status); });
  updater_.add("refusals", [this](Status& status) { tellRefusals(status); });
  timer_ = context.node.createWallTimer(ros::WallDuration(updater_.getPeriod()), [this](const ros::WallTimerEvent&) {
    look();
    updater_.force_update();
  });
}

void Diagnostics::look()
{
  const bool was_changed = is_description_changed_;
  try
  {
    is_description_changed_ = context_.urdf_text != loadDescription(context_.private_node, true);
  }
  catch (const std::invalid_argument&)  // it is gone, and nothing else has come
  {}
  if (is_description_changed_ && !was_changed)
    ROS_WARN_NAMED("urdf", "%s", CHANGED);
  const bool was_without_clock = is_without_clock_;
  is_without_clock_ =
      ros::Time::isSimTime() && ros::Time::now().isZero() && (ros::WallTime::now() - start_).toSec() > CLOCK_PATIENCE;
  if (is_without_clock_ && !was_without_clock)
    ROS_WARN_NAMED("clock", "%s", NO_CLOCK);
}

void Diagnostics::tellClock(Status& status) const
{
  if (is_without_clock_)
    status.summary(Status::WARN, NO_CLOCK);
  else
    status.summary(Status::OK, ros::Time::isSimTime() ? "simulated time" : "wall-clock time");
}

void Diagnostics::tellGeometry(Status& status) const
{
  const std::vector<std::string>& warnings = context_.urdf.warnings;
  if (is_description_changed_)
    status.summary(Status::WARN, CHANGED);
  else if (warnings.empty())
    status.summary(Status::OK, "machine loaded");
  else
    status.summaryf(Status::WARN, "machine loaded with %zu warnings about its URDF", warnings.size());
  status.add("machine", context_.machine().name());
  status.add("geometry hash", context_.frames.root().geometry_hash);
  status.add("frame", context_.frames.root().frame);
  status.add("version", version());
  for (const std::string& warning : warnings)
    status.add("warning", warning);
}

void Diagnostics::tellComputation(Status& status) const
{
  const Health::Report report = context_.health.report();
  if (report.computations == 0)
    status.summary(Status::OK, "the first computation is still running");
  else if (report.last.stopped)
    status.summary(Status::WARN, "the last bounds are wider than asked");
  else
    status.summary(Status::OK, "the last computation reached what was asked");
  status.add("computations", report.computations);
  status.add("question", report.last.question);
  status.add("answer", report.last.answer);
  status.add("seconds", report.last.seconds);
}

void Diagnostics::tellRefusals(Status& status) const
{
  const Health::Report report = context_.health.report();
  const auto count = [&report](std::int32_t code) {
    const auto refusals = report.refusals.find(code);
    return refusals == report.refusals.end() ? std::int64_t(0) : refusals->second;
  };
  if (count(ErrorCode::INTERNAL_ERROR) > 0)
    status.summary(Status::ERROR, "the node is wrong: please report the last refusal");
  else
    status.summary(Status::OK, report.refusals.empty() ? "no request was refused" : "bad requests were refused");
  status.add("invalid requests", count(ErrorCode::INVALID_REQUEST));
  status.add("unknown frames", count(ErrorCode::UNKNOWN_FRAME));
  status.add("not ready", count(ErrorCode::NOT_READY));
  status.add("internal errors", count(ErrorCode::INTERNAL_ERROR));
  status.add("last refusal", report.last_refusal);
}
}  // namespace pkm_workspace
