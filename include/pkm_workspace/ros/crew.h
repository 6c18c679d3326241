// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include <atomic>
#include <cstdint>

namespace pkm_workspace
{
/// Threads that share the callbacks of one queue: a long request leaves those that come after it to the others. The
/// callbacks of one service run side by side.
class Crew
{
public:
  explicit Crew(std::uint32_t threads) : spinner_(threads, &queue_) {}
  ~Crew() { stop(); }

  ros::CallbackQueue& queue() { return queue_; }
  /// Every computation looks at it, and ends with the best proven so far soon after stop() has set it.
  const std::atomic<bool>* stopFlag() const { return &stopped_; }

  void start() { spinner_.start(); }
  /// Ends the computations that are running, forgets the ones that wait, and joins the threads.
  void stop()
  {
    stopped_ = true;
    queue_.disable();
    queue_.clear();
    spinner_.stop();
  }

private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  std::atomic<bool> stopped_{ false };
};
}  // namespace pkm_workspace
