// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

namespace pkm_workspace
{
/// How many threads this machine runs at a time; at least 1.
int processors();

/// Threads that share work. They are started when there is first something to share, and wait in between.
class ThreadPool
{
public:
  /// @param threads the caller's own included; 1: no others are ever started
  explicit ThreadPool(int threads) : threads_(threads) {}
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  int threads() const { return threads_; }

  /// Calls work(index) for every index below @p count; returns when all are done. Which thread gets which index is
  /// open: results belong into slots of their own, so that they do not depend on it.
  /// @pre work does not throw
  template <class Work>
  void forEach(std::size_t count, const Work& work)
  {
    if (threads_ <= 1 || count <= 1)
    {
      for (std::size_t index = 0; index < count; ++index)
        work(index);
      return;
    }
    run(
        count, [](const void* context, std::size_t index) { (*static_cast<const Work*>(context))(index); }, &work);
  }

private:
  using Call = void (*)(const void* context, std::size_t index);

  void run(std::size_t count, Call call, const void* context);
  void serve();
  void help();

  int threads_;
  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<unsigned> job_{ 0 };  ///< counts the calls of run()
  std::atomic<std::size_t> busy_{ 0 };
  bool ends_ = false;
  Call call_ = nullptr;
  const void* context_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{ 0 };
};
}  // namespace pkm_workspace
