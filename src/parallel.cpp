// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/parallel.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// Looks for the next job before a helper goes to sleep: waking one takes longer than many a job.
constexpr int PATIENCE = 2000;
}  // namespace

int processors()
{
  return static_cast<int>(std::min(1024U, std::max(1U, std::thread::hardware_concurrency())));
}

ThreadPool::~ThreadPool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
    ++job_;
  }
  wake_.notify_all();
  for (std::thread& helper : helpers_)
    helper.join();
}

void ThreadPool::serve()
{
  for (std::size_t index = next_++; index < count_; index = next_++)
    call_(context_, index);
}

void ThreadPool::help()
{
  for (unsigned done = 0;;)
  {
    for (int look = 0; look < PATIENCE && job_ == done; ++look)
      std::this_thread::yield();
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [&] { return job_ != done; });
      done = job_;
      if (ends_)
        return;
    }
    serve();
    --busy_;
  }
}

void ThreadPool::run(std::size_t count, Call call, const void* context)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    call_ = call;
    context_ = context;
    count_ = count;
    next_ = 0;
    while (helpers_.size() + 1 < std::min(static_cast<std::size_t>(threads_), count))
      helpers_.emplace_back(&ThreadPool::help, this);
    busy_ = helpers_.size();
    ++job_;
  }
  wake_.notify_all();
  serve();
  while (busy_ > 0)
    std::this_thread::yield();
}
}  // namespace pkm_workspace
