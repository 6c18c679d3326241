// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "criterion_fields.h"
#include "pkm_workspace/dexterity/criterion_bytes.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/zone_message.h"

namespace pkm_workspace
{
Hypotheses toMessage(const Premises& premises, double accuracy)
{
  const Criterion& criterion = premises.criterion;
  Hypotheses message;
  message.machine = premises.machine;
  message.geometry_hash = premises.geometry_hash;
  message.root = toMessage(premises.root);
  message.version = premises.version;
  message.set = toNumber(criterion.set);
  message.aspect = toNumber(criterion.aspect);
  for (std::size_t k = 0; k < CRITERION_BOUNDS.size(); ++k)
    message.*FIELDS[k].hypotheses = CRITERION_BOUNDS[k].isAskedBy(criterion) ? criterion.*FIELDS[k].value : 0.0;
  for (std::size_t k = 0; k < JOINT_DATA.size(); ++k)
    if (JOINT_DATA[k].isAskedBy(criterion))
      std::copy_n((criterion.*JOINT_FIELDS[k].values).begin(), 3, (message.*JOINT_FIELDS[k].hypotheses).begin());
  for (const Eigen::Vector3d& axis : premises.ball_axes)
    message.ball_axes.push_back(asVector(axis));
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    if (const std::vector<double> values = numbersOf(kind, premises.tolerances); values != std::vector<double>{ 0.0 })
    {
      message.tolerances.emplace_back();
      message.tolerances.back().kind = kind.name;
      message.tolerances.back().values = values;
      message.tolerances.back().unit = kind.unit;
    }
  message.joint_limits = criterion.joint_limits;
  message.hinge_limits = criterion.hinge_limits;
  for (const Zone& zone : criterion.zones)
    message.zones.push_back(toMessage(zone));
  message.tool_radius = criterion.tool_radius;
  message.accuracy = accuracy;
  return message;
}

Premises fromMessage(const Hypotheses& hypotheses)
{
  Criterion criterion;
  criterion.set = fromNumber(hypotheses.set, SET_NAMES, Criterion::Set::REACHABLE);
  criterion.aspect = fromNumber(hypotheses.aspect, ASPECT_NAMES, Criterion::Aspect::OWN);
  for (const MessageFields& fields : FIELDS)
    criterion.*fields.value = hypotheses.*fields.hypotheses;
  for (const JointFields& fields : JOINT_FIELDS)
    std::copy_n((hypotheses.*fields.hypotheses).begin(), 3, (criterion.*fields.values).begin());
  criterion.joint_limits = hypotheses.joint_limits;
  criterion.hinge_limits = hypotheses.hinge_limits;
  for (const ToolZone& zone : hypotheses.zones)
    criterion.zones.push_back(fromMessage(zone));
  criterion.zones = seenFrom(fromMessage(hypotheses.root), criterion.zones);
  criterion.tool_radius = hypotheses.tool_radius;
  return { hypotheses.machine, hypotheses.geometry_hash, canonical(criterion), fromMessage(hypotheses.root),
           hypotheses.version };
}

std::string captionOf(const Premises& premises, const std::string& precision, double accuracy)
{
  TextStream text;
  text << describe(premises);
  if (!precision.empty())
    text << ", " << precision << ' ' << accuracy << " m";
  return text.str();
}
}  // namespace pkm_workspace
