// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace pkm_workspace
{
/// Threads that share work. The caller does what nobody else has begun, and waits only for what somebody has: a thread
/// that the scheduler does not run keeps nothing up. The others join once the work has proved to be long, one after the
/// other, and stay away for a while from work that they made no shorter.
class ThreadPool
{
public:
  /// Processor time [s] after which others join: starting them takes some tenths of a millisecond, and where all
  /// processors are busy, what one of them has begun may take as long as the scheduler likes.
  static constexpr double LONG = 5e-3;

  /// @param threads the caller's own included; 1: no others are ever started
  /// @param alone processor time [s] of the caller, from here on, until others join; 0 for a few long pieces of work
  explicit ThreadPool(int threads, double alone = LONG);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  int threads() const { return threads_; }

  /// Calls work(index) for every index below @p count; returns when all are done. Which thread gets which index is
  /// open: results belong into slots of their own, so that they do not depend on it.
  /// @pre work does not throw; always called by the thread that made the pool
  template <class Work>
  void forEach(std::size_t count, const Work& work)
  {
    if (threads_ <= 1 || count <= 1 || alone_for_ > 0)
    {
      alone_for_ -= alone_for_ > 0 && count > 1 ? 1 : 0;
      for (std::size_t index = 0; index < count; ++index)
        work(index);
      return;
    }
    run(
        count, [](const void* context, std::size_t index) { (*static_cast<const Work*>(context))(index); }, &work);
  }

private:
  using Call = void (*)(const void* context, std::size_t index);
  using Clock = std::chrono::steady_clock;

  void run(std::size_t count, Call call, const void* context);
  bool take();
  bool isLong();
  bool mayRecruit() const { return left_ > 0 && (asleep_ > 0 || started_ + 1 < threads_); }
  bool recruit(std::unique_lock<std::mutex> lock);
  void help();
  bool awaitWork();
  void awaitOthers(Clock::duration patience);
  void judge(std::size_t own, Clock::duration worked, Clock::duration waited);

  const int threads_;
  const double alone_;
  const std::thread::id caller_;
  const Clock::time_point begin_;
  const double begin_processor_time_;
  bool is_long_ = false;
  int alone_for_ = 0;  ///< so many calls are done without others
  int penalty_ = 1;    ///< what alone_for_ will be where others make work longer
  std::vector<std::thread> helpers_;
  std::atomic<int> started_{ 0 };  ///< helpers, those included that could not be started
  std::atomic<int> asleep_{ 0 };
  std::atomic<bool> ends_{ false };
  std::mutex mutex_;  ///< of those who join
  std::condition_variable wake_;
  std::mutex done_mutex_;
  std::condition_variable done_;

  // The work at hand; written while none of it is left, read by whoever has taken some of it.
  Call call_ = nullptr;
  const void* context_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> left_{ 0 };      ///< indices that nobody has begun
  std::atomic<std::size_t> finished_{ 0 };  ///< indices that are done
};
}  // namespace pkm_workspace
