// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the machine does over pieces of paths, side by side. For packs only, see box_kernel_impl.h.

#include "pack_gather.h"
#include "pkm_workspace/dexterity/path_piece.h"
#include "pkm_workspace/dexterity/pencil_forms.h"
#include "pkm_workspace/interval/pencil_bounds.h"

namespace pkm_workspace
{
template <class Real>
struct PieceRanges
{
  std::array<Span<Real>, 3> psi;
  std::array<Span<Real>, 3> joint;  ///< [m]
  std::array<Real, 3> speed;        ///< upper bounds of |(J^-1 t)_i|
};

/// A unit vector along the way, or 0, as an affine vector over the same delta as the points.
template <class Real>
inline AffineVector<Real> asVector(const SkewBox<Real>& box)
{
  AffineVector<Real> vector;
  vector.center = box.center;
  for (std::size_t k = 0; k < 3; ++k)
    vector.linear[k] = coordinate(box, k).gradient;
  vector.radius = box.slack;
  return vector;
}

/// Encloses the transmission factors: sigma = psi^2 are the eigenvalues of the pencil A A^T - sigma B^2.
template <class Real>
inline std::array<Span<Real>, 3> factorsOver(const LegModels<Real>& legs, const MachineForms<Real>& forms)
{
  using std::max;
  using std::sqrt;
  std::array<Real, 3> inverse;
  for (std::size_t i = 0; i < 3; ++i)
    inverse[i] = Real(1) / forms.legs[i].drive.center;
  const SymmetricForms<Real> gram = pencilForms(legs, forms, Enclosed<Real>(Real(0), Real(0)));
  std::array<Span<Real>, 3> psi = pencilEigenvalues(gram, forms.squaredDrives(), inverse);
  for (Span<Real>& span : psi)
  {
    const Real lower = sqrt(max(span.lower, Real(0)));
    const Real upper = sqrt(span.upper);
    span = { max(lower - pencil::noise(lower), Real(0)), upper + pencil::noise(upper) };
  }
  return psi;
}

/// What |f / g| lies in over the cube, where g has one sign there: |f / g - r| <= max |f - r g| / min |g|, for any r.
template <class Real>
struct Quotient
{
  Real ratio;             ///< r
  AffineForm<Real> rest;  ///< f - r g
  Real distance;          ///< max |f - r g| / min |g|
  MaskOf<Real> exists;    ///< where g is proved to have one sign

  Quotient(const AffineForm<Real>& f, const AffineForm<Real>& g)
    : ratio(f.center / g.center), rest(f + Enclosed<Real>(-ratio, Real(0)) * g)
  {
    using std::max;
    const Real least = max(g.lower(), -g.upper());
    distance = max(rest.upper(), -rest.lower()) / least;
    exists = least > Real(0);
  }

  Real largest() const
  {
    using std::abs;
    const Real bound = abs(ratio) + distance;
    return select(exists, bound + pencil::noise(bound), Real(INF));
  }
  Real least() const
  {
    using std::abs;
    using std::max;
    const Real bound = abs(ratio) - distance - pencil::noise(abs(ratio) + distance);
    return select(exists, max(bound, Real(0)), Real(0));
  }
};

/// Where all b_i^2 are proved to be above their floors, and positive, on the whole piece.
template <class Real>
inline MaskOf<Real> reachesAll(const LegModels<Real>& legs, const MachineForms<Real>& forms)
{
  using std::max;
  MaskOf<Real> reaches = Real(1.0) > Real(0.0);
  for (std::size_t i = 0; i < 3; ++i)
    reaches = reaches & (forms.legs[i].squared_drive.lower() > max(legs.floor(i), Real(0.0)));
  return reaches;
}

/// All numbers where not all legs are proved to reach.
template <class Real>
inline PieceRanges<Real> rangesOver(const LegModels<Real>& legs, const MachineForms<Real>& forms,
                                    const SkewBox<Real>& points, const SkewBox<Real>& tangent)
{
  const Real infinite(INF);
  const MaskOf<Real> reaches = reachesAll(legs, forms);
  PieceRanges<Real> ranges;
  ranges.psi = factorsOver(legs, forms);
  const AffineVector<Real> direction = asVector(tangent);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const AffineForm<Real> rho = legs.joint(i, forms, points);
    ranges.psi[i] = { select(reaches, ranges.psi[i].lower, Real(0.0)), select(reaches, ranges.psi[i].upper, infinite) };
    ranges.joint[i] = { select(reaches, rho.lower(), -infinite), select(reaches, rho.upper(), infinite) };
    const Quotient<Real> speed(dot(forms.legs[i].row, direction), forms.legs[i].drive);
    ranges.speed[i] = select(reaches, legs.rateAbove(i, speed.largest()), infinite);
  }
  return ranges;
}

template <class Real>
struct JointRates
{
  std::array<Span<Real>, 3> speed;         ///< |q_i'|
  std::array<Span<Real>, 3> acceleration;  ///< |q_i''| [1/m]
};

/// Encloses q' = n . t / b, q'' = (n' . t - b' q' + n . k) / b for the tangent t and the curvature k (docs/theory.md).
template <class Real>
inline JointRates<Real> ratesOver(const LegModels<Real>& legs, const MachineForms<Real>& forms,
                                  const SkewBox<Real>& points, const AffineVector<Real>& tangent,
                                  const AffineVector<Real>& curvature)
{
  const MaskOf<Real> reaches = reachesAll(legs, forms);
  const auto magnitude = [&](std::size_t leg, const Quotient<Real>& x) {
    return Span<Real>{ select(reaches, legs.rateBelow(leg, x.least()), Real(0.0)),
                       select(reaches, legs.rateAbove(leg, x.largest()), Real(INF)) };
  };
  JointRates<Real> rates;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const AffineVector<Real>& row = forms.legs[i].row;
    const AffineForm<Real>& drive = forms.legs[i].drive;
    const Quotient<Real> speed(dot(row, tangent), drive);
    const MaskOf<Real> turned = drive.center < Real(0.0);
    const AffineForm<Real> quotient =
        select(turned, -speed.rest, speed.rest) * inverseOf(select(turned, -drive, drive)) +
        Enclosed<Real>(speed.ratio, Real(0));
    const AffineForm<Real> force = legs.turning(i, forms, points, tangent, quotient) + dot(row, curvature);
    rates.speed[i] = magnitude(i, speed);
    rates.acceleration[i] = magnitude(i, { force, drive });
  }
  return rates;
}

template <class Real>
inline void scatter(const PieceRanges<Real>& ranges, PieceMotion* motions, std::size_t count)
{
  for (std::size_t lane = 0; lane < Real::WIDTH && lane < count; ++lane)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int k = static_cast<int>(lane);
      motions[lane].psi[i] = { ranges.psi[i].lower.below(k), ranges.psi[i].upper.above(k) };
      motions[lane].joint[i] = { ranges.joint[i].lower.below(k), ranges.joint[i].upper.above(k) };
      motions[lane].speed[i] = ranges.speed[i].above(k);
    }
}

/// What overflows, or is no number, bounds nothing.
template <class Real>
inline Span<double> laneOf(const Span<Real>& span, int lane)
{
  const double lower = span.lower.below(lane);
  const double upper = span.upper.above(lane);
  return { lower > 0.0 && lower < INF ? lower : 0.0, upper >= 0.0 ? upper : INF };
}

template <class Real>
inline void scatter(const JointRates<Real>& found, PieceRates* rates, std::size_t count)
{
  for (std::size_t lane = 0; lane < Real::WIDTH && lane < count; ++lane)
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int k = static_cast<int>(lane);
      rates[lane].speed[i] = laneOf(found.speed[i], k);
      rates[lane].acceleration[i] = laneOf(found.acceleration[i], k);
    }
}
}  // namespace pkm_workspace
