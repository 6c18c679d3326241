// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "pkm_workspace/interval/affine_form.h"

namespace pkm_workspace
{
/// One truth value with the operations of a LaneMask.
struct PreciseMask
{
  bool value;

  explicit operator bool() const { return value; }
  bool operator[](int) const { return value; }
  friend PreciseMask operator&(PreciseMask a, PreciseMask b) { return { a.value && b.value }; }
  friend PreciseMask operator|(PreciseMask a, PreciseMask b) { return { a.value || b.value }; }
  friend PreciseMask operator!(PreciseMask a) { return { !a.value }; }
};

inline bool any(PreciseMask mask)
{
  return mask.value;
}

/// A number of 50 decimal digits (MPFR through Boost.Multiprecision) with the operations of a pack that holds one: for
/// what doubles cannot settle (paper, section 2.2). Each operation rounds to nearest.
class Precise
{
public:
  using Number = boost::multiprecision::number<
      boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
      boost::multiprecision::et_off>;
  static constexpr int WIDTH = 1;

  Precise() = default;
  explicit Precise(double value) : number_(value) {}
  explicit Precise(const Number& number) : number_(number) {}
  static Precise load(const double* values) { return Precise(*values); }

  const Number& number() const { return number_; }
  /// The nearest double.
  double operator[](int) const { return number_.convert_to<double>(); }
  /// The doubles next to it on either side, or itself twice.
  double below(int) const { return mpfr_get_d(number_.backend().data(), rounding::SOUND ? MPFR_RNDD : MPFR_RNDU); }
  double above(int) const { return mpfr_get_d(number_.backend().data(), rounding::SOUND ? MPFR_RNDU : MPFR_RNDD); }

  friend Precise operator-(const Precise& a) { return Precise(Number(-a.number_)); }
  friend Precise operator+(const Precise& a, const Precise& b) { return Precise(Number(a.number_ + b.number_)); }
  friend Precise operator-(const Precise& a, const Precise& b) { return Precise(Number(a.number_ - b.number_)); }
  friend Precise operator*(const Precise& a, const Precise& b) { return Precise(Number(a.number_ * b.number_)); }
  friend Precise operator/(const Precise& a, const Precise& b) { return Precise(Number(a.number_ / b.number_)); }
  friend PreciseMask operator<(const Precise& a, const Precise& b) { return { a.number_ < b.number_ }; }
  friend PreciseMask operator>(const Precise& a, const Precise& b) { return { a.number_ > b.number_ }; }
  friend PreciseMask operator>=(const Precise& a, const Precise& b) { return { a.number_ >= b.number_ }; }
  friend Precise select(PreciseMask mask, const Precise& a, const Precise& b) { return mask.value ? a : b; }
  friend Precise max(const Precise& a, const Precise& b) { return a.number_ < b.number_ ? b : a; }
  friend Precise min(const Precise& a, const Precise& b) { return b.number_ < a.number_ ? b : a; }
  friend Precise abs(const Precise& a) { return a.number_ < 0 ? -a : a; }
  friend Precise sqrt(const Precise& a) { return Precise(Number(boost::multiprecision::sqrt(a.number_))); }

private:
  Number number_;
};

namespace rounding
{
template <>
struct ScalarOf<Precise>
{
  using Type = Precise::Number;
};
}  // namespace rounding

/// Encloses the angle of the direction (x, y) from -pi to pi [rad]; all where it is none.
inline Enclosed<Precise> enclosedAngle(const Precise& x, const Precise& y)
{
  const Precise::Number angle = boost::multiprecision::atan2(y.number(), x.number());
  const bool is_direction = boost::multiprecision::isfinite(angle) && (x.number() != 0 || y.number() != 0);
  const Precise value = is_direction ? Precise(angle) : Precise(0.0);
  return { value, is_direction ? affine::widened(Precise(0.0), abs(value), 4) : Precise(3.2) };
}

/// The same form in doubles, its radius larger by what that rounds.
inline AffineForm<double> inDoubles(const AffineForm<Precise>& form)
{
  AffineForm<double> result{ form.center[0],
                             { form.gradient[0][0], form.gradient[1][0], form.gradient[2][0] },
                             form.radius[0] };
  result.radius = affine::widened(result.radius, result.magnitude(), 4);
  return result;
}
}  // namespace pkm_workspace
