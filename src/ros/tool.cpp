// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/tool.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/machine/assembly.h"
#include "pkm_workspace/report/binding_limit.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/reply.h"
#include "pkm_workspace/ros/solid_message.h"
#include "pkm_workspace/urdf_io/joint_values.h"

namespace pkm_workspace
{
namespace
{
constexpr int HALVINGS = 60;

/// In floating point, as the tool is moved; the words say what the enclosures prove.
std::string limitObjection(const Machine& machine, const Configuration& there)
{
  std::string text;
  for (const Limit& limit : jointLimits(machine, there.rho))
    if (limit.margin.mid() < 0.0)
      text += (text.empty() ? "" : "; ") + describe(limit, machine);
  return text;
}

std::string aspectObjection(const Machine& machine, const Criterion& criterion, const Configuration& there)
{
  const int wanted = criterion.wantedSign(machine.aspect());
  if (wanted == 0)
    return "";
  const bool fits = wanted > 0 ? there.det_a.certainlyPositive() : there.det_a.certainlyNegative();
  return fits ? "" : "at or beyond a parallel singularity: det A does not have the sign of the aspect";
}
}  // namespace

Tool::Tool(NodeContext& context) : context_(context), joint_states_(context.node, context.urdf)
{
  state_ = { context.machine().zero(), objectionTo(context.machine().zero()) };
  if (context.private_node.resolveName("rail_states") == context.node.resolveName("joint_states"))
    throw std::invalid_argument("topic ~rail_states is joint_states, on which this node publishes: remap it elsewhere");
  const boost::function<void(const geometry_msgs::PoseStamped&)> on_pose = [this](const auto& pose) {
    guarded(context_.health, "tool_pose", [&] { follow(pose); });
  };
  const boost::function<void(const sensor_msgs::JointState&)> on_rails = [this](const auto& rails) {
    guarded(context_.health, "rail_states", [&] { follow(rails); });
  };
  pose_ = context.private_node.subscribe<geometry_msgs::PoseStamped>("tool_pose", 1, on_pose);
  rails_ = context.private_node.subscribe<sensor_msgs::JointState>("rail_states", 1, on_rails);
}

void Tool::follow(const geometry_msgs::PoseStamped& pose)
{
  lead(context_.frames.pointInRoot(pose.header.frame_id, fromMessage(pose.pose.position)));
}

void Tool::follow(const sensor_msgs::JointState& rails)
{
  Eigen::Vector3d rho;
  for (int i = 0; i < 3; ++i)
  {
    const std::string& joint = context_.machine().leg(i).joint;
    const auto name = std::find(rails.name.begin(), rails.name.end(), joint);
    const auto index = static_cast<std::size_t>(name - rails.name.begin());
    if (index >= rails.position.size())
      throw std::invalid_argument("no position for joint '" + joint + "'");
    rho[i] = rails.position[index];
  }
  Problems problems;
  requireFinite("position", rho, problems);
  throwProblems(problems);
  if (const auto p = assemble(context_.machine(), rho, aspect()))
    lead(*p);
  else
    stopBefore(rho);
}

int Tool::aspect() const
{
  const Machine& machine = context_.machine();
  if (const int asked = context_.query().criterion.wantedSign(machine.aspect()))
    return asked;
  const auto here = configurationAt(machine, state().point);
  return !here || here->det_a.contains(0.0) ? machine.aspect() : here->det_a.certainlyPositive() ? 1 : -1;
}

void Tool::stopBefore(Eigen::Vector3d bad)
{
  is_led_ = true;
  Eigen::Vector3d point = state().point;
  const auto here = inverseKinematics(context_.machine(), point);
  if (!here)
    return;
  const int sign = aspect();
  Eigen::Vector3d good = *here;
  for (int k = 0; k < HALVINGS; ++k)
  {
    const Eigen::Vector3d between = 0.5 * (good + bad);
    const auto p = assemble(context_.machine(), between, sign);
    const bool is_good = p && objectionTo(*p).empty();
    (is_good ? good : bad) = between;
    if (is_good)
      point = *p;
  }
  go({ point, "beyond these joints the machine has no assembly in its working mode and aspect" }, false);
}

std::string Tool::objectionTo(const Eigen::Vector3d& p) const
{
  const Criterion criterion = context_.query().criterion;
  const Machine& machine = context_.machine();
  try
  {
    jointValues(context_.urdf, p);
    const auto there = configurationAt(machine, p);
    if (!there)
      return "a strut is within rounding of being across its rail (serial singularity)";
    const std::string limits = criterion.joint_limits ? limitObjection(machine, *there) : "";
    return limits.empty() ? aspectObjection(machine, criterion, *there) : limits;
  }
  catch (const std::invalid_argument& unreachable)
  {
    return unreachable.what();
  }
}

ToolState Tool::border(Eigen::Vector3d good, Eigen::Vector3d bad) const
{
  for (int k = 0; k < HALVINGS; ++k)
  {
    const Eigen::Vector3d between = 0.5 * (good + bad);
    (objectionTo(between).empty() ? good : bad) = between;
  }
  return { good, objectionTo(bad) };
}

ToolState Tool::placeTowards(const Eigen::Vector3d& p) const
{
  Problems problems;
  requireFinite("tool point", p, problems);
  throwProblems(problems);
  const std::string objection = objectionTo(p);
  return objection.empty() ? ToolState{ p, "" } : border(state().point, p);
}

ToolState Tool::moveTo(const Eigen::Vector3d& p)
{
  return go(placeTowards(p), true);
}

ToolState Tool::lead(const Eigen::Vector3d& p)
{
  is_led_ = true;
  return go(placeTowards(p), false);
}

void Tool::refresh()
{
  const Eigen::Vector3d p = state().point;
  go({ p, objectionTo(p) }, false);
}

ToolState Tool::go(const ToolState& state, bool is_computed)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_computed && is_led_)
      return { state_.point, "" };
    joint_states_.moveTo(state.point);
    state_ = state;
  }
  if (moved_)
    moved_();
  return state;
}

ToolState Tool::state() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}
}  // namespace pkm_workspace
