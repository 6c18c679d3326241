// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about necessary forms.

#include "pack_gather.h"

namespace pkm_workspace
{
/// Collects what a criterion makes necessary over boxes side by side, for lanes one by one.
template <class Real>
class FormCollector
{
  using Mask = MaskOf<Real>;
  using Point = std::array<Real, 3>;
  static constexpr std::size_t W = Real::WIDTH;

public:
  /// Keeps a reference.
  explicit FormCollector(const MachineModel<Real>& model) : model_(model)
  {
    int exponent = 0;
    frexp(model.squaredScale()[0], &exponent);
    for (int power = 0; power < 4; ++power)
      per_scale_[static_cast<std::size_t>(power)] = Real(ldexp(1.0, -exponent / 2 * power));
  }

  void collect(const CenteredBox<Real>& box, NecessaryForms* results, std::size_t count) const
  {
    const MachineForms<Real> forms = model_.evaluate(box);
    Mask violated = !everywhere();
    for (std::size_t i = 0; i < 3; ++i)
      violated = violated | (forms.legs[i].squared_drive.upper() < model_.floor(i));
    const Criterion& criterion = model_.criterion();
    begin(results, count, violated);
    if (criterion.boundsAbove())
      appendMatrix(model_.upperMatrix(forms), results, count);
    if (criterion.boundsBelow())
      appendMatrix(model_.lowerMatrix(forms), results, count);
    for (std::size_t i = 0; i < 3 && !criterion.boundsAbove(); ++i)
      append(scaled(forms.legs[i].squared_drive, 2), everywhere(), results, count);
    if (criterion.boundsCondition())
    {
      ConditionForms<Real> condition;
      model_.conditionForms(forms, condition);
      for (const AffineForm<Real>& form : condition.necessary)
        append(form, everywhere(), results, count);
    }
    if (model_.oriented())
      appendOrientation(forms, results, count);
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (int side = 0; side < 2; ++side)
        if (model_.limited(leg, side))
          append(scaled(model_.limitMargin(leg, side, forms, box), 1), everywhere(), results, count);
  }

private:
  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  void appendMatrix(SymmetricForms<Real> matrix, NecessaryForms* results, std::size_t count) const
  {
    for (AffineForm<Real>& entry : matrix)
      entry = scaled(entry, 2);
    for (std::size_t lane = 0; lane < W && lane < count; ++lane)
    {
      SymmetricForms<double>& result = results[lane].matrix[results[lane].matrices++];
      for (std::size_t entry = 0; entry < 6; ++entry)
        result[entry] = laneOf(matrix[entry], static_cast<int>(lane));
    }
    if constexpr (W == 1)
      appendPlane(matrix, results, count);
    else
      append(quadraticForm(matrix, leastEigenvector(matrix).vector), everywhere(), results, count);
  }

  /// The forms for the two least eigenvectors and two between them: no cut of the matrix in doubles could be as exact.
  void appendPlane(const SymmetricForms<Real>& matrix, NecessaryForms* results, std::size_t count) const
  {
    eigen::Symmetric<Real> center;
    for (std::size_t k = 0; k < 6; ++k)
      center[k] = matrix[k].center;
    const auto basis = eigen::basisOf(center);
    for (const double share : { 0.0, 1.0, 0.5, -0.5 })
    {
      const Point v = eigen::combined(Real(1.0 - std::abs(share)), basis.vector[0], Real(share), basis.vector[1]);
      append(quadraticForm(matrix, v), everywhere(), results, count);
    }
  }

  /// Where the sign of det A at one point is the one everywhere its form helps only where it is wrong.
  void appendOrientation(const MachineForms<Real>& forms, NecessaryForms* results, std::size_t count) const
  {
    Mask useful = everywhere();
    if (model_.criterion().settlesAspect())
      useful = model_.orientationAtCenter(forms).lower() < Real(0.0);
    if (any(useful))
      append(scaled(model_.orientation(forms), 3), useful, results, count);
  }

  /// The form over a power of the machine's scale, to be without unit: powers of two, which round nothing.
  AffineForm<Real> scaled(const AffineForm<Real>& form, std::size_t power) const
  {
    const Real factor = per_scale_[power];
    return { form.center * factor,
             { form.gradient[0] * factor, form.gradient[1] * factor, form.gradient[2] * factor },
             form.radius * factor };
  }

  static void begin(NecessaryForms* results, std::size_t count, Mask violated)
  {
    for (std::size_t lane = 0; lane < W && lane < count; ++lane)
    {
      results[lane].violated = violated[static_cast<int>(lane)];
      results[lane].matrices = 0;
      results[lane].forms = 0;
    }
  }

  static void append(const AffineForm<Real>& form, Mask useful, NecessaryForms* results, std::size_t count)
  {
    for (std::size_t lane = 0; lane < W && lane < count; ++lane)
      if (useful[static_cast<int>(lane)])
        results[lane].form[results[lane].forms++] = laneOf(form, static_cast<int>(lane));
  }

  const MachineModel<Real>& model_;
  std::array<Real, 4> per_scale_;  ///< powers of about 1 / the longest strut
};
}  // namespace pkm_workspace
