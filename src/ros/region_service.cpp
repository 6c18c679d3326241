// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/region_service.h"

#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/GetRegion.h>
#include <ros/console.h>
#include <ros/init.h>

#include "pkm_workspace/ros/certificate_request.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
namespace
{
/// Requests that come within this time [s] of each other get one picture, of the last.
constexpr double BURST = 0.05;
}  // namespace

RegionService::RegionService(NodeContext& context, Tool* tool, Interaction& interaction)
  : context_(context)
  , pictures_(context.painter.makeStopFlag())
  , publisher_(context, tool, interaction)
  , action_(context, "find_largest_region",
            [this](const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell, Action::Result& result) {
              find(goal, stop, tell, result);
            })
{
  get_service_ = offer<GetRegion>(
      context.private_node, context.health, "get_region",
      [this](const GetRegion::Request&, GetRegion::Response& response) {
        const RegionConstPtr region = lastRegion();
        if (!region)
          throw Refusal(ErrorCode::NOT_READY, "the first computation is still running: " + describe(context_.query()));
        response.region = *region;
        response.message = region->message;
      });
  compute_service_ = offer<ComputeLargestRegion>(
      context.computing, context.health, "compute_largest_region",
      [this](const ComputeLargestRegion::Request& request, ComputeLargestRegion::Response& response) {
        response.region =
            *compute(read(request.query, context_.parameters.query.budget.time_limit), context_.worker.makeStopFlag());
        response.message = response.region.message;
      });
}

RegionQuestion RegionService::read(const RegionRequest& request, double longest) const
{
  const FramedMachine in = context_.frames.machineIn(request.header.frame_id, request.criterion);
  RegionQuestion question{ fromMessage(request, context_.machine(), context_.query(), context_.parameters, longest),
                           in };
  question.query.criterion = in.seen(question.query.criterion);
  question.certificate = certificateFile(request.certificate, context_.parameters);
  question.certificate->follow(*in.machine, question.query);
  return question;
}

void RegionService::find(const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell,
                         Action::Result& result)
{
  RegionQuestion question = read(goal.query, LONGEST);
  question.query.progress = [&tell](const RegionProgress& progress) {
    Action::Feedback feedback;
    feedback.size = progress.size;
    feedback.size_upper_bound = progress.size_upper_bound;
    feedback.volume = progress.volume;
    feedback.volume_upper_bound = progress.volume_upper_bound;
    feedback.boxes_done = progress.boxes_done;
    feedback.boxes_open = progress.boxes_open;
    feedback.seconds = progress.seconds;
    tell(feedback);
  };
  result.region = *compute(question, stop);
  result.message = result.region.message;
}

void RegionService::computeOwn()
{
  const StopFlag stop = context_.worker.makeStopFlag();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (own_)
    *own_ = true;
  own_ = stop;
  *pictures_ = true;
  pictures_ = context_.painter.makeStopFlag();
  context_.worker.post([this, stop] { computeOwn(stop); });
}

void RegionService::computeOwn(const StopFlag& stop)
{
  try
  {
    compute({ context_.query(), context_.frames.root() }, stop);
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM_NAMED("server", "the node's own region cannot be computed: " << error.what());
    failed_ = true;
    ros::requestShutdown();
  }
}

RegionService::RegionConstPtr RegionService::compute(RegionQuestion question, const StopFlag& stop)
{
  question.query.budget.stop = stop.get();
  ROS_INFO_STREAM_NAMED("server", "computing: " << describe(question.query));
  const Answer answer{ question, withRemedy(REGION_REMEDY, [&question] {
                         return findLargestRegion(*question.in.machine, question.query);
                       }) };
  ROS_INFO_STREAM_NAMED("server", summary(answer));
  const bool stopped = answer.region.status == LargestRegion::Status::STOPPED;
  if (stopped && !*stop)
    ROS_WARN_STREAM_NAMED("server", "the bounds are wider than asked: " << answer.region.message);
  context_.health.noteComputation({ describe(question.query), summary(answer), answer.region.seconds, stopped });

  Region message = toMessage(answer, ros::Time::now());
  if (question.certificate)
    saveCertificate(*question.certificate, *stop, message, *question.in.machine, question.query, answer.region);
  const auto region = std::make_shared<const Region>(message);
  if (!*stop)
    keep(question, region);
  return region;
}

void RegionService::keep(RegionQuestion question, const RegionConstPtr& region)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_region_ = region;
  }
  question.query.budget.stop = nullptr;
  question.query.progress = nullptr;
  question.query.closed = nullptr;
  question.query.plain_bounds.reset();
  question.certificate.reset();
  context_.worker.post([this, question, region] { show(question, region); });  // whoever asked has the answer by then
}

void RegionService::adopt(const LargestRegion& region)
{
  const Answer answer{ { context_.query(), context_.frames.root() }, region };
  context_.health.noteComputation({ describe(answer.question.query), summary(answer), region.seconds,
                                    region.status == LargestRegion::Status::STOPPED });
  keep(answer.question, std::make_shared<const Region>(toMessage(answer, ros::Time::now())));
}

void RegionService::show(const RegionQuestion& question, const RegionConstPtr& region)
{
  publisher_.publish(question, *region);
  const std::lock_guard<std::mutex> lock(mutex_);
  context_.painter.post([this, question, region, stop = pictures_] {
    if (region == lastRegion())  // most of a burst is told apart without waiting
      ros::WallDuration(BURST).sleep();
    if (region == lastRegion())
      publisher_.publishMarkers(question, *region, stop);
  });
}

RegionService::RegionConstPtr RegionService::lastRegion() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_region_;
}
}  // namespace pkm_workspace
