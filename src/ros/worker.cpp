// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/worker.h"

#include <ros/console.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <exception>

namespace pkm_workspace
{
namespace
{
constexpr double NAP = 0.02;  // [s] between two looks for the end

/// Whose callbacks this thread calls.
thread_local Worker* served = nullptr;

/// Whether a thread waits that is no worker's.
std::atomic<bool> one_waits{ false };

class Job : public ros::CallbackInterface
{
public:
  explicit Job(const std::function<void()>& job) : job_(job) {}
  CallResult call() override
  {
    try
    {
      job_();
    }
    catch (const std::exception& error)
    {
      ROS_ERROR_STREAM_NAMED("worker", "a job has failed, please report: " << error.what());
    }
    return Success;
  }

private:
  std::function<void()> job_;
};
}  // namespace

void Worker::post(const std::function<void()>& job)
{
  queue_.addCallback(boost::make_shared<Job>(job));
}

void Worker::start()
{
  thread_ = std::thread([this] { serve(stopped_); });
}

void Worker::serve(const std::atomic<bool>& ends)
{
  served = this;
  while (!ends && !stopped_)
    queue_.callOne(ros::WallDuration(NAP));  // not callAvailable(): what it takes nobody else can call
}

bool Worker::stepAside(const std::function<void()>& wait)
{
  Worker* const worker = served;
  if (!worker)
  {
    if (one_waits.exchange(true))
      return false;
    wait();
    one_waits = false;
    return true;
  }
  if (worker->is_aside_)
    return false;
  worker->is_aside_ = true;
  std::atomic<bool> is_back(false);
  std::thread deputy([worker, &is_back] { worker->serve(is_back); });
  wait();
  is_back = true;
  deputy.join();
  worker->is_aside_ = false;
  return true;
}

StopFlag Worker::makeStopFlag()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  flags_.erase(std::remove_if(flags_.begin(), flags_.end(), [](const auto& flag) { return flag.expired(); }),
               flags_.end());
  const auto flag = std::make_shared<std::atomic<bool>>(stopped_.load());
  flags_.push_back(flag);
  return flag;
}

void Worker::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
    for (const auto& flag : flags_)
      if (const StopFlag alive = flag.lock())
        *alive = true;
  }
  queue_.disable();
  queue_.clear();
  if (thread_.joinable())
    thread_.join();
}
}  // namespace pkm_workspace
