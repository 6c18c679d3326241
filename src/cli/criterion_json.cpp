// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "output.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/joint_data.h"
#include "pkm_workspace/machine/zone_keys.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Infinite heights are null.
Json zoneJson(const Zone& zone)
{
  Json json = { { "kind", ZONE_KINDS[static_cast<std::size_t>(zone.kind)] }, { "name", zone.name } };
  for (const auto& [key, values] : numbersOf(zone))
    if (values.size() == 1)
      json[key] = std::isfinite(values[0]) ? Json(values[0]) : Json();
    else
      json[key] = values;
  return json;
}
}  // namespace

Json toJson(const Criterion& criterion)
{
  Json json = { { "set", name(criterion.set) },
                { "aspect", name(criterion.aspect) },
                { "joint_limits", criterion.joint_limits } };
  if (criterion.hinge_limits)
    json["hinge_limits"] = true;
  for (const Zone& zone : criterion.zones)
    json[ZONE_USES[static_cast<std::size_t>(zone.use)]].push_back(zoneJson(zone));
  if (criterion.tool_radius > 0.0)
    json["tool_radius"] = criterion.tool_radius;
  for (const JointDatum& datum : JOINT_DATA)
    if (datum.isAskedBy(criterion))
      json[datum.name] = criterion.*datum.values;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.isAskedBy(criterion))
      json[bound.name] = criterion.*bound.value;
  return json;
}
}  // namespace cli
}  // namespace pkm_workspace
