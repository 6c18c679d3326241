// SPDX-License-Identifier: BSD-3-Clause
#include <mpfr.h>

#include <cmath>

#include "pkm_workspace/interval/angle_form.h"
#include "subnormal.h"

namespace pkm_workspace
{
namespace
{
/// Encloses the angle of one direction (x, y) other than (0, 0).
Interval angleOfNumbers(double x, double y)
{
  const auto rounded = [&](mpfr_rnd_t mode) {
    mpfr_t abscissa, ordinate;
    mpfr_inits2(53, abscissa, ordinate, static_cast<mpfr_ptr>(nullptr));
    mpfr_set_d(abscissa, x, MPFR_RNDN);
    mpfr_set_d(ordinate, y, MPFR_RNDN);
    mpfr_atan2(ordinate, ordinate, abscissa, rounding::SOUND ? mode : MPFR_RNDN);
    const double angle = mpfr_get_d(ordinate, mode);
    mpfr_clears(abscissa, ordinate, static_cast<mpfr_ptr>(nullptr));
    return angle;
  };
  return Interval(rounded(MPFR_RNDD), rounded(MPFR_RNDU));
}

Interval angleOfSets(const Interval& x, const Interval& y)
{
  if (x.lower() <= 0.0 && y.contains(0.0))
    return { -pi().upper(), pi().upper() };
  Interval angles = Interval::empty();
  for (const double abscissa : { x.lower(), x.upper() })
    for (const double ordinate : { y.lower(), y.upper() })
      angles = hull(angles, angleOfNumbers(abscissa, ordinate));
  return angles;
}
}  // namespace

Interval angleOf(const Interval& x, const Interval& y)
{
  return x.isEmpty() || y.isEmpty() ? Interval::empty() : subnormal::keeping([&] { return angleOfSets(x, y); });
}

void enclosedAngles(const double* x, const double* y, std::size_t count, double* middle, double* radius)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    const bool is_direction = std::isfinite(x[k]) && std::isfinite(y[k]) && (x[k] != 0.0 || y[k] != 0.0);
    const Interval angle = is_direction ? angleOf(x[k], y[k]) : Interval(-pi().upper(), pi().upper());
    middle[k] = angle.mid();
    radius[k] = angle.radius();
  }
}

Enclosed<double> enclosedAngle(double x, double y)
{
  Enclosed<double> angle;
  enclosedAngles(&x, &y, 1, &angle.value, &angle.radius);
  return angle;
}
}  // namespace pkm_workspace
