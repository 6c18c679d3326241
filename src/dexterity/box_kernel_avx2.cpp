// SPDX-License-Identifier: BSD-3-Clause
#include "box_kernel_impl.h"

namespace pkm_workspace
{
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& model)
{
  return new PackKernel<Pack<4>>(MachineModel<Pack<4>>(model));
}

const BoxKernel* makeAvx2Kernel(const MachineModel<double>& all, const LegSpreads& spreads);
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& all, const LegSpreads& spreads)
{
  using Model = ToleratedModel<Pack<4>>;
  return new PackKernel<Pack<4>, Model>(Model(all, spreads));
}
}  // namespace pkm_workspace
