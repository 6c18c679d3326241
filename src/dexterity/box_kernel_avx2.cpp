// SPDX-License-Identifier: BSD-3-Clause
#include "box_kernel_impl.h"

namespace pkm_workspace
{
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& model)
{
  return new PackKernel<Pack<4>>(MachineModel<Pack<4>>(model));
}
}  // namespace pkm_workspace
