// SPDX-License-Identifier: BSD-3-Clause
#include "region_option.h"

namespace pkm_workspace
{
namespace cli
{
void RegionOption::declare(Options& options)
{
  options_.declare(options, query_);
  options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
  options.number("size", size_, LENGTH_POSITIVE,
                 "edge, radius, factor or height of the region, as pkm largest tells it");
  options.check({ "shape", "ratio", "center", "size" }, [this, &options](Problems& problems) {
    if (center_.has_value() != size_.has_value())
      problems.push_back("--center and --size go together: they give a region");
    else if (!given() && (options.given("shape") || options.given("proportions") || options.given("ratio")))
      problems.push_back("--shape needs --center and --size: they give a region");
    if (query_.ratio)
      problems.push_back("--ratio of a region that is given is one number: give it twice");
  });
}
}  // namespace cli
}  // namespace pkm_workspace
