// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/comparison_service.h"

#include <ros/console.h>

#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/study/comparison.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"

namespace pkm_workspace
{
namespace
{
constexpr std::size_t MOST_MACHINES = 16;

/// The others, each in the frame of its own root link.
std::vector<FramedMachine> readMachines(const std::vector<std::string>& urdfs)
{
  Problems problems;
  std::vector<FramedMachine> machines;
  if (urdfs.empty() || urdfs.size() > MOST_MACHINES)
    problems.push_back("urdfs lists " + std::to_string(urdfs.size()) + " machines; it must list from 1 to " +
                       std::to_string(MOST_MACHINES));
  throwProblems(problems);
  for (std::size_t k = 0; k < urdfs.size(); ++k)
    try
    {
      const UrdfMachine urdf = readUrdf(urdfs[k]);
      FramedMachine in;
      in.frame = urdf.root_link;
      in.machine = std::make_shared<const Machine>(urdf.machine);
      in.geometry_hash = urdf.machine.geometryHash();
      machines.push_back(in);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back("urdfs[" + std::to_string(k) + "]: " + reason.what());
    }
  throwProblems(problems);
  return machines;
}

MachineComparison messageOf(const FramedMachine& in, const Comparison& study)
{
  MachineComparison message;
  message.region = toMessage(Answer{ { study.query, in }, study.region }, ros::Time::now());
  message.complete = study.workspace.complete;
  for (const Figure& figure : figuresOf(study))
  {
    ComparedFigure compared;
    compared.name = figure.key;
    compared.label = figure.label;
    compared.power = static_cast<std::uint8_t>(figure.power);
    compared.value = toMessage(figure.value);
    compared.scaled = toMessage(figure.scaled(study.region.size));
    message.figures.push_back(compared);
  }
  return message;
}

void requireEmpty(const std::string& field, const std::string& value, const std::string& reason)
{
  if (!value.empty())
    throw std::invalid_argument(field + " = '" + value + "' must be empty: " + reason);
}
}  // namespace

ComparisonService::ComparisonService(NodeContext& context)
  : context_(context)
  , service_(offer<CompareMachines>(context.computing, context.health, "compare_machines",
                                    [this](const CompareMachines::Request& request,
                                           CompareMachines::Response& response) { compare(request, response); }))
{}

void ComparisonService::compare(const CompareMachines::Request& request, CompareMachines::Response& response)
{
  requireEmpty("header.frame_id", request.query.header.frame_id,
               "each machine is evaluated in the frame of its own root link");
  requireEmpty("certificate", request.query.certificate, "a certificate is about one machine");
  requireNoBallAxes(request.query.criterion, "each machine has its own; pkm compare takes --ball-axes for each");
  RegionQuery query = fromMessage(request.query, context_.machine(), context_.query(), context_.parameters,
                                  context_.parameters.query.budget.time_limit);
  if (request.query.turned == RegionRequest::ON)
    throw std::invalid_argument(std::string("turned = ON: ") + NOT_TURNED);
  query.angles = 0.0;
  if (context_.parameters.keep_out_collisions && request.query.criterion.own_zones != CriterionRequest::OFF)
    throw std::invalid_argument(
        "own_zones must be OFF = 2: those of ~keep_out_collisions stand around this machine only");
  leaveJointsToEach(request.query.criterion, context_.machine(), context_.parameters.query.criterion, query.criterion);
  std::vector<FramedMachine> machines = readMachines(request.urdfs);
  machines.insert(machines.begin(), context_.frames.root());
  for (FramedMachine& in : machines)
    if (const std::optional<Machine> asked = machineOf(request.query.criterion, *in.machine))
    {
      in.machine = std::make_shared<const Machine>(*asked);
      in.geometry_hash = asked->geometryHash();
    }
  const StopFlag stop = context_.worker.makeStopFlag();
  query.budget.stop = stop.get();
  Health::Computation done;
  done.question = "comparison by the " + describe(query);
  const ros::WallTime begin = ros::WallTime::now();
  for (const FramedMachine& in : machines)
  {
    const auto tell = [](const std::string& doing) { ROS_DEBUG_STREAM_NAMED("server", "comparing: " << doing); };
    const Comparison study =
        withRemedy(REGION_REMEDY, [&] { return comparisonOf(*in.machine, query, VOLUME_ACCURACY, tell); });
    response.machines.push_back(messageOf(in, study));
    done.stopped = done.stopped || study.region.status == LargestRegion::Status::STOPPED || !study.workspace.complete;
  }
  response.message = std::to_string(machines.size()) + " machines were compared.";
  ROS_INFO_STREAM_NAMED("server", response.message);
  done.answer = response.message;
  done.seconds = (ros::WallTime::now() - begin).toSec();
  context_.health.noteComputation(done);
}
}  // namespace pkm_workspace
