// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about necessary forms.

#include "pack_gather.h"

namespace pkm_workspace
{
/// Powers of about 1 / the longest strut: powers of two, which round nothing.
template <class Real>
std::array<Real, 4> powersPerLength(const Real& squared_scale)
{
  const int exponent = exponentPerLength(squared_scale[0]);
  std::array<Real, 4> powers;
  for (int power = 0; power < 4; ++power)
    powers[static_cast<std::size_t>(power)] = Real(ldexp(1.0, exponent * power));
  return powers;
}

/// Collects what a criterion makes necessary over boxes side by side, for lanes one by one: visits its conditions.
template <class Real>
class FormCollector
{
  using Mask = MaskOf<Real>;
  static constexpr std::size_t W = Real::WIDTH;

public:
  /// Keeps a reference.
  /// @param per_length powersPerLength() of the machine: makes forms to be without unit
  /// @param origins MOST for each result, or nullptr
  FormCollector(const std::array<Real, 4>& per_length, NecessaryForms* results, FormOrigin* origins, std::size_t count)
    : per_length_(per_length), results_(results), origins_(origins), count_(std::min(count, W))
  {}

  template <class Model>
  void collect(const Model& model, const CenteredBox<Real>& box)
  {
    const auto forms = model.evaluate(box);
    std::array<Mask, 3> beyond;
    for (std::size_t i = 0; i < 3; ++i)
      beyond[i] = model.squaredDrive(forms, i).upper() < model.floor(i);
    const Mask violated = beyond[0] | beyond[1] | beyond[2];
    for (std::size_t lane = 0; lane < count_; ++lane)
    {
      results_[lane].violated = violated[static_cast<int>(lane)];
      results_[lane].matrices = 0;
      results_[lane].forms = 0;
    }
    model.visit(forms, box, *this);
    if (origins_)
      noteViolations(beyond, model, forms);
  }

  static constexpr bool isSettled() { return false; }
  static constexpr void sufficient(const SymmetricForms<Real>& /*matrix*/) {}
  template <class Parts>
  static constexpr void sufficientOr(const SymmetricForms<Real>& /*matrix*/, const Parts& /*parts*/)
  {}

  void scalar(const Subject& subject, const AffineForm<Real>& form, int power)
  {
    append(scaled(form, power), everywhere(), { subject, {}, {} });
  }

  template <class Alternative>
  void scalarOr(const Subject& subject, const AffineForm<Real>& form, int power, bool /*exists*/,
                const Alternative& /*alternative*/)
  {
    scalar(subject, form, power);
  }

  template <class Enough>
  void anyOf(const Subject& subject, const AlternativeForms<Real>& forms, int power, const Enough& /*enough*/)
  {
    scalar(subject, forms.largest(), power);
  }

  void necessary(const Subject& subject, const PlainVector<Real>& u, const PlainVector<Real>& v,
                 const AffineForm<Real>& form, int power)
  {
    append(scaled(form, power), everywhere(), { subject, u, v });
  }

  /// The form helps only where its sign is wrong.
  template <class Form>
  void oneSigned(const Subject& subject, const Enclosed<Real>& center, const Form& form, int power)
  {
    const Mask useful = center.lower() < Real(0.0);
    if (any(useful))
      append(scaled(form(), power), useful, { subject, {}, {} });
  }

  void matrix(const Subject& subject, const SymmetricForms<Real>& matrix) { necessary(subject, matrix); }

  void necessary(const Subject& subject, SymmetricForms<Real> matrix)
  {
    for (AffineForm<Real>& entry : matrix)
      entry = scaled(entry, 2);
    NecessaryForms* const end = results_ + count_;
    int lane = 0;
    for (NecessaryForms* forms = results_; forms != end && forms->matrices < forms->matrix.size(); ++forms, ++lane)
    {
      forms->kind[forms->matrices] = subject.kind;
      SymmetricForms<double>& result = forms->matrix[forms->matrices++];
      for (std::size_t entry = 0; entry < 6; ++entry)
        result[entry] = laneOf(matrix[entry], lane);
    }
    if constexpr (W == 1)
      appendPlane(subject, matrix);
    else
      appendAlong(subject, matrix, leastEigenvector(matrix).vector);
  }

private:
  /// What a form says, for boxes side by side.
  struct Origin
  {
    Subject subject;
    PlainVector<Real> u;
    PlainVector<Real> v;
  };

  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  /// The forms for the two least eigenvectors and two between them: no cut of the matrix in doubles could be as exact.
  void appendPlane(const Subject& subject, const SymmetricForms<Real>& matrix)
  {
    eigen::Symmetric<Real> center;
    for (std::size_t k = 0; k < 6; ++k)
      center[k] = matrix[k].center;
    const auto basis = eigen::basisOf(center);
    for (const double share : { 0.0, 1.0, 0.5, -0.5 })
    {
      const PlainVector<Real> v =
          eigen::combined(Real(1.0 - std::abs(share)), basis.vector[0], Real(share), basis.vector[1]);
      appendAlong(subject, matrix, v);
    }
  }

  void appendAlong(const Subject& subject, const SymmetricForms<Real>& matrix, const PlainVector<Real>& v)
  {
    append(quadraticForm(matrix, v), everywhere(), { subject, {}, v });
  }

  /// The form over a power of the machine's scale, to be without unit; exact.
  AffineForm<Real> scaled(const AffineForm<Real>& form, int power) const
  {
    const Real factor = per_length_[static_cast<std::size_t>(power)];
    return { form.center * factor,
             { form.gradient[0] * factor, form.gradient[1] * factor, form.gradient[2] * factor },
             form.radius * factor };
  }

  /// What there is no room for is left out: the others hold all the same.
  void append(const AffineForm<Real>& form, Mask useful, const Origin& origin)
  {
    NecessaryForms* const end = results_ + count_;
    int lane = 0;
    for (NecessaryForms* forms = results_; forms != end; ++forms, ++lane)
      if (useful[lane] && forms->forms < NecessaryForms::MOST)
      {
        if (origins_)
          note(origin, lane, forms->forms);
        forms->form[forms->forms++] = laneOf(form, lane);
      }
  }

  /// The first leg whose b^2 is below its floor stands for all forms.
  template <class Model, class Forms>
  void noteViolations(const std::array<Mask, 3>& beyond, const Model& model, const Forms& forms)
  {
    for (std::size_t leg = 3; leg-- > 0;)
    {
      const AffineForm<Real> above =
          scaled(model.squaredDrive(forms, leg) + Enclosed<Real>(-model.floor(leg), Real(0)), 2);
      for (std::size_t lane = 0; lane < count_; ++lane)
        if (beyond[leg][static_cast<int>(lane)])
        {
          results_[lane].form[0] = laneOf(above, static_cast<int>(lane));
          origins_[lane * NecessaryForms::MOST] = { { ConditionKind::REACH, leg }, {}, {} };
        }
    }
  }

  void note(const Origin& origin, int lane, std::size_t form)
  {
    FormOrigin& result = origins_[static_cast<std::size_t>(lane) * NecessaryForms::MOST + form];
    result.subject = origin.subject;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.u[k] = origin.u[k][lane];
      result.v[k] = origin.v[k][lane];
    }
  }

  const std::array<Real, 4>& per_length_;
  NecessaryForms* results_;
  FormOrigin* origins_;
  std::size_t count_;
};
}  // namespace pkm_workspace
