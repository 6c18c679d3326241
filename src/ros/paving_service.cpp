// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/paving_service.h"

#include <ros/console.h>

#include <algorithm>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/certificate_request.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/markers.h"
#include "pkm_workspace/ros/set_surface.h"

namespace pkm_workspace
{
namespace
{
/// What is left of the time after the paving.
Budget restOf(const PavingQuestion& question, const PavingReport& report)
{
  const Budget& budget = question.query.budget;
  return budget.within(std::max(1e-9, budget.time_limit - report.seconds()));
}

void addConnection(const PavingQuestion& question, const PavingReport& report, Workspace& workspace)
{
  ConnectionTask task{ question.query, question.query.resolution, question.connect[0], question.connect[1] };
  task.query.budget = restOf(question, report);
  task.query.progress = nullptr;  // it would be of another paving
  const ConnectionReport found = connect(*question.in.machine, task);
  fill(found, workspace);
  workspace.seconds += found.seconds;
}
}  // namespace

PavingService::PavingService(NodeContext& context, SetBelow& below)
  : context_(context)
  , below_(below)
  , workspace_(context.private_node.advertise<Workspace>("workspace", 1, true))
  , markers_(context.private_node.advertise<visualization_msgs::MarkerArray>("workspace_markers", 1, true))
  , surfaces_(context)
  , service_(offer<ComputeWorkspace>(
        context.computing, context.health, "compute_workspace",
        [this](const ComputeWorkspace::Request& request, ComputeWorkspace::Response& response) {
          response.workspace =
              compute(read(request.query, context_.parameters.query.budget.time_limit), context_.worker.makeStopFlag());
          response.message = response.workspace.message;
        }))
  , action_(context, "approximate_workspace",
            [this](const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell, Action::Result& result) {
              approximate(goal, stop, tell, result);
            })
{}

PavingQuestion PavingService::read(const PavingRequest& request, double longest) const
{
  const FramedMachine in = context_.frames.machineIn(request.header.frame_id, request.criterion);
  PavingQuestion question = fromMessage(request, in, context_.query().criterion, context_.parameters, longest);
  question.certificate = certificateFile(request.certificate, context_.parameters);
  question.certificate->validate(*in.machine, question.query.criterion);
  return question;
}

void PavingService::approximate(const Action::Goal& goal, const StopFlag& stop, const Action::Tell& tell,
                                Action::Result& result)
{
  PavingQuestion question = read(goal.query, LONGEST);
  question.query.progress = [&tell](const PavingProgress& progress) {
    Action::Feedback feedback;
    feedback.volume_inside = progress.volume_inside;
    feedback.volume_boundary = progress.volume_boundary;
    feedback.boxes = progress.boxes;
    feedback.boxes_per_second = progress.boxesPerSecond();
    feedback.seconds = progress.seconds;
    tell(feedback);
  };
  result.workspace = compute(question, stop);
  result.message = result.workspace.message;
}

Workspace PavingService::compute(PavingQuestion question, const StopFlag& stop)
{
  question.query.budget.stop = stop.get();
  if (question.components)
    question.query.budget = question.query.budget.sharedBy(1 + Components::BYTES_A_BOX);
  ROS_INFO_STREAM_NAMED("server", "computing: " << describe(question.query));
  PavingReport paved = withRemedy(PAVING_REMEDY, [&] { return goOn(question); });
  if (question.components)
    paved.components =
        reportComponents(*question.in.machine, paved.paving, !question.query.box, restOf(question, paved));
  const auto report = std::make_shared<const PavingReport>(std::move(paved));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = report;
  }
  const Paving& paving = report->paving;
  Workspace workspace = toMessage(question, *report, ros::Time::now());
  saveCertificate(*question.certificate, *stop, workspace, *question.in.machine, question.query.criterion, paving,
                  question.query.budget.max_memory);
  if (!question.connect.empty())
    addConnection(question, *report, workspace);
  const std::string effort =
      std::to_string(paving.boxes_here + report->size.boxes) + " boxes, " + nearly(report->seconds(), 3) + " s";
  ROS_INFO_STREAM_NAMED("server", workspace.message << ' ' << effort);
  context_.health.noteComputation(
      { describe(question.query), workspace.message + ' ' + effort, report->seconds(), !report->complete() });
  if (!*stop)  // whoever asked has the answer by then
    context_.worker.post([this, in = question.in, workspace, report] { show(in, workspace, report); });
  return workspace;
}

PavingReport PavingService::goOn(const PavingQuestion& question) const
{
  std::unique_lock<std::mutex> lock(mutex_);
  const auto last = last_;
  lock.unlock();
  Problems differences;
  if (last)
    validateEarlier(*question.in.machine, question.query, last->paving, differences);
  return reportPaving(*question.in.machine, question.query, last && differences.empty() ? &last->paving : nullptr,
                      question.volume);
}

void PavingService::show(const FramedMachine& in, Workspace workspace,
                         const std::shared_ptr<const PavingReport>& report)
{
  workspace.inside = workspace.boundary = BoxList();
  workspace_.publish(workspace);
  const std::shared_ptr<const Paving> paving(report, &report->paving);
  context_.painter.post([this, in, workspace, report, paving] {
    draw(in, workspace, report,
         std::make_shared<const SetSurface>(*paving, *in.machine, context_.parameters.set_colors, true));
  });
  surfaces_.make(in, paving, true, [this, in, workspace, report](const std::shared_ptr<const SetPicture>& surface) {
    draw(in, workspace, report, surface);
  });
}

void PavingService::draw(const FramedMachine& in, const Workspace& workspace,
                         const std::shared_ptr<const PavingReport>& report,
                         const std::shared_ptr<const SetPicture>& set)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (report != last_)
      return;  // a newer one will be drawn
  }
  const Premises premises = in.premises(report->paving.premises.criterion);
  const auto shown = markersOf(*set, premises, *in.machine, workspace);
  markers_.publish(inRoot(shown, in, context_.frames.root().frame));
  below_.show(in, workspace, report, set);
  context_.panel.tell("set", shown.markers.front().text, set->legend());
}
}  // namespace pkm_workspace
