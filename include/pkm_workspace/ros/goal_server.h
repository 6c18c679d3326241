// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server.h>

#include <functional>
#include <list>
#include <mutex>
#include <string>

#include "pkm_workspace/ros/node_context.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
/// An action whose goals are computed one after the other by a worker of its own. A new goal preempts all older ones of
/// the action; goals that are preempted or cancelled have their flag set and end with what their computation then
/// returns.
template <class Action>
class GoalServer
{
public:
  ACTION_DEFINITION(Action)
  using Tell = std::function<void(const Feedback&)>;
  /// Fills the result; throws what respond() understands.
  using Compute = std::function<void(const Goal&, const StopFlag&, const Tell&, Result&)>;

  GoalServer(NodeContext& context, const std::string& name, const Compute& compute)
    : context_(context)
    , worker_(context.addWorker())
    , name_(name)
    , compute_(compute)
    , server_(
          context.private_node, name, [this](Handle handle) { take(handle); },
          [this](Handle handle) { cancel(handle); }, false)
  {
    server_.start();
  }

private:
  using Handle = actionlib::ServerGoalHandle<Action>;
  struct Open
  {
    Handle handle;
    StopFlag stop;
  };

  void take(const Handle& handle)
  {
    const Open goal{ handle, worker_.makeStopFlag() };
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Open& older : open_)
      *older.stop = true;
    open_.push_back(goal);
    worker_.post([this, goal] { run(goal); });
  }

  void cancel(const Handle& handle)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Open& goal : open_)
      if (goal.handle == handle)
        *goal.stop = true;
  }

  void run(Open goal)
  {
    const bool recalled = *goal.stop;
    if (!recalled)
      goal.handle.setAccepted();
    Result result;
    const Tell tell = [&goal, recalled](const Feedback& feedback) {
      if (!recalled)
        goal.handle.publishFeedback(feedback);
    };
    respond(context_.health, name_, result,
            [&](Result& filled) { compute_(*goal.handle.getGoal(), goal.stop, tell, filled); });
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      open_.remove_if([&goal](const Open& other) { return other.handle == goal.handle; });
    }
    if (*goal.stop)
      goal.handle.setCanceled(result, result.message);
    else if (result.error_code == ErrorCode::SUCCESS)
      goal.handle.setSucceeded(result, result.message);
    else
      goal.handle.setAborted(result, result.message);
  }

  NodeContext& context_;
  Worker& worker_;
  std::string name_;
  Compute compute_;
  std::mutex mutex_;
  std::list<Open> open_;  ///< goals that wait or run
  actionlib::ActionServer<Action> server_;
};
}  // namespace pkm_workspace
