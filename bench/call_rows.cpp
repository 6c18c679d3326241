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

CheckPath::Request pathRequest(const std::vector<Eigen::Vector3d>& points)
{
  CheckPath::Request request;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    ToolSegment segment;
    segment.kind = ToolSegment::LINE;
    segment.start = toMessage(points[i]);
    segment.end = toMessage(points[i + 1]);
    request.segments.push_back(segment);
  }
  return request;
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

/// The call that computes nothing sends the same request, and answers what the node has answered to it.
void addPathRows(const PointEvaluator& evaluator, ros::NodeHandle& node, ros::ServiceServer& idle)
{
  const std::string row = "check_path of 10^4 lines";
  const std::vector<Eigen::Vector3d> points = pointsOfCurve(10001);
  std::vector<PathSegment> segments;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    segments.push_back(PathSegment::line(points[i], points[i + 1]));
  const CheckPath::Request request = pathRequest(points);
  CheckPath service;
  service.request = request;
  connect<CheckPath>(NODE + std::string("/check_path")).call(service);
  const boost::function<bool(CheckPath::Request&, CheckPath::Response&)> repeat =
      [response = service.response](CheckPath::Request&, CheckPath::Response& answer) {
        answer = response;
        return true;
      };
  idle = node.advertiseService("idle_path", repeat);
  addComputation(row, [evaluator, segments] { benchmark::DoNotOptimize(checkPath(evaluator, segments)); });
  addCall<CheckPath>(row, IDLE, "idle_path", request);
  addCall<CheckPath>(row, CALL, NODE + std::string("/check_path"), request);
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
  ros::ServiceServer idle;
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const PointEvaluator evaluator(orthoglideCube().machine, Criterion());
  addPointRows(evaluator);
  addPathRows(evaluator, node, idle);
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
