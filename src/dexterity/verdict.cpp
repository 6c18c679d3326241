// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/verdict.h"

#include <algorithm>

namespace pkm_workspace
{
template class LegModels<double>;
template class MachineModel<double>;

namespace
{
/// Boxes narrower than this, relative to the longest strut, are beyond what doubles can settle.
constexpr double LEAST_WIDTH = 1e-13;
/// Boxes that are narrower than this share of what the tolerances come to are not divided: bounds over machines do not
/// become closer with them.
constexpr double LEAST_SHARE = 0.01;

/// The least width that boxes are divided to [m].
double leastWidth(const Machine& machine)
{
  double spread = 0.0;
  for (const Leg& leg : machine.legs())
  {
    const StrutTolerance& by = toleranceOf(leg);
    if (by.isZero())
      continue;
    const SlidingStrut& strut = slidingStrut(leg);
    const double sides =
        std::max({ by.slider[0] + by.platform[0], by.slider[1] + by.platform[1], by.slider[2] + by.platform[2] });
    spread = std::max(
        spread, sides + by.slider_ball + by.platform_ball + by.length + by.zero + by.direction * strut.length.mid());
  }
  return std::max(LEAST_WIDTH * machine.scale(), LEAST_SHARE * spread);
}

std::vector<std::unique_ptr<const BoxKernel>> kernelsFor(const Machine& machine, const MachineModel<double>& model)
{
  if (!machine.hasTolerances())
    return boxKernels(model);
  return boxKernels(model, { spreadOf(slidingStrut(machine.leg(0))), spreadOf(slidingStrut(machine.leg(1))),
                             spreadOf(slidingStrut(machine.leg(2))) });
}
}  // namespace

BoxTest::BoxTest(const Machine& machine, const Criterion& criterion, Precision precision)
  : model_(machine, criterion)
  , keep_out_(pkm_workspace::zonesToKeepOut(criterion.zones, criterion.tool_radius))
  , kernel_(std::move(kernelsFor(machine, model_).front()))
  , scale_(machine.scale())
  , least_width_(leastWidth(machine))
  , is_tolerated_(machine.hasTolerances())
{
  if (model_.condition<AspectSign>().isAsked() && !criterion.settlesAspect(is_tolerated_))
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
  return !box.canBisect(axis) || ((!precise_kernel_ || is_tolerated_) && box.width(axis) < least_width_);
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
  if (!is_tolerated_)
    return model_.margin({ point.x(), point.y(), point.z() });
  double margin;
  kernel_->margins(&point, 1, &margin);
  return margin;
}
}  // namespace pkm_workspace
