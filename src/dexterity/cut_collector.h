// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about parts of boxes.

#include "pack_gather.h"

namespace pkm_workspace
{
/// Collects by which planes the conditions of a criterion cut boxes side by side: visits its conditions.
template <class Real>
class CutCollector
{
  using Mask = MaskOf<Real>;
  static constexpr std::size_t W = Real::WIDTH;

public:
  CutCollector(BoxCuts* results, std::size_t count) : results_(results), count_(std::min(count, W)) {}

  template <class Model>
  void collect(const Model& model, const CenteredBox<Real>& box)
  {
    const auto forms = model.evaluate(box);
    deviation_ = deviationsOf(box);
    outside_ = !everywhere();
    for (std::size_t i = 0; i < 3; ++i)
      outside_ = outside_ | (model.squaredDrive(forms, i).upper() < model.floor(i));
    for (std::size_t lane = 0; lane < count_; ++lane)
      results_[lane].count = 0;
    if (!isSettled())
      model.visit(forms, box, *this);
    for (std::size_t lane = 0; lane < count_; ++lane)
      results_[lane].violated = outside_[static_cast<int>(lane)];
  }

  bool isSettled() const { return !any(!outside_); }

  void scalar(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/) { add(form, form.radius); }

  /// But for points where det A is 0 the last factor alone decides where the first three are positive.
  template <class Alternative>
  void scalarOr(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/, bool exists,
                const Alternative& alternative)
  {
    if (!exists)
      return add(form, form.radius);
    const auto factors = alternative();
    const Mask decides =
        (factors[0].lower() > Real(0.0)) & (factors[1].lower() > Real(0.0)) & (factors[2].lower() > Real(0.0));
    const AffineForm<Real> decisive = select(decides, factors[4], form);
    add(decisive, decisive.radius);
  }

  template <class Enough>
  void anyOf(const Subject& /*subject*/, const AlternativeForms<Real>& forms, int /*power*/, const Enough& /*enough*/)
  {
    const AffineForm<Real> largest = forms.largest();
    add(largest, largest.radius);
  }

  void matrix(const Subject& /*subject*/, const SymmetricForms<Real>& matrix) { addMatrix(matrix, true); }
  void sufficient(const SymmetricForms<Real>& matrix) { addMatrix(matrix, false); }
  template <class Parts>
  void sufficientOr(const SymmetricForms<Real>& matrix, const Parts& /*parts*/)
  {
    sufficient(matrix);
  }
  void necessary(const Subject& subject, const SymmetricForms<Real>& matrix)
  {
    const PlainVector<Real> v = leastEigenvector(matrix).vector;
    necessary(subject, v, v, quadraticForm(matrix, v), 2);
  }

  void necessary(const Subject& /*subject*/, const PlainVector<Real>& /*u*/, const PlainVector<Real>& /*v*/,
                 const AffineForm<Real>& form, int /*power*/)
  {
    exclude(form);
    append(!(form.lower() > Real(0.0)), form, Real(INF), outerOf(form));
  }

  template <class Form>
  void oneSigned(const Subject& /*subject*/, const Enclosed<Real>& /*center*/, const Form& form, int /*power*/)
  {
    const AffineForm<Real> sign = form();
    add(sign, sign.radius);
  }

private:
  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  /// How far delta may be from what it stands for: the box's sides are rounded (CenteredBox), slopes to doubles.
  static PlainVector<Real> deviationsOf(const CenteredBox<Real>& box)
  {
    PlainVector<Real> deviation;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Real size = Real(16.0 * rounding::roundoff<double>()) * (abs(box.center[j]) + box.half_widths[j]) +
                        rounding::underflow<Real>();
      deviation[j] = select(box.half_widths[j] > Real(0.0), size / box.half_widths[j], Real(0.0));
    }
    return deviation;
  }

  void exclude(const AffineForm<Real>& form) { outside_ = outside_ | (form.upper() < Real(0.0)); }

  /// What the planes are moved by for the roundings of the box.
  Real drift(const AffineForm<Real>& form) const
  {
    return abs(form.gradient[0]) * deviation_[0] + abs(form.gradient[1]) * deviation_[1] +
           abs(form.gradient[2]) * deviation_[2];
  }

  Real outerOf(const AffineForm<Real>& form) const
  {
    return form.center + affine::widened(form.radius + drift(form), form.magnitude(), 8);
  }

  /// A condition that holds where the form is not below @p level and fails where it is negative all the same.
  void add(const AffineForm<Real>& form, const Real& level)
  {
    exclude(form);
    append(!(form.lower() > Real(0.0)), form, innerOf(form, level), outerOf(form));
  }

  Real innerOf(const AffineForm<Real>& form, const Real& level) const
  {
    return form.center - affine::widened(level + drift(form), form.magnitude() + level, 8);
  }

  /// With W^T S W for the eigenvectors at the center, the first one for the least eigenvalue, and f the form of that:
  /// S is definite where f >= t if W^T S W - (f - t) e_1 e_1^T is, all over the box (the S-procedure).
  void addMatrix(const SymmetricForms<Real>& matrix, bool is_necessary)
  {
    const Mask open = !(isPositiveDefinite(matrix) | outside_);
    if (!any(open))
      return;
    eigen::Symmetric<Real> center;
    for (std::size_t k = 0; k < 6; ++k)
      center[k] = matrix[k].center;
    const eigen::Basis<Real> basis = eigen::basisOf(center);
    SymmetricForms<Real> turned = congruent(matrix, basis.vector);
    const AffineForm<Real> form = turned[0];
    if (is_necessary)
      exclude(form);
    balance(turned, basis.value[1]);
    turned[0].gradient = { Real(0.0), Real(0.0), Real(0.0) };
    turned[0].center = levelOf(turned);
    const Mask holds = isPositiveDefinite(turned);
    const Real inner = select(holds, innerOf(form, turned[0].center), Real(-INF));
    append(open, form, inner, is_necessary ? outerOf(form) : Real(INF));
  }

  /// Makes all but the first vector shorter, by about the angle that it turns by over the box: what the errors beside
  /// the diagonal cost is of third order then.
  static void balance(SymmetricForms<Real>& turned, const Real& next)
  {
    const Real angle = (turned[5].swing() + turned[4].swing()) / max(next, rounding::underflow<Real>());
    const Enclosed<Real> scale(min(max(angle, Real(0x1p-40)), Real(1.0)), Real(0.0));
    turned[4] = scale * turned[4];
    turned[5] = scale * turned[5];
    for (const std::size_t k : { 1U, 2U, 3U })
      turned[k] = scale * (scale * turned[k]);
  }

  /// Nearly the least first entry that leaves the matrix definite all over the box, whatever the errors of the others.
  static Real levelOf(const SymmetricForms<Real>& m)
  {
    const Real least0 = m[0].radius + (m[4].radius + m[5].radius);
    const Real off1 = m[1].radius + (m[3].radius + m[5].radius);
    const Real off2 = m[2].radius + (m[3].radius + m[4].radius);
    Real most(0.0);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const Real a = pencil::atCorner(m[1], corner) - off1;
      const Real b = pencil::atCorner(m[2], corner) - off2;
      const Real c = pencil::atCorner(m[3], corner);
      const Real x = pencil::atCorner(m[5], corner);
      const Real y = pencil::atCorner(m[4], corner);
      most = max(most, (x * (x * b - y * c) + y * (y * a - x * c)) / (a * b - c * c));
    }
    const Real magnitude = m[1].magnitude() + m[2].magnitude() + m[0].radius;
    return (least0 + most) * Real(1.0 + 0x1p-20) + Real(256.0) * rounding::roundoff<Real>() * magnitude;
  }

  /// Of what there is no room for the last one says that nothing is known to hold.
  void append(Mask useful, const AffineForm<Real>& form, const Real& inner, const Real& outer)
  {
    for (std::size_t lane = 0; lane < count_; ++lane)
    {
      const int at = static_cast<int>(lane);
      BoxCuts& result = results_[lane];
      if (!useful[at])
        continue;
      if (result.count == BoxCuts::MOST)
      {
        result.cut[BoxCuts::MOST - 1].inner = -INF;
        continue;
      }
      result.cut[result.count++] = { { form.gradient[0][at], form.gradient[1][at], form.gradient[2][at] },
                                     inner.below(at),
                                     outer.above(at) };
    }
  }

  BoxCuts* results_;
  std::size_t count_;
  PlainVector<Real> deviation_;
  Mask outside_;
};
}  // namespace pkm_workspace
