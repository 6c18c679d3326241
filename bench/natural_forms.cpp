// SPDX-License-Identifier: BSD-3-Clause
#include "natural_forms.h"

#include <stdexcept>

namespace pkm_workspace
{
namespace bench
{
namespace upward
{
namespace
{
constexpr double SIGMA_MIN = 0.25;  // psi in [0.5, 2]
constexpr double SIGMA_MAX = 4.0;

Real real(const Interval& x)
{
  return { x.lower(), x.upper() };
}
}  // namespace

NaturalForms::NaturalForms(const Machine& machine) : aspect_(machine.aspect())
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const pkm_workspace::Leg& leg = machine.legs()[i];
    const IntervalVector& c = machine.center(static_cast<int>(i));
    legs_[i].center = { real(c[0]), real(c[1]), real(c[2]) };
    legs_[i].squared_length = square(real(slidingStrut(leg).length));
    legs_[i].mode = slidingStrut(leg).working_mode;
    while (slidingStrut(leg).axis[legs_[i].along] != Interval(1.0))
      if (++legs_[i].along == 3)
        throw std::invalid_argument("the peers want rails along axes of the root frame");
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Leg &a = legs_[(i + 1) % 3], &b = legs_[(i + 2) % 3];
      is_same_[i][k] = k != a.along && k != b.along && singleton(a.center[k]) &&
                       a.center[k].lower() == b.center[k].lower() && singleton(b.center[k]);
    }
}

/// d_j . d_k of the two legs other than i.
Real NaturalForms::product(const std::array<Vector, 3>& d, std::size_t i) const
{
  const Vector &a = d[(i + 1) % 3], &b = d[(i + 2) % 3];
  Real sum(0.0);
  for (std::size_t k = 0; k < 3; ++k)
    sum += is_same_[i][k] ? square(a[k]) : a[k] * b[k];
  return sum;
}

Forms NaturalForms::at(const Vector& p) const
{
  Forms f;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Leg& leg = legs_[i];
    const std::size_t u = (leg.along + 1) % 3, v = (leg.along + 2) % 3;
    f.strut[i][u] = p[u] - leg.center[u];
    f.strut[i][v] = p[v] - leg.center[v];
    f.eta2[i] = leg.squared_length - (square(f.strut[i][u]) + square(f.strut[i][v]));
    f.s_max.diagonal[i] = SIGMA_MAX * f.eta2[i] - leg.squared_length;
    f.is_outside = f.s_max.diagonal[i].upper() < 0.0;
    if (f.is_outside)
      return f;
    f.s_min.diagonal[i] = leg.squared_length - SIGMA_MIN * f.eta2[i];
    f.strut[i][leg.along] = leg.mode * sqrt(f.eta2[i]);
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    f.s_min.off[i] = product(f.strut, i);
    f.s_max.off[i] = -f.s_min.off[i];
  }
  return f;
}

Real NaturalForms::determinantOfA(const Forms& forms)
{
  const auto& d = forms.strut;
  Real det(0.0);
  for (std::size_t k = 0; k < 3; ++k)
    det += d[0][k] * (d[1][(k + 1) % 3] * d[2][(k + 2) % 3] - d[1][(k + 2) % 3] * d[2][(k + 1) % 3]);
  return det;
}
}  // namespace upward
}  // namespace bench
}  // namespace pkm_workspace
