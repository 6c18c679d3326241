// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpfi.h>
#include <mpfr.h>

#include <ostream>

#include "pkm_workspace/interval/rounding.h"

namespace pkm_workspace
{
namespace test
{
using MpfrUnary = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);
using MpfrBinary = int (*)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);

/// The two neighbouring doubles (one double twice when it is exact) between which function(a, b) lies, by MPFR.
inline rounding::Bounds tightest(MpfrBinary function, double a, double b)
{
  const auto rounded = [&](mpfr_rnd_t direction) {
    mpfr_t x, y;
    mpfr_inits2(53, x, y, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_d(x, a, MPFR_RNDN);
    mpfr_set_d(y, b, MPFR_RNDN);
    function(x, x, y, direction);
    const double result = mpfr_get_d(x, direction);
    mpfr_clears(x, y, static_cast<mpfr_ptr>(nullptr));
    return result;
  };
  return { rounded(MPFR_RNDD), rounded(MPFR_RNDU) };
}

/// The same for a function of one number.
inline rounding::Bounds tightest(MpfrUnary function, double a)
{
  const auto rounded = [&](mpfr_rnd_t direction) {
    mpfr_t x;
    mpfr_init2(x, 53);
    mpfr_set_d(x, a, MPFR_RNDN);
    function(x, x, direction);
    const double result = mpfr_get_d(x, direction);
    mpfr_clear(x);
    return result;
  };
  return { rounded(MPFR_RNDD), rounded(MPFR_RNDU) };
}

/// A real number known to some 90 digits by MPFI: the oracle. Computed with the rounding mode to nearest.
class Exact
{
public:
  Exact(double value = 0.0) : Exact(value, value) {}
  Exact(double lower, double upper)
  {
    mpfi_init2(x_, 320);
    mpfi_interv_d(x_, lower, upper);
  }
  Exact(const Exact& other) : Exact() { mpfi_set(x_, other.x_); }
  Exact& operator=(const Exact& other)
  {
    mpfi_set(x_, other.x_);
    return *this;
  }
  ~Exact() { mpfi_clear(x_); }

  /// False only when the number is proved to lie outside of [lower, upper].
  bool mayLieIn(double lower, double upper) const
  {
    return mpfr_cmp_d(&x_->right, lower) >= 0 && mpfr_cmp_d(&x_->left, upper) <= 0;
  }
  template <class Set>
  bool mayLieIn(const Set& set) const
  {
    return mayLieIn(set.lower(), set.upper());
  }
  bool certainlyPositive() const { return mpfr_sgn(&x_->left) > 0; }
  bool certainlyNegative() const { return mpfr_sgn(&x_->right) < 0; }
  bool certainlyNotPositive() const { return mpfr_sgn(&x_->right) <= 0; }
  double value() const { return mpfi_get_d(x_); }

  friend Exact operator-(const Exact& a) { return apply(mpfi_neg, a); }
  friend Exact operator+(const Exact& a, const Exact& b) { return apply(mpfi_add, a, b); }
  friend Exact operator-(const Exact& a, const Exact& b) { return apply(mpfi_sub, a, b); }
  friend Exact operator*(const Exact& a, const Exact& b) { return apply(mpfi_mul, a, b); }
  friend Exact operator/(const Exact& a, const Exact& b) { return apply(mpfi_div, a, b); }
  friend Exact sqrt(const Exact& a) { return apply(mpfi_sqrt, a); }
  friend Exact sin(const Exact& a) { return apply(mpfi_sin, a); }
  friend Exact cos(const Exact& a) { return apply(mpfi_cos, a); }
  friend std::ostream& operator<<(std::ostream& stream, const Exact& a) { return stream << a.value(); }

private:
  template <class Function, class... Operands>
  static Exact apply(Function function, const Operands&... operands)
  {
    Exact result;
    function(result.x_, operands.x_...);
    return result;
  }

  mpfi_t x_;
};
}  // namespace test
}  // namespace pkm_workspace
