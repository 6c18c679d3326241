// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <atomic>
#include <functional>

namespace pkm_workspace
{
/// One thread that does computations in the order in which they come: callbacks of its queue, and jobs of its owner.
/// Whatever answers at once belongs on another queue, and never waits for this one.
class Worker
{
public:
  Worker() : spinner_(1, &queue_) {}
  ~Worker() { stop(); }

  /// For services and actions whose callbacks compute.
  ros::CallbackQueue& queue() { return queue_; }
  /// Every computation looks at it and ends soon after it is set.
  const std::atomic<bool>& stopFlag() const { return stopped_; }

  void start() { spinner_.start(); }
  /// Adds a job; an exception that leaves it is logged.
  void post(const std::function<void()>& job);
  /// Ends the computation that is running, forgets the ones that wait, and joins the thread.
  void stop();

private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  std::atomic<bool> stopped_{ false };
};
}  // namespace pkm_workspace
