// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "common_options.h"
#include "pkm_workspace/import/zone_file.h"
#include "pkm_workspace/machine/zone_keys.h"

namespace pkm_workspace
{
namespace cli
{
void declareZones(Options& options, Criterion& criterion)
{
  static const std::string kinds = zoneWords();
  const auto declare = [&](const std::string& name, Zone::Use use, const std::string& help) {
    options.lists(name, "KIND NUMBER..", help + ": " + kinds + " [m]",
                  [&criterion, use](const Words& words) { criterion.zones.push_back(readZone(use, words)); });
  };
  declare("keep-in", Zone::Use::KEEP_IN, "a zone that the tool keeps within");
  declare("keep-out", Zone::Use::KEEP_OUT, "a zone that the tool keeps out of");
  options.repeated(
      "zones", "FILE", "zones of both sorts, and the tool's radius, in YAML (docs/conditions.md)",
      [&criterion, &options](const Words& words) {
        const ZoneFile file = readZoneFile(words[0]);
        criterion.zones.insert(criterion.zones.end(), file.zones.begin(), file.zones.end());
        if (file.tool_radius != 0.0 && options.given("tool-radius"))
          throw std::invalid_argument("the file has a tool_radius: give --tool-radius after it, or not");
        if (file.tool_radius != 0.0 && criterion.tool_radius != 0.0 && file.tool_radius != criterion.tool_radius)
          throw std::invalid_argument("its tool_radius is another than that of the file before it");
        if (file.tool_radius != 0.0)
          criterion.tool_radius = file.tool_radius;
      });
  options.number("tool-radius", criterion.tool_radius, LENGTH_NOT_NEGATIVE,
                 "by which all surfaces of zones are moved away from what the tool keeps to");
  options.check({ "tool-radius" }, [&criterion, &options](Problems& problems) {
    if (!options.has("keep-out-collisions") || !options.given("keep-out-collisions"))
      requireEffect(criterion.tool_radius, criterion.zones, problems);
  });
}

void MachineOptions::declareCollisions(Options& options)
{
  options.flag(
      "keep-out-collisions", keeps_out_collisions_,
      "keep out of the collision geometry of links that do not move: boxes, cylinders and spheres of the URDF");
}

void MachineOptions::addCollisions(Criterion& criterion, Problems& problems) const
{
  if (!keeps_out_collisions_)
    return;
  pkm_workspace::addCollisions(urdf_->still_collisions, urdf_->open_collisions, "--keep-out-collisions",
                               criterion.zones, problems);
  validateZones(criterion.zones, criterion.tool_radius, problems);
}
}  // namespace cli
}  // namespace pkm_workspace
