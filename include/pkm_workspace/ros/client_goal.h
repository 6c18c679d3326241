// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/action_client.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <algorithm>
#include <boost/shared_ptr.hpp>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace pkm_workspace
{
/// A goal of an action of the node. It ends when the node ends it, and LOST when the node itself ends. Thread-safe.
/// Whether the node is there is looked at while waitForResult() waits. Destroying it does not cancel the goal. It must
/// not outlive its Client.
template <class Action>
class Goal
{
public:
  using Connection = actionlib::ActionClient<Action>;
  using Handle = actionlib::ClientGoalHandle<Action>;
  using Result = typename Action::_action_result_type::_result_type;
  using Feedback = typename Action::_action_feedback_type::_feedback_type;
  using Message = typename Action::_action_goal_type::_goal_type;

  enum class State
  {
    RUNNING,
    ENDED,  ///< result() has it; of a goal that was refused, its error_code and message
    LOST    ///< the node is gone
  };

  /// Sends it. @param feedback is called from a thread of the client
  Goal(std::shared_ptr<Connection> connection, const Message& goal,
       const std::function<void(const Feedback&)>& feedback)
    : connection_(std::move(connection)), shared_(std::make_shared<Shared>())
  {
    const auto shared = shared_;
    const auto changed = [shared](const Handle& handle) { shared->change(handle); };
    const auto told = [feedback](const Handle&, const boost::shared_ptr<const Feedback>& message) {
      if (feedback)
        feedback(*message);
    };
    handle_ = connection_->sendGoal(goal, changed, told);
  }

  /// Asks the node to end it with the best proven so far.
  void cancel() { handle_.cancel(); }

  /// Waits for its end. @return whether it came within so many seconds
  bool waitForResult(double seconds)
  {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    std::unique_lock<std::mutex> lock(shared_->mutex);
    int missed = 0;  // glances in a row that found no node
    while (shared_->state == State::RUNNING && std::chrono::steady_clock::now() < deadline)
    {
      shared_->ended.wait_for(
          lock, std::min<std::chrono::duration<double>>(GLANCE, deadline - std::chrono::steady_clock::now()));
      lock.unlock();
      missed = connection_->isServerConnected() ? 0 : missed + 1;
      lock.lock();
      if (missed == 3 && shared_->state == State::RUNNING)
        shared_->state = State::LOST;
    }
    return shared_->state != State::RUNNING;
  }

  State state() const
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    return shared_->state;
  }

  /// @throws std::runtime_error unless it has ended
  Result result() const
  {
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    if (shared_->state != State::ENDED)
      throw std::runtime_error(shared_->state == State::LOST ? "the node of this goal is gone"
                                                             : "this goal has not ended yet");
    return shared_->result;
  }

private:
  static constexpr std::chrono::milliseconds GLANCE{ 500 };

  struct Shared
  {
    mutable std::mutex mutex;
    std::condition_variable ended;
    State state = State::RUNNING;
    Result result;

    void change(const Handle& handle)
    {
      if (!(handle.getCommState() == actionlib::CommState::DONE))
        return;
      const auto answer = handle.getResult();
      const std::lock_guard<std::mutex> lock(mutex);
      if (answer)
        result = *answer;
      state = answer ? State::ENDED : State::LOST;
      ended.notify_all();
    }
  };

  std::shared_ptr<Connection> connection_;
  std::shared_ptr<Shared> shared_;
  Handle handle_;
};
}  // namespace pkm_workspace
