// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about convex hulls.

#include "pack_gather.h"

namespace pkm_workspace
{
/// The verdicts on convex hulls side by side: visits the conditions of a criterion. What is affine over a hull is
/// least, or not definite, at one of its points; so the forms are made over the box that holds the hull, and asked at
/// these. They hold some roundings around it, too: parts of a hull whose corners were rounded leave no gaps.
template <class Real>
class HullLook
{
  using Mask = MaskOf<Real>;
  static constexpr std::size_t N = std::tuple_size<SmallHull>::value;
  /// By so many roundings of the coordinates what is said holds around a hull.
  static constexpr double AROUND = 16.0;

public:
  HullLook(const SmallHull* hulls, std::size_t count)
  {
    std::array<PlainVector<Real>, N> points;
    for (std::size_t k = 0; k < N; ++k)
      points[k] = gatherPoint(hulls, count, k);
    PlainVector<Real> lower = points[0];
    PlainVector<Real> upper = points[0];
    for (const PlainVector<Real>& point : points)
      for (std::size_t j = 0; j < 3; ++j)
      {
        lower[j] = min(lower[j], point[j]);
        upper[j] = max(upper[j], point[j]);
      }
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Real around = Real(AROUND * rounding::roundoff<double>()) * max(abs(lower[j]), abs(upper[j]));
      lower[j] = lower[j] - around;
      upper[j] = upper[j] + around;
      middle_[j] = Real(0.0);
    }
    box_ = CenteredBox<Real>(lower, upper);
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Real size = Real(2.0 * AROUND * rounding::roundoff<double>()) * (abs(box_.center[j]) + box_.half_widths[j]);
      error_[j] = select(box_.half_widths[j] > Real(0.0), size / box_.half_widths[j], Real(0.0));
      for (std::size_t k = 0; k < N; ++k)
      {
        const Real offset = (points[k][j] - box_.center[j]) / box_.half_widths[j];
        delta_[k][j] = select(box_.half_widths[j] > Real(0.0), offset, Real(0.0));
        middle_[j] = middle_[j] + delta_[k][j] * Real(1.0 / N);
      }
    }
  }

  template <class Model>
  void visit(const Model& model)
  {
    const auto forms = model.evaluate(box_);
    inside_ = everywhere();
    outside_ = !everywhere();
    for (std::size_t i = 0; i < 3; ++i)
      exclude(model.squaredDrive(forms, i) + Enclosed<Real>(-model.floor(i), Real(0.0)));
    if (!isSettled())
      model.visit(forms, box_, *this);
  }

  BoxVerdict verdict(int lane) const
  {
    return outside_[lane] ? BoxVerdict::OUTSIDE : inside_[lane] ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
  }

  bool isSettled() const { return !any(!outside_); }

  void scalar(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/) { require(form); }

  template <class Alternative>
  void scalarOr(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/, bool /*exists*/,
                const Alternative& /*alternative*/)
  {
    require(form);
  }

  template <class Enough>
  void anyOf(const Subject& /*subject*/, const AlternativeForms<Real>& forms, int /*power*/, const Enough& enough)
  {
    Mask holds = !everywhere(), fails = everywhere();
    for (std::size_t k = 0; k < forms.count; ++k)
    {
      holds = holds | (leastOf(forms.form[k]) > Real(0.0));
      fails = fails & (leastOf(-forms.form[k]) > Real(0.0));
    }
    outside_ = outside_ | fails;
    if (any(inside_ & !(holds | outside_)))
      holds = holds | (leastOf(enough()) > Real(0.0));
    inside_ = inside_ & holds;
  }

  void matrix(const Subject& subject, const SymmetricForms<Real>& matrix)
  {
    sufficient(matrix);
    if (any(!(inside_ | outside_)))
      necessary(subject, matrix);
  }
  template <class Parts>
  void sufficientOr(const SymmetricForms<Real>& matrix, const Parts& /*parts*/)
  {
    sufficient(matrix);
  }
  void necessary(const Subject& /*subject*/, const SymmetricForms<Real>& matrix)
  {
    exclude(quadraticForm(matrix, leastEigenvector(matrix, middle_).vector));
  }

  void sufficient(const SymmetricForms<Real>& matrix)
  {
    if (any(inside_))
      inside_ = inside_ & isPositiveDefinite(widened(matrix), delta_);
  }

  void necessary(const Subject& /*subject*/, const PlainVector<Real>& /*u*/, const PlainVector<Real>& /*v*/,
                 const AffineForm<Real>& form, int /*power*/)
  {
    exclude(form);
  }

  /// One point settles the sign where the other conditions hold, as hulls are connected.
  template <class Form>
  void oneSigned(const Subject& /*subject*/, const Enclosed<Real>& /*center*/, const Form& form, int /*power*/)
  {
    const AffineForm<Real> sign = form();
    exclude(sign);
    outside_ = outside_ | (inside_ & (leastAt(-sign, middle_) > Real(0.0)));
    inside_ = inside_ & (leastAt(sign, middle_) > Real(0.0));
  }

private:
  static Mask everywhere() { return Real(1.0) > Real(0.0); }
  static PlainVector<Real> gatherPoint(const SmallHull* hulls, std::size_t count, std::size_t point)
  {
    double coordinates[3][Real::WIDTH];
    for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
      for (std::size_t k = 0; k < 3; ++k)
        coordinates[k][lane] = hulls[lane < count ? lane : count - 1][point].data()[k];
    return pointOf<Real>(coordinates);
  }

  /// A lower bound of the form on the hulls.
  Real leastOf(const AffineForm<Real>& form) const
  {
    Real least(INF);
    for (const PlainVector<Real>& delta : delta_)
      least = min(least, leastAt(form, delta));
    return least;
  }

  /// The same at a point.
  Real leastAt(const AffineForm<Real>& form, const PlainVector<Real>& delta) const
  {
    const AffineForm<Real> wide = widened(form);
    const Real value = form.gradient[0] * delta[0] + form.gradient[1] * delta[1] + form.gradient[2] * delta[2];
    return form.center + value - affine::widened(wide.radius, wide.magnitude(), 16);
  }

  /// With the errors of delta.
  AffineForm<Real> widened(AffineForm<Real> form) const
  {
    const Real drift =
        abs(form.gradient[0]) * error_[0] + abs(form.gradient[1]) * error_[1] + abs(form.gradient[2]) * error_[2];
    form.radius = affine::widened(form.radius + drift, form.magnitude(), 8);
    return form;
  }
  SymmetricForms<Real> widened(SymmetricForms<Real> matrix) const
  {
    for (AffineForm<Real>& entry : matrix)
      entry = widened(entry);
    return matrix;
  }

  void exclude(const AffineForm<Real>& form) { outside_ = outside_ | (leastOf(-form) > Real(0.0)); }

  void require(const AffineForm<Real>& form)
  {
    exclude(form);
    inside_ = inside_ & (leastOf(form) > Real(0.0));
  }

  CenteredBox<Real> box_;
  std::array<PlainVector<Real>, N> delta_;
  PlainVector<Real> error_;  ///< of each delta
  PlainVector<Real> middle_;
  Mask inside_;
  Mask outside_;
};
}  // namespace pkm_workspace
