// SPDX-License-Identifier: BSD-3-Clause
#include "box_kernel_impl.h"

namespace pkm_workspace
{
const BoxKernel* makeAvx512Kernel(const MachineModel<double>& model)
{
  return new PackKernel<Pack<8>>(MachineModel<Pack<8>>(model));
}
}  // namespace pkm_workspace
