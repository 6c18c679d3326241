// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about machines with tolerances (docs/tolerances.md).

#include "worst_parameters.h"

namespace pkm_workspace
{
/// Tells a visitor of a criterion's forms what they are for the worst machine.
template <class Base, class Visitor>
class WorstCase
{
  using Worst = WorstParameters<Base>;
  using Real = typename Worst::Real;

public:
  WorstCase(const Worst& worst, Visitor& visitor) : worst_(worst), visitor_(visitor) {}

  bool isSettled() const { return visitor_.isSettled(); }

  void scalar(const Subject& subject, const AffineForm<Real>& form, int power)
  {
    visitor_.scalar(subject, worst_.of(form), power);
  }

  /// The alternative is that of one machine.
  template <class Alternative>
  void scalarOr(const Subject& subject, const AffineForm<Real>& form, int power, bool /*exists*/,
                const Alternative& /*alternative*/)
  {
    visitor_.scalar(subject, worst_.of(form), power);
  }

  /// @pre the forms depend on the place alone, as those of zones do: the worst machine of the best form is not the best
  /// form of the worst machine
  template <class Enough>
  void anyOf(const Subject& subject, const AlternativeForms<Real>& forms, int power, const Enough& enough)
  {
    AlternativeForms<Base> worst;
    for (std::size_t k = 0; k < forms.count; ++k)
      worst.add(worst_.of(forms.form[k]));
    visitor_.anyOf(subject, worst, power, [&] { return worst_.of(enough()); });
  }

  void matrix(const Subject& subject, const SymmetricForms<Real>& matrix)
  {
    const Plane plane = planeOf(matrix);
    const SymmetricForms<Base> first = worstFor(matrix, plane.at(0));
    visitor_.necessary(subject, first);
    for (std::size_t k = 1; k < 4 && !visitor_.isSettled(); ++k)
    {
      const PlainVector<Base> v = leastEigenvector(worstFor(matrix, plane.at(k * WEDGES / 4.0))).vector;
      visitor_.necessary(subject, v, v, worst_.of(quadraticForm(matrix, lifted(v))), 2);
    }
    if (!visitor_.isSettled())
      prove(matrix, leastEigenvector(first).vector, plane);
  }

  void sufficient(const SymmetricForms<Real>& matrix)
  {
    const Plane plane = planeOf(matrix);
    prove(matrix, leastEigenvector(worstFor(matrix, plane.at(0))).vector, plane);
  }

  void necessary(const Subject& subject, const PlainVector<Real>& u, const PlainVector<Real>& v,
                 const AffineForm<Real>& form, int power)
  {
    visitor_.necessary(subject, lowered(u), lowered(v), worst_.of(form), power);
  }

  /// The machines and the boxes are connected, and det A is 0 in none: one point of one machine settles its sign.
  template <class Form>
  void oneSigned(const Subject& subject, const Enclosed<Real>& center, const Form& form, int power)
  {
    visitor_.oneSigned(
        subject, { Base(center.value), Base(center.radius) }, [&] { return worst_.of(form()); }, power);
  }

private:
  static constexpr std::size_t WEDGES = 6;
  static constexpr double HALF_WEDGE = M_PI / 2 / WEDGES;
  static constexpr double SQUARED_TANGENT = 0.0733;  ///< of half a wedge, 2 % more: they overlap

  /// Of the two least eigenvectors in the middle, the first direction near the worst one.
  struct Plane
  {
    PlainVector<Base> first;
    PlainVector<Base> second;

    /// @param wedge counts them
    PlainVector<Base> at(double wedge) const
    {
      const double angle = 2.0 * HALF_WEDGE * wedge;
      return eigen::combined(Base(std::cos(angle)), first, Base(std::sin(angle)), second);
    }
  };

  Plane planeOf(const SymmetricForms<Real>& matrix) const
  {
    eigen::Symmetric<Base> middle;
    for (std::size_t k = 0; k < 6; ++k)
      middle[k] = Base(matrix[k].center);
    const eigen::Basis<Base> basis = eigen::basisOf(middle);
    PlainVector<Base> v = basis.vector[0];
    for (int step = 0; step < 2; ++step)
      v = leastEigenvector(worstFor(matrix, v)).vector;
    const Base x = dot(v, basis.vector[0]), y = dot(v, basis.vector[1]);
    const Base norm = max(sqrt(x * x + y * y), Base(1e-3));
    return { eigen::combined(x / norm, basis.vector[0], y / norm, basis.vector[1]),
             eigen::combined(-(y / norm), basis.vector[0], x / norm, basis.vector[1]) };
  }

  /// The matrix for the parameters that make v^T S v least.
  SymmetricForms<Base> worstFor(const SymmetricForms<Real>& matrix, const PlainVector<Base>& v) const
  {
    return worst_.at(matrix, worst_.at(quadraticForm(matrix, lifted(v))));
  }

  /// S is definite where a lower bound of it is that is exact for one vector; or, where two eigenvalues are nearly the
  /// same and no single vector is the worst, where it is on each of some wedges about the plane of these two, which
  /// cover all vectors, by bounds that are exact in their middles.
  void prove(const SymmetricForms<Real>& matrix, const PlainVector<Base>& v, const Plane& plane)
  {
    const auto parts = [&](const auto& holds) {
      for (std::size_t k = 0; k < WEDGES; ++k)
        if (!holds(worst_.of(quadraticForm(matrix, lifted(plane.at(double(k)))))))
          return;
      for (std::size_t k = 0; k < WEDGES; ++k)
      {
        const PlainVector<Base> u = plane.at(double(k)), t = plane.at(k + WEDGES / 2.0);
        if (!holds(onWedge(worst_.below(matrix, u, t, SQUARED_TANGENT), u, t)))
          return;
      }
    };
    visitor_.sufficientOr(worst_.below(matrix, v), parts);
  }

  /// M - lambda (C + small I): where it is definite, M is wherever C(w) = tan^2 (u . w)^2 - (t . w)^2 is
  /// not negative, in the wedge about u (the S-procedure). What the vectors are rounded by is within the overlap but
  /// for vectors w nearly across both, which the small multiple of I is for.
  static SymmetricForms<Base> onWedge(SymmetricForms<Base> m, const PlainVector<Base>& u, const PlainVector<Base>& t)
  {
    const Base square(SQUARED_TANGENT);
    const Base along = quadraticForm(m, u).lower();
    const Base across = quadraticForm(m, t).lower();
    const Base lambda = select(across < Base(0), max(Base(0.5) * (along / square - across), Base(0)), Base(0));
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = row; column < 3; ++column)
      {
        AffineForm<Base>& entry = m[worst_case::entryOf(row, column)];
        const Base part = square * u[row] * u[column] - t[row] * t[column] + Base(row == column ? 1e-20 : 0.0);
        entry.center = entry.center - lambda * part;
        entry.radius = affine::widened(entry.radius, abs(entry.center) + Base(2) * lambda, 32);
      }
    return m;
  }

  static PlainVector<Real> lifted(const PlainVector<Base>& v) { return { Real(v[0]), Real(v[1]), Real(v[2]) }; }
  static PlainVector<Base> lowered(const PlainVector<Real>& v) { return { Base(v[0]), Base(v[1]), Base(v[2]) }; }

  const Worst& worst_;
  Visitor& visitor_;
};
}  // namespace pkm_workspace
