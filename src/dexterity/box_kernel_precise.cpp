// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/precise.h"

namespace pkm_workspace
{
/// Found for Precise numbers where the kernel takes lanes out of packs.
static AffineForm<double> laneOf(const AffineForm<Precise>& form, int)
{
  return inDoubles(form);
}
}  // namespace pkm_workspace

#include "box_kernel_impl.h"

namespace pkm_workspace
{
std::unique_ptr<const BoxKernel> preciseKernel(const Machine& machine, const Criterion& criterion)
{
  return std::make_unique<const PackKernel<Precise>>(MachineModel<Precise>(machine, criterion));
}
}  // namespace pkm_workspace
