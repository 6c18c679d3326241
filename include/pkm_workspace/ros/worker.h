// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace pkm_workspace
{
/// Every computation looks at its flag, and ends with the best proven so far soon after it is set.
using StopFlag = std::shared_ptr<std::atomic<bool>>;

/// One thread that does computations in the order in which they come: callbacks of its queue, and jobs of its owner.
/// Whatever answers at once belongs on another queue, and never waits for this one. A callback that has to wait for
/// something else steps aside meanwhile.
class Worker
{
public:
  Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { stop(); }

  /// For services whose callbacks compute.
  ros::CallbackQueue& queue() { return queue_; }
  /// A flag for one computation; stop() sets it. Thread-safe.
  StopFlag makeStopFlag();

  void start();
  /// Adds a job; an exception that leaves it is logged. Thread-safe.
  void post(const std::function<void()>& job);
  /// Ends the computation that is running, forgets the ones that wait, and joins the thread.
  void stop();

  /// Waits while a deputy serves the queue of the worker whose callback this is: one thread computes at a time, before
  /// and after. A thread that is no worker's just waits, one of all those at a time: a crew goes on with the others.
  /// @param wait returns soon, and does not throw
  /// @return false, without having waited, where somebody else has that place
  static bool stepAside(const std::function<void()>& wait);

private:
  void serve(const std::atomic<bool>& ends);

  ros::CallbackQueue queue_;
  std::thread thread_;
  std::atomic<bool> stopped_{ false };
  bool is_aside_ = false;  ///< belongs to the thread that computes
  std::mutex mutex_;
  std::vector<std::weak_ptr<std::atomic<bool>>> flags_;
};
}  // namespace pkm_workspace
