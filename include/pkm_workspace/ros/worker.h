// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace pkm_workspace
{
/// Every computation looks at its flag, and ends with the best proven so far soon after it is set.
using StopFlag = std::shared_ptr<std::atomic<bool>>;

/// One thread that does computations in the order in which they come: callbacks of its queue, and jobs of its owner.
/// Whatever answers at once belongs on another queue, and never waits for this one.
class Worker
{
public:
  Worker() : spinner_(1, &queue_) {}
  ~Worker() { stop(); }

  /// For services whose callbacks compute.
  ros::CallbackQueue& queue() { return queue_; }
  /// A flag for one computation; stop() sets it. Thread-safe.
  StopFlag makeStopFlag();

  void start() { spinner_.start(); }
  /// Adds a job; an exception that leaves it is logged. Thread-safe.
  void post(const std::function<void()>& job);
  /// Ends the computation that is running, forgets the ones that wait, and joins the thread.
  void stop();

private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  std::mutex mutex_;
  bool stopped_ = false;
  std::vector<std::weak_ptr<std::atomic<bool>>> flags_;
};
}  // namespace pkm_workspace
