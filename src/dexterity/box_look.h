// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that gives verdicts.

#include "pack_gather.h"

namespace pkm_workspace
{
/// What is asked of boxes side by side besides their verdicts.
template <class Real>
struct Question
{
  bool wants_worst = false;
  bool is_limited = false;   ///< only points where the slack is not negative count for INSIDE
  AffineForm<Real> slack{};  ///< offset - normal . p of the half-space
  AffineForm<Real> worst{};  ///< the answer: the lowest form v^T S v
};

/// The verdicts on boxes side by side (docs/theory.md, affine forms): visits the conditions of a criterion.
template <class Real>
class BoxLook
{
  using Mask = MaskOf<Real>;

public:
  /// @param forms of the model
  template <class Model, class Forms>
  BoxLook(const Model& model, const Forms& forms, Question<Real>& question)
    : question_(question), inside_(everywhere()), outside_(!everywhere())
  {
    for (std::size_t i = 0; i < 3; ++i)
      outside_ = outside_ | (model.squaredDrive(forms, i).upper() < model.floor(i));
  }

  BoxVerdict verdict(int lane) const
  {
    return outside_[lane] ? BoxVerdict::OUTSIDE : inside_[lane] ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
  }

  bool isSettled() const { return !any(!outside_); }

  void scalar(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/) { require(form); }

  /// Near a double zero the alternative tells more; boxes alone do well without.
  template <class Alternative>
  void scalarOr(const Subject& /*subject*/, const AffineForm<Real>& form, int /*power*/, bool exists,
                const Alternative& alternative)
  {
    const Mask before = inside_;
    require(form);
    const Mask open = before & !(inside_ | outside_);
    if (!question_.is_limited || !exists || !any(open))
      return;
    Mask holds = open;
    for (const AffineForm<Real>& factor : alternative())
      holds = holds & isPositive(factor);
    inside_ = inside_ | holds;
  }

  template <class Enough>
  void anyOf(const Subject& /*subject*/, const AlternativeForms<Real>& forms, int /*power*/, const Enough& enough)
  {
    Mask holds = !everywhere(), fails = everywhere();
    for (std::size_t k = 0; k < forms.count; ++k)
    {
      holds = holds | isPositive(forms.form[k]);
      fails = fails & (forms.form[k].upper() < Real(0.0));
    }
    outside_ = outside_ | fails;
    if (any(inside_ & !(holds | outside_)))
      holds = holds | isPositive(enough());
    inside_ = inside_ & holds;
  }

  void matrix(const Subject& /*subject*/, const SymmetricForms<Real>& matrix) { lookAtMatrix(matrix, true); }
  void sufficient(const SymmetricForms<Real>& matrix) { lookAtMatrix(matrix, false); }
  /// @param parts calls a function for forms and matrices that are enough together, until it says false
  template <class Parts>
  void sufficientOr(const SymmetricForms<Real>& matrix, const Parts& parts)
  {
    const Mask before = inside_;
    sufficient(matrix);
    Mask holds = before & !(inside_ | outside_);
    if (!any(holds))
      return;
    parts(Conjunction{ *this, holds });
    inside_ = inside_ | holds;
  }
  void necessary(const Subject& /*subject*/, const SymmetricForms<Real>& matrix)
  {
    if (any(!(outside_ | isDefiniteAtCenter(matrix))))
      exclude(quadraticForm(matrix, leastEigenvector(matrix).vector));
  }
  void necessary(const Subject& /*subject*/, const PlainVector<Real>& /*u*/, const PlainVector<Real>& /*v*/,
                 const AffineForm<Real>& form, int /*power*/)
  {
    exclude(form);
  }

  /// One point settles the sign; not within a half-space, where it may lie beyond.
  template <class Form>
  void oneSigned(const Subject& /*subject*/, const Enclosed<Real>& center, const Form& form, int /*power*/)
  {
    if (question_.is_limited)
      return;
    const Mask wrong = center.upper() < Real(0.0);
    outside_ = outside_ | (inside_ & wrong);
    inside_ = inside_ & (center.lower() > Real(0.0));
    if (any(wrong & !outside_))
      outside_ = outside_ | (wrong & (form().upper() < Real(0.0)));
  }

private:
  /// Where forms are positive and matrices definite.
  struct Conjunction
  {
    const BoxLook& look;
    Mask& holds;

    bool operator()(const AffineForm<Real>& form) const { return keep(look.isPositive(form)); }
    bool operator()(const SymmetricForms<Real>& matrix) const { return keep(isPositiveDefinite(matrix)); }
    bool keep(const Mask& mask) const
    {
      holds = holds & mask;
      return any(holds);
    }
  };

  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  /// No point is good where the form is negative all over the box.
  void exclude(const AffineForm<Real>& form) { outside_ = outside_ | (form.upper() < Real(0.0)); }

  Mask isPositive(const AffineForm<Real>& form) const
  {
    Mask holds = form.lower() > Real(0.0);
    if (question_.is_limited)
      holds = holds | (lowered(form, multiplier(form, question_.slack), question_.slack).lower() > Real(0.0));
    return holds;
  }

  void require(const AffineForm<Real>& form)
  {
    exclude(form);
    inside_ = inside_ & isPositive(form);
  }

  /// @param is_necessary whether points where the matrix is not semidefinite are bad
  void lookAtMatrix(const SymmetricForms<Real>& matrix, bool is_necessary)
  {
    const bool counts = question_.wants_worst || any(inside_);
    Mask definite = counts ? isPositiveDefinite(matrix) : !everywhere();
    // a vector with v^T S v < 0 exists only where S is not definite at the center
    const Mask open = !(definite | outside_);
    if (any(question_.wants_worst ? open : open & !isDefiniteAtCenter(matrix)))
      definite = definite | lookAtVector(matrix, definite, is_necessary);
    inside_ = inside_ & definite;
  }

  /// Tries the vector of the least eigenvalue. @return where the matrix is definite on the half-space
  Mask lookAtVector(const SymmetricForms<Real>& matrix, Mask definite, bool is_necessary)
  {
    const PlainVector<Real> v = leastEigenvector(matrix).vector;
    AffineForm<Real> form = quadraticForm(matrix, v);
    if (is_necessary)
      exclude(form);
    Mask holds = !everywhere();
    if (question_.is_limited)
    {
      const SymmetricForms<Real> less = loweredAlong(matrix, v, multiplier(form, question_.slack));
      holds = isPositiveDefinite(less);
      form = quadraticForm(less, v);
    }
    if (question_.wants_worst)
    {
      const Mask open = !(definite | holds | outside_);
      question_.worst = select(open & (form.lower() < question_.worst.lower()), form, question_.worst);
    }
    return holds;
  }

  /// S - slack Y: definite on the box, S is, where the slack is not negative. Y = y (v v^T + margin I), of which the
  /// margin keeps Y semidefinite after the roundings of its entries.
  SymmetricForms<Real> loweredAlong(SymmetricForms<Real> matrix, const PlainVector<Real>& v, const Real& y) const
  {
    const Real margin = Real(16.0) * rounding::roundoff<Real>();
    for (std::size_t k = 0; k < 3; ++k)
    {
      matrix[k] = lowered(matrix[k], y * (v[k] * v[k] + margin), question_.slack);
      matrix[3 + k] = lowered(matrix[3 + k], y * v[(k + 1) % 3] * v[(k + 2) % 3], question_.slack);
    }
    return matrix;
  }

  Question<Real>& question_;
  Mask inside_;
  Mask outside_;
};
}  // namespace pkm_workspace
