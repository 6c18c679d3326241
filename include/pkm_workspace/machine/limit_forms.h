// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/machine/leg_state.h"

namespace pkm_workspace
{
/// A weight of leg_state.h as a number.
template <class Real>
inline Enclosed<Real> weightOf(Zero)
{
  return {};
}
template <class Real>
inline Enclosed<Real> weightOf(One)
{
  return { Real(1), Real(0) };
}
template <class Real>
inline Enclosed<Real> weightOf(MinusOne)
{
  return { Real(-1), Real(0) };
}
template <class Real>
inline const Enclosed<Real>& weightOf(const Enclosed<Real>& x)
{
  return x;
}

/// One end of what a joint may do: as a joint value, and, of an angle, as a direction.
template <class Real>
struct JointLimit
{
  bool is_upper = false;
  Enclosed<Real> value;   ///< of an upper limit the limit, of a lower one minus that [m] or [rad]
  Enclosed<Real> cosine;  ///< of an angle: of the limit, counted from its reference
  Enclosed<Real> sine;

  JointLimit() = default;
  template <class Other>
  explicit JointLimit(const JointLimit<Other>& other)
    : is_upper(other.is_upper), value(other.value), cosine(other.cosine), sine(other.sine)
  {}
};

/// How far q is on the right side of the limit.
template <class Real>
inline AffineForm<Real> fromLimit(const AffineForm<Real>& q, const JointLimit<Real>& limit)
{
  return (limit.is_upper ? -q : q) + limit.value;
}
template <class Real>
inline Real fromLimit(const Real& q, const JointLimit<Real>& limit)
{
  return limit.is_upper ? limit.value.value - q : q + limit.value.value;
}
}  // namespace pkm_workspace
