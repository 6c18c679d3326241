// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/largest_sentence.h"

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/criterion_text.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace
{
/// What is proved not to exist: "cube of a size above 0.644".
std::string tooLarge(const LargestRegion& region, int decimals)
{
  const std::string shape = region.shape->name();
  if (!region.shape->isScaling() && region.size_upper_bound == 0.0)
    return shape + " of any size";
  if (!region.ratio)
    return shape + " of a size above " + roundedUp(region.size_upper_bound, decimals);
  return shape + " with a radius of " + exact(region.ratio->lower) + " to " + exact(region.ratio->upper) +
         " times its height and a volume above " +
         roundedUp(region.volume_upper_bound, decimalsFor(region.volume, region.volume_upper_bound)) + " m^3";
}
}  // namespace

std::optional<JointReaches> reachOver(const LargestRegion& region)
{
  return region.size > 0.0 ? std::optional(reachOver(region.joint_ranges)) : std::nullopt;
}

std::string endingOf(const LargestRegion& region, const Machine& machine, const Criterion& criterion)
{
  return withRemark(sentence(region.message), remarkOnLimits(machine, criterion, reachOver(region)));
}

int decimalsOf(const LargestRegion& region, double accuracy)
{
  return decimalsFor(region.size, region.ratio ? region.size + accuracy : region.size_upper_bound);
}

std::string describe(const LargestRegion& region, const Machine& machine, const RegionQuery& query)
{
  const std::string good = quality(machine, query.criterion);
  const std::string base = query.base_z ? ", standing on z = " + exact(*query.base_z) + " m" : "";
  const std::string turned = query.turns() ? ", turned by this angle about the vertical" : "";
  const std::string found = "every point of the " + region.shape->name() + " with this center and size" + turned +
                            base + (turned.empty() && base.empty() ? " is " : ", is ") + good + "; ";
  return "Proved: " + (region.size > 0.0 ? found : "") + "no " + tooLarge(region, decimalsOf(region, query.accuracy)) +
         ", " + query.place() + (query.turns() ? " and however it is turned about the vertical" : "") +
         ", has all its points " + good + "." +
         (slidesAlongRails(machine, query.criterion) ? " The rails are parallel: the same holds all along them." : "");
}
}  // namespace pkm_workspace
