// SPDX-License-Identifier: BSD-3-Clause
#include "certificate_json.h"
#include "pkm_workspace/machine/rails.h"
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
namespace certificate
{
namespace
{
Json limitsJson(const Interval& limits)
{
  const auto limit = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return { limit(limits.lower()), limit(limits.upper()) };
}

Json kindJson(const SlidingStrut& strut)
{
  return { { "kind", "sliding_strut" }, { "length", toJson(strut.length) }, { "working_mode", strut.working_mode } };
}

Json kindJson(const TelescopicStrut& strut)
{
  return { { "kind", "telescopic_strut" }, { "length", toJson(strut.length) } };
}

Json kindJson(const Crank& crank)
{
  return { { "kind", "crank" },
           { "along", toJson(crank.along) },
           { "across", toJson(crank.across) },
           { "radius", toJson(crank.radius) },
           { "length", toJson(crank.length) },
           { "working_mode", crank.working_mode },
           { "drive_scale", crank.drive_scale > 0.0 ? Json(crank.drive_scale) : Json() } };
}

/// Rails that are known to share a direction share its number.
void addDirection(const Machine& machine, int i, Json& legs, Json& directions)
{
  Json& leg = legs[static_cast<std::size_t>(i)];
  leg["direction"] = directions.size();
  leg["sense"] = 1;
  for (int j = 0; j < i; ++j)
    if (const int common = parallelSense(machine.leg(j), machine.leg(i)))
    {
      leg["direction"] = legs[static_cast<std::size_t>(j)]["direction"];
      leg["sense"] = common * legs[static_cast<std::size_t>(j)]["sense"].get<int>();
      return;
    }
  directions.push_back(toJson(slidingStrut(machine.leg(i)).axis));
}

Json machineJson(const Machine& machine)
{
  Json directions = Json::array();
  Json legs = Json::array();
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = machine.leg(i);
    legs.push_back(visitLeg([](const auto& kind) { return kindJson(kind); }, leg.kind));
    legs.back()["joint"] = leg.joint;
    legs.back()["center"] = toJson(machine.center(i));
    legs.back()["limits"] = limitsJson(leg.limits);
    if (std::holds_alternative<SlidingStrut>(leg.kind))
      addDirection(machine, i, legs, directions);
  }
  return { { "name", machine.name() }, { "directions", directions }, { "legs", legs } };
}

Json criterionJson(const Machine& machine, const Criterion& criterion)
{
  Json json = { { "aspect", criterion.wantedSign(machine.aspect()) },
                { "joint_limits", criterion.joint_limits && machine.hasJointLimits() } };
  if (criterion.boundsBelow())
    json["psi_min"] = toJson(criterion.leastFactor());
  if (criterion.boundsAbove())
    json["psi_max"] = toJson(criterion.largestFactor());
  return json;
}

Json bodyJson(const Shape& shape)
{
  const GrowingVector low = shape.lower();
  const GrowingVector high = shape.upper();
  const auto pair = [](const GrowingVector& v, int axis) { return Json{ v.fixed[axis], v.per_size[axis] }; };
  const auto all = [&](const GrowingVector& v) { return Json{ pair(v, 0), pair(v, 1), pair(v, 2) }; };
  if (shape.isBox())
    return { { "box", { { "lower", all(low) }, { "upper", all(high) } } } };
  if (shape.ballRadius(1.0))
    return { { "ball", { { "radius", pair(high, 0) } } } };
  return { { "cylinder", { { "radius", pair(high, 0) }, { "lower", pair(low, 2) }, { "upper", pair(high, 2) } } } };
}

}  // namespace

std::string withMember(const Json& object, const std::string& name, const std::string& text)
{
  std::string result = object.dump();
  result.back() = ',';
  return result + Json(name).dump() + ':' + text + '}';
}

std::string fileOf(const Machine& machine, const Criterion& criterion, const Shape* shape, const Claims& claims)
{
  std::string members;
  for (const char* name : { "region", "bound", "boxes", "path" })
  {
    const auto claim = claims.find(name);
    members +=
        (members.empty() ? "" : ",\"" + std::string(name) + "\":") + (claim == claims.end() ? "null" : claim->second);
  }
  const Json header{ { "format", "pkm_workspace certificate" },
                     { "version", 1 },
                     { "written_by", version() },
                     { "geometry_hash", machine.geometryHash() },
                     { "machine", machineJson(machine) },
                     { "criterion", criterionJson(machine, criterion) },
                     { "body", shape ? bodyJson(*shape) : Json() } };
  return withMember(header, "region", members);
}
}  // namespace certificate
}  // namespace pkm_workspace
