// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// Encloses the angles of the directions (x_k, y_k) [rad], from -pi to pi; all of them where one is no number.
void enclosedAngles(const double* x, const double* y, std::size_t count, double* middle, double* radius);

/// Encloses the angle of the direction (x, y) [rad].
Enclosed<double> enclosedAngle(double x, double y);
template <int W, std::size_t P>
inline Enclosed<Pack<W, P>> enclosedAngle(const Pack<W, P>& x, const Pack<W, P>& y)
{
  std::array<double, W> from[2];
  std::array<double, W> to[2];
  for (int lane = 0; lane < W; ++lane)
  {
    from[0][static_cast<std::size_t>(lane)] = x[lane];
    from[1][static_cast<std::size_t>(lane)] = y[lane];
  }
  enclosedAngles(from[0].data(), from[1].data(), W, to[0].data(), to[1].data());
  return { Pack<W, P>::load(to[0].data()), Pack<W, P>::load(to[1].data()) };
}

/// Encloses atan f: |atan w - s w| <= (1 - s) W for |w| <= W, where s is the middle of the slopes 1 and 1 / (1 + W^2).
template <class Real>
inline AffineForm<Real> arcTangent(const AffineForm<Real>& f)
{
  using std::max;
  const Real most = max(f.upper(), -f.lower());
  const Real slope = (Real(1) + Real(1) / (Real(1) + most * most)) / Real(2);
  AffineForm<Real> result = Enclosed<Real>(slope, Real(0)) * f;
  result.radius = affine::widened(result.radius + (Real(1) - slope) * most, most, 16);
  return result;
}

/// Encloses the angle of the direction (x, y) from -pi to pi [rad], the angle of the middle and that between: to second
/// order where no direction is at pi and all are within a right angle of the middle; otherwise it is [-pi, pi].
template <class Real>
inline AffineForm<Real> angleOf(const AffineForm<Real>& x, const AffineForm<Real>& y)
{
  using std::sqrt;
  const Real length = sqrt(x.center * x.center + y.center * y.center);
  const Enclosed<Real> cosine(x.center / length, Real(0));
  const Enclosed<Real> sine(y.center / length, Real(0));
  const AffineForm<Real> ahead = cosine * x + sine * y;
  const AffineForm<Real> aside = cosine * y - sine * x;
  const AffineForm<Real> near = arcTangent(aside * inverseOf(ahead)) + enclosedAngle(cosine.value, sine.value);
  const auto holds =
      (ahead.lower() > Real(0)) & ((x.lower() > Real(0)) | (y.lower() > Real(0)) | (y.upper() < Real(0)));
  AffineForm<Real> angle;
  angle.center = select(holds, near.center, Real(0));
  for (std::size_t j = 0; j < angle.gradient.size(); ++j)
    angle.gradient[j] = select(holds, near.gradient[j], Real(0));
  angle.radius = select(holds, near.radius, Real(3.2));
  return angle;
}
}  // namespace pkm_workspace
