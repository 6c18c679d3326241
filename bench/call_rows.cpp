// SPDX-License-Identifier: BSD-3-Clause
// What calling the node adds to what it computes: run beside the node, by calls.launch.
#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/ComputeLargestRegion.h>
#include <pkm_workspace/EvaluatePoint.h>
#include <ros/ros.h>
#include <roscpp/Empty.h>

#include "path_problem.h"
#include "pkm_workspace/region/path_check.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/path_message.h"
#include "problem.h"
#include "rows.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
constexpr const char* NODE = "/pkm_workspace_node";
constexpr const char* COMPUTATION = "the computation alone";
constexpr const char* CALL = "the call of the node";
constexpr const char* IDLE = "a call that computes nothing";
constexpr int REPETITIONS = 9;

/// A persistent connection to a service, as a planner has it.
template <class Service>
ros::ServiceClient connect(const std::string& name)
{
  ros::service::waitForService(name);
  return ros::NodeHandle().serviceClient<Service>(name, true);
}

template <class Service>
void addCall(const std::string& row, const std::string& way, const std::string& name,
             const typename Service::Request& request)
{
  addRow(row, "", way, REPETITIONS, [name, request](benchmark::State& state) {
    ros::ServiceClient client = connect<Service>(name);
    typename Service::Response response;
    for (auto _ : state)
      if (!client.call(const_cast<typename Service::Request&>(request), response))
        return state.SkipWithError("no answer");
  })->UseRealTime();
}

void addComputation(const std::string& row, const std::function<void()>& compute)
{
  addRow(row, "", COMPUTATION, REPETITIONS, [compute](benchmark::State& state) {
    for (auto _ : state)
      compute();
  })->UseRealTime();
}

void addPointRows(const PointEvaluator& evaluator)
{
  const std::string row = "evaluate_point";
  const Eigen::Vector3d place(0.1, -0.05, 0.2);
  EvaluatePoint::Request request;
  request.point = toMessage(place);
  addComputation(row, [evaluator, place] { benchmark::DoNotOptimize(evaluator(place)); });
  addCall<roscpp::Empty>(row, IDLE, "empty", {});
  addCall<EvaluatePoint>(row, CALL, NODE + ("/" + row), request);
}

/// A segment from one point of a curve through the next to the one after that, as a request has it.
ToolSegment segmentOf(std::uint8_t kind, const Eigen::Vector3d& start, const Eigen::Vector3d& via,
                      const Eigen::Vector3d& end)
{
  ToolSegment segment;
  segment.kind = kind;
  segment.start = toMessage(start);
  if (kind == ToolSegment::ARC_THROUGH)
    segment.via = toMessage(via);
  segment.end = toMessage(end);
  return segment;
}

/// The call that computes nothing sends the same request, and answers what the node has answered to it.
ros::ServiceServer addPathRows(const std::string& row, std::uint8_t kind, ros::NodeHandle& node)
{
  const std::vector<Eigen::Vector3d> points = pointsOfCurve(20001);
  CheckPath service;
  for (std::size_t i = 0; i + 2 < points.size(); i += 2)
    service.request.segments.push_back(segmentOf(kind, points[i], points[i + 1], points[i + 2]));
  const std::string name = NODE + std::string("/check_path");
  connect<CheckPath>(name).call(service);
  const boost::function<bool(CheckPath::Request&, CheckPath::Response&)> repeat =
      [response = service.response](CheckPath::Request&, CheckPath::Response& answer) {
        answer = response;
        return true;
      };
  const std::string idle = "idle_path_" + std::to_string(kind);
  addComputation(row, [request = service.request] {
    const PointEvaluator evaluator(orthoglideCube().machine, Criterion());
    const PathQuery query;
    PathChecker checker(evaluator, query, [](const SegmentCheck&) {});
    forEachSegment(request, [&checker](const PathSegment& segment) { checker.add(segment); });
    benchmark::DoNotOptimize(checker.finish());
  });
  addCall<CheckPath>(row, IDLE, idle, service.request);
  addCall<CheckPath>(row, CALL, name, service.request);
  return node.advertiseService(idle, repeat);
}

void addRegionRows()
{
  const std::string row = "compute_largest_region, cube at 1e-3";
  addComputation(
      row, [machine = orthoglideCube().machine] { benchmark::DoNotOptimize(findByOurWay(machine, false, 1e-3)); });
  addCall<ComputeLargestRegion>(row, CALL, NODE + std::string("/compute_largest_region"), {});
}
}  // namespace

int run(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  ros::NodeHandle node;
  const boost::function<bool(roscpp::Empty::Request&, roscpp::Empty::Response&)> nothing =
      [](roscpp::Empty::Request&, roscpp::Empty::Response&) { return true; };
  const ros::ServiceServer empty = node.advertiseService("empty", nothing);
  const ros::ServiceServer idle_lines = addPathRows("check_path of 10^4 lines", ToolSegment::LINE, node);
  const ros::ServiceServer idle_arcs = addPathRows("check_path of 10^4 arcs", ToolSegment::ARC_THROUGH, node);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  addPointRows(PointEvaluator(orthoglideCube().machine, Criterion()));
  addRegionRows();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
}  // namespace bench
}  // namespace pkm_workspace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "call_bench");
  return pkm_workspace::bench::run(argc, argv);
}
