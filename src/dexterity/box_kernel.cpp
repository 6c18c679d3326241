// SPDX-License-Identifier: BSD-3-Clause
#include "box_kernel_impl.h"

#include <cmath>

namespace pkm_workspace
{
BoxKernel::~BoxKernel() = default;

int exponentPerLength(double squared_scale)
{
  int exponent = 0;
  std::frexp(squared_scale, &exponent);
  return -exponent / 2;
}

// In files of their own, compiled for processors that have these instructions.
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& model);
const BoxKernel* makeAvx512Kernel(const MachineModel<double>& model);
const BoxKernel* makeAvx2Kernel(const MachineModel<double>& all, const LegSpreads& spreads);

std::vector<std::unique_ptr<const BoxKernel>> boxKernels(const MachineModel<double>& model)
{
  std::vector<std::unique_ptr<const BoxKernel>> kernels;
#ifdef PKM_WORKSPACE_AVX512
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    kernels.emplace_back(makeAvx512Kernel(model));
#endif
#ifdef PKM_WORKSPACE_AVX2
  if (__builtin_cpu_supports("avx2"))
    kernels.emplace_back(makeAvx2Kernel(model));
#endif
  kernels.push_back(std::make_unique<const PackKernel<Pack<2>>>(MachineModel<Pack<2>>(model)));
  return kernels;
}

std::vector<std::unique_ptr<const BoxKernel>> boxKernels(const MachineModel<double>& all, const LegSpreads& spreads)
{
  std::vector<std::unique_ptr<const BoxKernel>> kernels;
#ifdef PKM_WORKSPACE_AVX2
  if (__builtin_cpu_supports("avx2"))
    kernels.emplace_back(makeAvx2Kernel(all, spreads));
#endif
  using Model = ToleratedModel<Pack<2>>;
  kernels.push_back(std::make_unique<const PackKernel<Pack<2>, Model>>(Model(all, spreads)));
  return kernels;
}
}  // namespace pkm_workspace
