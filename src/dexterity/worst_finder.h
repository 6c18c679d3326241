// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that names the worst of all machines within tolerances.

#include "worst_case.h"

namespace pkm_workspace
{
/// Visits the conditions at a point, in the first lane, for the one that is closest to failing on the worst machine.
template <class Base>
class WorstFinder
{
  using Worst = WorstParameters<Base>;
  using Real = typename Worst::Real;

public:
  /// @param per_length powers of 1 / the longest strut, 0 to 3
  WorstFinder(const Worst& worst, const std::array<Base, 4>& per_length) : worst_(worst), per_length_(per_length) {}

  const WorstMachine& found() const { return found_; }
  static constexpr bool isSettled() { return false; }

  void scalar(const Subject& subject, const AffineForm<Real>& form, int power)
  {
    const double unit = per_length_[static_cast<std::size_t>(power)][0];
    const double margin = worst_.of(form).center[0] * unit;
    if (!(margin < found_.margin))
      return;
    const auto parameters = worst_.at(form);
    found_.subject = subject;
    found_.margin = margin;
    for (std::size_t j = 0; j < WorstMachine::COUNT; ++j)
    {
      found_.parameter[j] = parameters[j][0];
      found_.loss[j] = std::abs(form.gradient[3 + j][0] * parameters[j][0]) * unit;
    }
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

  /// By the vector for which the worst parameters make the matrix least.
  void matrix(const Subject& subject, const SymmetricForms<Real>& matrix)
  {
    PlainVector<Base> v;
    for (std::size_t k = 0; k < 3; ++k)
      v[k] = Base(leastEigenvector(matrix).vector[k]);
    const auto lifted = [&v] { return PlainVector<Real>{ Real(v[0]), Real(v[1]), Real(v[2]) }; };
    for (int step = 0; step < 4; ++step)
      v = leastEigenvector(worst_.at(matrix, worst_.at(quadraticForm(matrix, lifted())))).vector;
    scalar(subject, quadraticForm(matrix, lifted()), 2);
  }

  static constexpr void sufficient(const SymmetricForms<Real>& /*matrix*/) {}

  void necessary(const Subject& subject, const PlainVector<Real>& /*u*/, const PlainVector<Real>& /*v*/,
                 const AffineForm<Real>& form, int power)
  {
    scalar(subject, form, power);
  }

  template <class Form>
  static constexpr void oneSigned(const Subject& /*subject*/, const Enclosed<Real>& /*center*/, const Form& /*form*/,
                                  int /*power*/)
  {}

private:
  const Worst& worst_;
  const std::array<Base, 4>& per_length_;
  WorstMachine found_;
};
}  // namespace pkm_workspace
