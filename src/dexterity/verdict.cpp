// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/verdict.h"

#include <algorithm>
#include <vector>

#include "pkm_workspace/dexterity/eigen_witness.h"

namespace pkm_workspace
{
template class MachineModel<double>;

namespace
{
using Forms = MachineForms<double>;

/// What the radicands say: OUTSIDE when a leg is below its floor everywhere, INSIDE when none is anywhere.
BoxVerdict classifyReach(const MachineModel<double>& model, const Forms& forms)
{
  bool everywhere = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (forms.radicand[i].upper() < model.floor(i))
      return BoxVerdict::OUTSIDE;
    everywhere = everywhere && forms.radicand[i].lower() > model.floor(i);
  }
  return everywhere ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}

/// What the joint limits say.
BoxVerdict classifyLimits(const MachineModel<double>& model, const Forms& forms, const CenteredBox<double>& box)
{
  bool everywhere = true;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (int side = 0; side < 2; ++side)
    {
      if (!model.limited(leg, side))
        continue;
      const AffineForm<double> margin = model.limitMargin(leg, side, forms, box);
      if (margin.upper() < 0.0)
        return BoxVerdict::OUTSIDE;
      everywhere = everywhere && margin.lower() >= 0.0;
    }
  return everywhere ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}

/// What the sign of det A says about the whole box.
BoxVerdict classifyOrientation(const MachineModel<double>& model, const Forms& forms)
{
  if (!model.oriented())
    return BoxVerdict::INSIDE;
  const AffineForm<double> orientation = model.orientation(forms);
  if (orientation.upper() < 0.0)
    return BoxVerdict::OUTSIDE;
  return orientation.lower() > 0.0 ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}

/// What the transmission factors say (design, section 3, items 1 and 2).
BoxVerdict classifyFactors(const MachineModel<double>& model, const Forms& forms)
{
  bool definite = true;
  for (const bool upper : { true, false })
  {
    const SymmetricForms<double> matrix = upper ? model.upperMatrix(forms) : model.lowerMatrix(forms);
    if (isPositiveDefinite(matrix))
      continue;
    definite = false;
    if (quadraticForm(matrix, leastEigenvector(matrix).vector).upper() < 0.0)
      return BoxVerdict::OUTSIDE;
  }
  return definite ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}

BoxVerdict both(BoxVerdict a, BoxVerdict b)
{
  if (a == BoxVerdict::OUTSIDE || b == BoxVerdict::OUTSIDE)
    return BoxVerdict::OUTSIDE;
  return a == BoxVerdict::INSIDE ? b : a;
}
}  // namespace

BoxTest::BoxTest(const Machine& machine, const Criterion& criterion) : model_(machine, criterion) {}

BoxVerdict BoxTest::classify(const Box& box) const
{
  const CenteredBox<double> centered(box);
  const Forms forms = model_.evaluate(centered);
  BoxVerdict verdict = classifyReach(model_, forms);
  if (verdict != BoxVerdict::OUTSIDE)
    verdict = both(verdict, classifyLimits(model_, forms, centered));
  if (verdict == BoxVerdict::OUTSIDE)
    return verdict;
  if (model_.criterion().set == Criterion::Set::REACHABLE)
    return both(verdict, classifyOrientation(model_, forms));
  verdict = both(verdict, classifyFactors(model_, forms));
  if (verdict == BoxVerdict::OUTSIDE || !model_.oriented())
    return verdict;
  // Where S_min is definite det A has no zero: one point settles its sign.
  const AffineForm<double> orientation = model_.orientationAtCenter(forms);
  if (verdict == BoxVerdict::INSIDE && orientation.lower() > 0.0)
    return BoxVerdict::INSIDE;
  if (orientation.upper() < 0.0 && (verdict == BoxVerdict::INSIDE || model_.orientation(forms).upper() < 0.0))
    return BoxVerdict::OUTSIDE;
  return BoxVerdict::UNDECIDED;
}

BoxVerdict BoxTest::verify(const Box& box, double min_width, std::int64_t max_boxes) const
{
  std::vector<Box> open = { box };
  bool inside = false;
  bool outside = false;
  for (std::int64_t boxes = 0; !open.empty(); ++boxes)
  {
    const Box part = open.back();
    open.pop_back();
    const BoxVerdict verdict = classify(part);
    inside = inside || verdict == BoxVerdict::INSIDE;
    outside = outside || verdict == BoxVerdict::OUTSIDE;
    if ((inside && outside) || boxes >= max_boxes)
      return BoxVerdict::UNDECIDED;
    if (verdict != BoxVerdict::UNDECIDED)
      continue;
    const int axis = part.widestAxis();
    if (part.width(axis) <= min_width || !part.canBisect(axis))
      return BoxVerdict::UNDECIDED;
    const auto halves = part.bisect(axis);
    open.push_back(halves.second);
    open.push_back(halves.first);
  }
  return inside ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE;
}

double BoxTest::margin(const Eigen::Vector3d& point) const
{
  const CenteredBox<double> box(Box{ point, point });
  const Forms forms = model_.evaluate(box);
  const double scale = model_.squaredScale();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, (forms.radicand[i].center - model_.floor(i)) / scale);
  if (least < 0.0)
    return least;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (int side = 0; side < 2; ++side)
      if (model_.limited(leg, side))
        least = std::min(least, model_.limitMargin(leg, side, forms, box).center / std::sqrt(scale));
  if (model_.oriented())
    least = std::min(least, model_.orientationAtCenter(forms).center / (scale * std::sqrt(scale)));
  if (model_.criterion().set == Criterion::Set::DEXTROUS)
    for (const auto& matrix : { model_.upperMatrix(forms), model_.lowerMatrix(forms) })
      least = std::min(least, leastEigenvector(matrix).value / scale);
  return least;
}
}  // namespace pkm_workspace
