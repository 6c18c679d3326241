// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/node_context.h"

#include <ros/console.h>

#include <stdexcept>

#include "pkm_workspace/dexterity/defaults.h"
#include "pkm_workspace/dexterity/fitting_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/center_space.h"

namespace pkm_workspace
{
namespace
{
/// Refuses to run where proofs would be void, and what has no bounded answer, before anybody asks.
void requireAnswerable(const Machine& machine, const RegionQuery& query)
{
  const std::string defect = rounding::selfTest();
  if (!defect.empty())
    throw std::runtime_error("nothing can be proved on this computer: " + defect);
  Problems problems;
  validateAccuracy(machine, query, problems);
  throwProblems(problems);
  withRemedy(NODE_REMEDY, [&] { return centerSpace(machine, query); });
}

void logMachine(const UrdfMachine& urdf, const std::string& frame)
{
  for (const auto& warning : urdf.warnings)
    ROS_WARN_STREAM_NAMED("urdf", warning);
  TextStream legs;
  for (const Leg& leg : urdf.machine.legs())
    legs << "; " << leg.joint << " in [" << leg.limits.lower() << ", " << leg.limits.upper() << "] m, "
         << visitLeg([](const auto& kind) { return describe(kind); }, leg.kind);
  ROS_INFO_STREAM_NAMED("urdf", "machine '" << urdf.machine.name() << "' in frame " << frame << legs.str()
                                            << "; geometry " << urdf.machine.geometryHash());
  ROS_INFO_STREAM_NAMED("urdf", urdf.tool_point << (urdf.gap.empty() ? "" : "; ") << urdf.gap);
}

/// Bounds of psi that the machine chooses, or a word on default ones that do not suit it.
void choosePsi(const Machine& machine, const Parameters& parameters, Criterion& criterion)
{
  if (parameters.psi == PsiChoice::AUTO)
  {
    ROS_INFO_STREAM_NAMED("server", describe(chooseBounds(machine, criterion)));
  }
  else if (parameters.default_psi)
  {
    const std::string remark = remarkOnDefaultBounds(machine, criterion, "~psi = auto");
    if (!remark.empty())
      ROS_WARN_STREAM_NAMED("server", remark);
  }
}

std::vector<std::string> framesOf(const ros::NodeHandle& private_node, const std::vector<std::string>& links)
{
  std::vector<std::string> frames;
  for (const std::string& link : links)
    frames.push_back(frameOf(private_node, link));
  return frames;
}

void keepOutOfCollisions(const UrdfMachine& urdf, Criterion& criterion, Problems& problems)
{
  addCollisions(urdf.still_collisions, urdf.open_collisions, "keep_out_collisions = true", criterion.zones, problems);
  validateZones(criterion.zones, criterion.tool_radius, problems);
}
}  // namespace

Loaded load(const ros::NodeHandle& private_node)
{
  const Parameters parameters = loadParameters(private_node);
  const std::string text = loadDescription(private_node);
  Loaded loaded{ parameters, text, readMachine(text, private_node, parameters.urdf), parameters.query };
  if (const double accuracy = parameters.accuracy; accuracy > 0.0)
    loaded.query.accuracy = accuracy;
  else
    loaded.query.accuracy = defaultAccuracy(loaded.urdf.machine, *loaded.query.shape);
  loaded.query.criterion = withJointData(loaded.urdf.machine, loaded.query.criterion);
  Problems problems;
  if (parameters.keep_out_collisions)
    keepOutOfCollisions(loaded.urdf, loaded.query.criterion, problems);
  requireEffect(loaded.query.criterion.tool_radius, loaded.query.criterion.zones, problems);
  requireProvable(loaded.urdf.machine, loaded.query.criterion, problems);
  throwProblems(problems);
  choosePsi(loaded.urdf.machine, parameters, loaded.query.criterion);
  requireAnswerable(loaded.urdf.machine, loaded.query);
  return loaded;
}

NodeContext::NodeContext(const ros::NodeHandle& node_handle, const ros::NodeHandle& private_handle,
                         const Loaded& loaded)
  : node(node_handle)
  , private_node(private_handle)
  , computing(private_handle)
  , deciding(private_handle)
  , parameters(loaded.parameters)
  , urdf_text(loaded.urdf_text)
  , urdf(loaded.urdf)
  , frames(urdf.machine, frameOf(private_handle, urdf.root_link), framesOf(private_handle, urdf.moved_links))
  , panel(private_handle, frames.root().frame, urdf.machine.scale() / 1000.0)
  , query_(loaded.query)
{
  logMachine(urdf, frames.root().frame);
  computing.setCallbackQueue(&worker.queue());
  deciding.setCallbackQueue(&decider.queue());
}

void NodeContext::start()
{
  for (Worker& any : workers_)
    any.start();
}

void NodeContext::stop()
{
  for (Worker& any : workers_)
    any.stop();
}

RegionQuery NodeContext::query() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return query_;
}

void NodeContext::setCriterion(const Criterion& criterion, double accuracy)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  query_.criterion = criterion;
  query_.accuracy = accuracy;
}
}  // namespace pkm_workspace
