// SPDX-License-Identifier: BSD-3-Clause
#include "rows.h"

int main(int argc, char** argv)
{
  pkm_workspace::bench::addLargestRows();
  pkm_workspace::bench::addHardRows();
  pkm_workspace::bench::addLegRows();
  pkm_workspace::bench::addConditionRows();
  pkm_workspace::bench::addVerificationRows();
  pkm_workspace::bench::addPavingRows();
  pkm_workspace::bench::addBusyRows();
  pkm_workspace::bench::addPathRows();
  pkm_workspace::bench::addPlacementRows();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
