// SPDX-License-Identifier: BSD-3-Clause
#include "box_kernel_impl.h"

namespace pkm_workspace
{
BoxKernel::~BoxKernel() = default;

#ifdef PKM_WORKSPACE_AVX2
/// In box_kernel_avx2.cpp, compiled for processors that have these instructions.
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& model);
#endif

std::vector<std::unique_ptr<const BoxKernel>> boxKernels(const MachineModel<double>& model)
{
  std::vector<std::unique_ptr<const BoxKernel>> kernels;
#ifdef PKM_WORKSPACE_AVX2
  if (__builtin_cpu_supports("avx2"))
    kernels.emplace_back(makeAvx2Kernel(model));
#endif
  kernels.push_back(std::make_unique<const PackKernel<2>>(model));
  return kernels;
}
}  // namespace pkm_workspace
