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

StopFlag Worker::makeStopFlag()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  flags_.erase(std::remove_if(flags_.begin(), flags_.end(), [](const auto& flag) { return flag.expired(); }),
               flags_.end());
  const auto flag = std::make_shared<std::atomic<bool>>(stopped_);
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
  spinner_.stop();
}
}  // namespace pkm_workspace
