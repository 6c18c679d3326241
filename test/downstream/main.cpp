// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/region/largest_region.h"
#include "pkm_workspace/version.h"

int main()
{
  const pkm_workspace::Machine machine = pkm_workspace::orthoglide();
  const pkm_workspace::LargestRegion region = pkm_workspace::findLargestRegion(machine, {});
  std::cout << machine.name() << ' ' << machine.geometryHash() << ", pkm_workspace " << pkm_workspace::version() << '\n'
            << "largest cube: edge from " << region.size << " to " << region.size_upper_bound << " m\n";
  return region.status == pkm_workspace::LargestRegion::Status::PROVEN ? 0 : 1;
}
