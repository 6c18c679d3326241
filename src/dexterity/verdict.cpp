// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
template class MachineModel<double>;

BoxTest::BoxTest(const Machine& machine, const Criterion& criterion)
  : model_(machine, criterion), kernel_(std::move(boxKernels(model_).front()))
{}

BoxVerdict BoxTest::classify(const Box& box) const
{
  BoxVerdict verdict;
  kernel_->classify(&box, 1, &verdict);
  return verdict;
}

double BoxTest::margin(const Eigen::Vector3d& point) const
{
  return model_.margin({ point.x(), point.y(), point.z() });
}
}  // namespace pkm_workspace
