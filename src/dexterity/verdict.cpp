// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
template class LegModels<double>;
template class MachineModel<double>;

namespace
{
/// Boxes narrower than this, relative to the longest strut, are beyond what doubles can settle.
constexpr double LEAST_WIDTH = 1e-13;
}  // namespace

BoxTest::BoxTest(const Machine& machine, const Criterion& criterion, Precision precision)
  : model_(machine, criterion)
  , keep_out_(pkm_workspace::zonesToKeepOut(criterion.zones, criterion.tool_radius))
  , kernel_(std::move(boxKernels(model_).front()))
  , scale_(machine.scale())
{
  if (model_.condition<AspectSign>().isAsked() && !criterion.settlesAspect())
    spheres_ = strutSpheres(machine);
  if (precision == Precision::MULTIPLE)
    precise_kernel_ = preciseKernel(machine, criterion);
}

const BoxKernel* BoxTest::finerKernel(const Box& box) const
{
  return precise_kernel_ && box.maxWidth() < NARROW * scale_ ? precise_kernel_.get() : nullptr;
}

bool BoxTest::isBeyondPrecision(const Box& box) const
{
  const int axis = box.widestAxis();
  return !box.canBisect(axis) || (!precise_kernel_ && box.width(axis) < LEAST_WIDTH * scale_);
}

BoxVerdict BoxTest::classify(const Box& box) const
{
  BoxVerdict verdict;
  kernel_->classify(&box, 1, &verdict);
  if (verdict == BoxVerdict::UNDECIDED)
    if (const BoxKernel* finer = finerKernel(box))
      finer->classify(&box, 1, &verdict);
  return verdict;
}

double BoxTest::margin(const Eigen::Vector3d& point) const
{
  return model_.margin({ point.x(), point.y(), point.z() });
}
}  // namespace pkm_workspace
