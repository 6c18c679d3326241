// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/server.h"

#include <pkm_workspace/ErrorCode.h>
#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>

#include <sstream>
#include <stdexcept>

#include "pkm_workspace/region/center_space.h"
#include "pkm_workspace/ros/conversions.h"

namespace pkm_workspace
{
namespace
{
/// Requests that come within this time [s] of each other get one picture, of the last.
constexpr double BURST = 0.05;

/// A request that is not answered, with the reason for the response.
struct Refusal : std::runtime_error
{
  Refusal(std::int32_t code, const std::string& text) : std::runtime_error(text), error_code(code) {}
  std::int32_t error_code;
};

template <class Response>
void refuse(const std::string& service, std::int32_t error_code, const std::string& reason, Response& response)
{
  response = Response();
  response.error_code = error_code;
  response.message = reason;
  const auto level = error_code == ErrorCode::NOT_READY ? ros::console::levels::Debug : ros::console::levels::Error;
  ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME ".server", service << " refused (" << error_code << "): " << reason);
}

/// Lets no exception leave a callback: whatever goes wrong in @p fill is told by the response.
template <class Response, class Fill>
bool respond(const std::string& service, Response& response, const Fill& fill)
{
  try
  {
    fill();
    response.error_code = ErrorCode::SUCCESS;
  }
  catch (const Refusal& refusal)
  {
    refuse(service, refusal.error_code, refusal.what(), response);
  }
  catch (const std::invalid_argument& error)
  {
    refuse(service, ErrorCode::INVALID_REQUEST, error.what(), response);
  }
  catch (const std::exception& error)
  {
    refuse(service, ErrorCode::INTERNAL_ERROR, error.what(), response);
  }
  return true;
}

void requireFrame(const std::string& frame, const std::string& known)
{
  if (!frame.empty() && frame != known && frame != "/" + known)
    throw Refusal(ErrorCode::UNKNOWN_FRAME, "query.header.frame_id = '" + frame + "' must be empty or '" + known + "'");
}

/// Refuses to run where proofs would be void, and what has no bounded answer, before anybody asks.
void requireAnswerable(const Machine& machine, const Parameters& parameters)
{
  const std::string defect = rounding::selfTest();
  if (!defect.empty())
    throw std::runtime_error("nothing can be proved on this computer: " + defect);
  centerSpace(machine, parameters.query);
}

void logMachine(const UrdfMachine& urdf, const std::string& frame)
{
  for (const auto& warning : urdf.warnings)
    ROS_WARN_STREAM_NAMED("urdf", warning);
  std::ostringstream legs;
  for (const Leg& leg : urdf.machine.legs())
    legs << "; " << leg.joint << " in [" << leg.limits.lower() << ", " << leg.limits.upper() << "] m, strut "
         << leg.length.mid() << " m";
  ROS_INFO_STREAM_NAMED("urdf", "machine '" << urdf.machine.name() << "' in frame " << frame << legs.str()
                                            << "; geometry " << urdf.machine.geometryHash());
}

std::string question(const RegionQuery& query)
{
  const Criterion& criterion = query.criterion;
  std::ostringstream text;
  text << "largest " << query.shape->name() << " with psi in [" << criterion.psi_min << ", " << criterion.psi_max
       << "], joint limits " << (criterion.joint_limits ? "on" : "off") << ", accuracy " << query.accuracy
       << " m, within " << query.budget.time_limit << " s";
  return text.str();
}
}  // namespace

Server::Server(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
  : node_(node)
  , private_node_(private_node)
  , parameters_(loadParameters(private_node))
  , urdf_(loadMachine(private_node, parameters_.urdf))
  , frame_(frameOf(private_node, urdf_.root_link))
{
  requireAnswerable(urdf_.machine, parameters_);
  logMachine(urdf_, frame_);
  advertise();
}

Server::~Server()
{
  worker_.stop();
  painter_.stop();
}

void Server::advertise()
{
  publisher_.emplace(node_, private_node_, parameters_, urdf_, painter_.stopFlag());
  get_service_ = private_node_.advertiseService("get_region", &Server::getRegion, this);
  ros::NodeHandle computing(private_node_);
  computing.setCallbackQueue(&worker_.queue());
  compute_service_ = computing.advertiseService("compute_largest_region", &Server::computeLargestRegion, this);
}

bool Server::run()
{
  worker_.post([this] { computeFirst(); });
  worker_.start();
  painter_.start();
  // ros::ok() turns false only after the services have ended, which wait for the computation that is to be stopped here
  while (!ros::isShuttingDown())
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  worker_.stop();
  painter_.stop();
  return !failed_;
}

void Server::computeFirst()
{
  try
  {
    compute(parameters_.query);
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM_NAMED("server", "the node's own region cannot be computed: " << error.what());
    failed_ = true;
    ros::requestShutdown();
  }
}

Server::RegionConstPtr Server::compute(RegionQuery query)
{
  query.budget.stop = &worker_.stopFlag();
  ROS_INFO_STREAM_NAMED("server", "computing: " << question(query));
  const Answer answer{ query, findLargestRegion(urdf_.machine, query) };
  ROS_INFO_STREAM_NAMED("server", summary(answer));
  if (answer.region.status == LargestRegion::Status::STOPPED)
    ROS_WARN_STREAM_NAMED("server", "the bounds are wider than asked: " << answer.region.message);

  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = frame_;
  const auto region = std::make_shared<const Region>(toMessage(answer, urdf_.machine, header));
  setLastRegion(region);
  worker_.post([this, query, region] { show(query, region); });  // whoever asked has the answer by then
  return region;
}

void Server::show(const RegionQuery& query, const RegionConstPtr& region)
{
  publisher_->publish(*region);
  painter_.post([this, query, region] {
    ros::WallDuration(BURST).sleep();
    if (region == lastRegion())
      publisher_->publishMarkers(query, *region);
  });
}

bool Server::computeLargestRegion(ComputeLargestRegion::Request& request, ComputeLargestRegion::Response& response)
{
  return respond("compute_largest_region", response, [&] {
    requireFrame(request.query.header.frame_id, frame_);
    response.region = *compute(fromMessage(request.query, parameters_.query));
    response.message = response.region.message;
  });
}

bool Server::getRegion(GetRegion::Request&, GetRegion::Response& response)
{
  return respond("get_region", response, [&] {
    const RegionConstPtr region = lastRegion();
    if (!region)
      throw Refusal(ErrorCode::NOT_READY, "the first computation is still running: " + question(parameters_.query));
    response.region = *region;
    response.message = region->message;
  });
}

void Server::setLastRegion(const RegionConstPtr& region)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  last_region_ = region;
}

Server::RegionConstPtr Server::lastRegion() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_region_;
}
}  // namespace pkm_workspace
