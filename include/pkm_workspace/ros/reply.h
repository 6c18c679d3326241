// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include <pkm_workspace/ErrorCode.h>

#include "pkm_workspace/ros/health.h"

namespace pkm_workspace
{
/// A request that is not answered, with the reason for the response.
struct Refusal : std::runtime_error
{
  /// @param code a constant of ErrorCode.msg
  Refusal(std::int32_t code, const std::string& text) : std::runtime_error(text), error_code(code) {}
  std::int32_t error_code;
};

/// Runs @p fill and lets no exception leave it. @return a constant of ErrorCode.msg, and what was wrong
std::pair<std::int32_t, std::string> guarded(Health& health, const std::string& name,
                                             const std::function<void()>& fill);

/// Fills a response or a result: with error_code SUCCESS by @p fill, or with the code and the message of what went
/// wrong and nothing else.
template <class Response, class Fill>
void respond(Health& health, const std::string& name, Response& response, const Fill& fill)
{
  const auto outcome = guarded(health, name, [&] { fill(response); });
  if (outcome.first == ErrorCode::SUCCESS)
    return;
  response = Response();
  response.error_code = outcome.first;
  response.message = outcome.second;
}

/// Offers a service. @param fill as above; called on the callback queue of the node handle
template <class Service, class Fill>
ros::ServiceServer offer(ros::NodeHandle node, Health& health, const std::string& name, const Fill& fill)
{
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback = [&health, name, fill](Request& request,
                                                                                    Response& response) {
    respond(health, name, response, [&](Response& filled) { fill(request, filled); });
    return true;
  };
  return node.advertiseService(name, callback);
}
}  // namespace pkm_workspace
