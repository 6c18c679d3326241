// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/parallel.h"

#include <algorithm>
#include <ctime>
#include <system_error>

#include "pkm_workspace/common/processors.h"

namespace pkm_workspace
{
namespace
{
/// Looks for the next work before a helper goes to sleep: waking one takes longer than many a piece of work.
constexpr int PATIENCE = 2000;
/// The caller asks how long it has been working each time it has done so many indices.
constexpr std::size_t OFTEN = 16;
/// How long the caller looks for the end of what others have begun, at the most, before it goes to sleep.
constexpr std::chrono::microseconds LONGEST_SPIN(500);
/// The most calls in a row that are done alone because others made work longer.
constexpr int MOST_ALONE = 4096;

/// Of this thread [s].
double processorTime()
{
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}  // namespace

int processors()
{
  // Asking takes the system longer than the proof of a cube.
  static const int count = static_cast<int>(std::min(1024U, std::max(1U, std::thread::hardware_concurrency())));
  return count;
}

ThreadPool::ThreadPool(int threads, double alone)
  : threads_(threads)
  , alone_(alone)
  , caller_(std::this_thread::get_id())
  , begin_(Clock::now())
  , begin_processor_time_(processorTime())
{}

ThreadPool::~ThreadPool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  for (std::thread& helper : helpers_)
    helper.join();
}

/// Does one index that nobody has begun. Whatever work is at hand then cannot end before.
/// @return false where none is left
bool ThreadPool::take()
{
  std::size_t left = left_;
  while (left > 0 && !left_.compare_exchange_weak(left, left - 1))
    ;
  if (left == 0)
    return false;
  const std::size_t count = count_;
  call_(context_, count - left);
  const bool is_last = ++finished_ == count;
  if (is_last && std::this_thread::get_id() != caller_)
  {
    const std::lock_guard<std::mutex> lock(done_mutex_);
    done_.notify_one();
  }
  return true;
}

bool ThreadPool::isLong()
{
  is_long_ = is_long_ || (std::chrono::duration<double>(Clock::now() - begin_).count() >= alone_ &&
                          processorTime() - begin_processor_time_ >= alone_);
  return is_long_;
}

/// Wakes one helper, or starts one; it gets the next. Where the scheduler lets none run, none is called in vain.
/// @param lock of mutex_. The caller does not wait for it: a helper may have been stopped while it holds it
/// @return whether there is nothing more to do
bool ThreadPool::recruit(std::unique_lock<std::mutex> lock)
{
  if (!lock)
    return false;
  if (left_ == 0)
    return true;
  if (asleep_ > 0)
  {
    wake_.notify_one();
    return true;
  }
  if (ends_ || started_ + 1 >= threads_)
    return true;
  try
  {
    helpers_.emplace_back(&ThreadPool::help, this);
    ++started_;
  }
  catch (const std::system_error&)
  {
    started_ = threads_ - 1;  // the system gives no more
  }
  return true;
}

void ThreadPool::help()
{
  while (awaitWork())
  {
    if (mayRecruit())
      recruit(std::unique_lock<std::mutex>(mutex_));
    while (take())
      ;
  }
}

/// @return false at the end
bool ThreadPool::awaitWork()
{
  for (int look = 0; look < PATIENCE && left_ == 0 && !ends_; ++look)
    std::this_thread::yield();
  if (left_ > 0)
    return true;
  std::unique_lock<std::mutex> lock(mutex_);
  ++asleep_;
  wake_.wait(lock, [this] { return left_ > 0 || ends_; });
  --asleep_;
  return !ends_;
}

/// Waits until what others have begun is done. @param patience before the processor is left to them
void ThreadPool::awaitOthers(Clock::duration patience)
{
  for (const auto begin = Clock::now(); finished_ < count_ && Clock::now() - begin < patience;)
    ;
  if (finished_ == count_)
    return;
  std::unique_lock<std::mutex> lock(done_mutex_);
  done_.wait(lock, [this] { return finished_ == count_; });
}

/// Where the caller has waited for longer than the others' share would have taken it, it goes on alone for a while:
/// twice as long each time, half as long after help that was one.
void ThreadPool::judge(std::size_t own, Clock::duration worked, Clock::duration waited)
{
  if (own == 0 || own == count_)
    return;
  const bool helped = waited < worked * static_cast<double>(count_ - own) / static_cast<double>(own);
  alone_for_ = helped ? 0 : penalty_;
  penalty_ = helped ? std::max(1, penalty_ / 2) : std::min(2 * penalty_, MOST_ALONE);
}

void ThreadPool::run(std::size_t count, Call call, const void* context)
{
  call_ = call;
  context_ = context;
  count_ = count;
  finished_ = 0;
  left_ = count;
  const auto begin = Clock::now();
  std::size_t own = 0;
  bool recruited = false;
  do
    if (own % OFTEN == 0 && !recruited && isLong())
      recruited = !mayRecruit() || recruit(std::unique_lock<std::mutex>(mutex_, std::try_to_lock));
  while (take() && ++own);
  const auto worked = Clock::now() - begin;
  awaitOthers(std::min<Clock::duration>(worked / static_cast<int>(std::max<std::size_t>(own, 1)), LONGEST_SPIN));
  judge(own, worked, Clock::now() - begin - worked);
}
}  // namespace pkm_workspace
