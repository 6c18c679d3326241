// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/numeric/interval.hpp>
#include <cfenv>
#include <cmath>

#include "pkm_workspace/interval/box.h"

// Boost.Interval with the rounding mode set once, upward: lower bounds are negated upper bounds of negated numbers.
// That is the one way to use it that is fast and that g++ does not break. Only for files that are compiled with
// -frounding-math.

namespace pkm_workspace
{
namespace bench
{
namespace upward
{
/// Sets the rounding mode for its lifetime. What computes in that mode has to be a call that is not inlined: else its
/// operations may be moved to where the mode is not set.
class RoundingUpward
{
public:
  RoundingUpward() : before_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~RoundingUpward() { std::fesetround(before_); }
  RoundingUpward(const RoundingUpward&) = delete;
  RoundingUpward& operator=(const RoundingUpward&) = delete;

private:
  int before_;
};

/// Leaves the rounding mode alone; it is upward for as long as the search runs.
struct ModeSetOnce
{
  using rounding_mode = int;
  static void upward() {}
  static void downward() {}
  static void to_nearest() {}
  static double force_rounding(double x) { return x; }
};

struct Arithmetic : boost::numeric::interval_lib::rounded_arith_opp<double, ModeSetOnce>
{
  /// x / r for an r not below the root is not above the root. @pre x > 0
  double sqrt_down(double x) { return -(x / -std::sqrt(x)); }
};

using NoChecks = boost::numeric::interval_lib::checking_no_nan<
    double,
    boost::numeric::interval_lib::checking_no_empty<double, boost::numeric::interval_lib::checking_base<double>>>;
using Real = boost::numeric::interval<
    double,
    boost::numeric::interval_lib::policies<boost::numeric::interval_lib::save_state_nothing<Arithmetic>, NoChecks>>;
using Vector = std::array<Real, 3>;

inline Vector enclose(const Box& box)
{
  return { Real(box.lower[0], box.upper[0]), Real(box.lower[1], box.upper[1]), Real(box.lower[2], box.upper[2]) };
}

/// A symmetric matrix: its diagonal, and the entries 12, 20, 01.
struct Symmetric
{
  Vector diagonal;
  Vector off;
};

inline Real minorOf(const Symmetric& m, std::size_t i)
{
  return m.diagonal[(i + 1) % 3] * m.diagonal[(i + 2) % 3] - square(m.off[i]);
}

inline Real determinant(const Symmetric& m)
{
  const Real mixed = m.off[0] * m.off[1] * m.off[2];
  return m.diagonal[0] * minorOf(m, 0) + (mixed + mixed) -
         (m.diagonal[1] * square(m.off[1]) + m.diagonal[2] * square(m.off[2]));
}
}  // namespace upward
}  // namespace bench
}  // namespace pkm_workspace
