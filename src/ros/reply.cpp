// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/reply.h"

#include <ros/console.h>

#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
namespace
{
/// Messages are logged and kept: a long request must not fill either.
constexpr std::size_t LONGEST_MESSAGE = 8000;
}  // namespace

std::pair<std::int32_t, std::string> guarded(Health& health, const std::string& name, const std::function<void()>& fill)
{
  std::pair<std::int32_t, std::string> outcome(ErrorCode::SUCCESS, "");
  try
  {
    fill();
    return outcome;
  }
  catch (const Refusal& refusal)
  {
    outcome = { refusal.error_code, refusal.what() };
  }
  catch (const std::invalid_argument& error)
  {
    outcome = { ErrorCode::INVALID_REQUEST, error.what() };
  }
  catch (const std::exception& error)
  {
    outcome = { ErrorCode::INTERNAL_ERROR, error.what() };
  }
  outcome.second = shortened(outcome.second, LONGEST_MESSAGE);
  health.countRefusal(name, outcome.first, outcome.second);
  const auto level = outcome.first == ErrorCode::NOT_READY ? ros::console::levels::Debug : ros::console::levels::Error;
  ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME ".server",
                 name << " refused (" << outcome.first << "): " << outcome.second);
  return outcome;
}
}  // namespace pkm_workspace
