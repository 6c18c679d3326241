// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/growing.h"

namespace pkm_workspace
{
/// A box as center + half_widths * delta + [-slack, slack]^3 with delta in [-1, 1]^3, rounded outward.
template <class Real>
struct CenteredBox
{
  std::array<Real, 3> center;
  std::array<Real, 3> half_widths;
  Real slack = Real(0);

  CenteredBox() = default;
  CenteredBox(const std::array<Real, 3>& lower, const std::array<Real, 3>& upper)
  {
    using std::max;
    using std::min;
    const Real half(0.5);
    for (std::size_t j = 0; j < 3; ++j)
    {
      center[j] = min(max(half * lower[j] + half * upper[j], lower[j]), upper[j]);
      // each difference is rounded once; the factor covers that in every mode
      half_widths[j] =
          max(upper[j] - center[j], center[j] - lower[j]) * (Real(1) + Real(4) * rounding::roundoff<Real>());
    }
  }
  explicit CenteredBox(const Box& box)
    : CenteredBox(std::array<Real, 3>{ box.lower[0], box.lower[1], box.lower[2] },
                  std::array<Real, 3>{ box.upper[0], box.upper[1], box.upper[2] })
  {}

  /// The box moved by offset.at(size); delta keeps its meaning, so that forms over both can be combined.
  CenteredBox moved(double size, const GrowingVector& offset) const
  {
    const auto numbers = [](const Eigen::Vector3d& v) {
      return std::array<Real, 3>{ Real(v[0]), Real(v[1]), Real(v[2]) };
    };
    return moved(Real(size), numbers(offset.fixed), numbers(offset.per_size));
  }
  /// Three roundings: with step = fixed + size * per_size they are within a roundoff times |size * per_size| <=
  /// |fixed| + |step|, |step| and |center + step|.
  CenteredBox moved(const Real& size, const std::array<Real, 3>& fixed, const std::array<Real, 3>& per_size) const
  {
    using std::abs;
    CenteredBox result(*this);
    Real magnitude = slack;
    for (std::size_t j = 0; j < 3; ++j)
    {
      const Real step = fixed[j] + size * per_size[j];
      result.center[j] = center[j] + step;
      magnitude = magnitude + abs(center[j]) + abs(step) + abs(fixed[j]);
    }
    result.slack = (slack + Real(4) * rounding::roundoff<Real>() * magnitude + rounding::underflow<Real>()) *
                   (Real(1) + Real(8) * rounding::roundoff<Real>());
    return result;
  }
};

/// How far delta over the box may be from [-1, 1], along each axis: centers and half widths are rounded.
inline std::array<Interval, 3> deviations(const Box& box, const CenteredBox<double>& centered)
{
  std::array<Interval, 3> deviation;
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Interval side = box.side(static_cast<int>(j)) - Interval(centered.center[j]);
    if (centered.half_widths[j] == 0.0)
      continue;
    const Interval half(centered.half_widths[j]);
    const Interval lower = Interval(side.lower()) / half + Interval(1.0);
    const Interval upper = Interval(side.upper()) / half - Interval(1.0);
    deviation[j] = Interval(0.0, std::max(lower.magnitude(), upper.magnitude()));
  }
  return deviation;
}

/// Encloses one coordinate of the points of the box.
template <class Real>
inline AffineForm<Real> coordinate(const CenteredBox<Real>& box, std::size_t axis)
{
  AffineForm<Real> form;
  form.center = box.center[axis];
  form.gradient[axis] = box.half_widths[axis];
  form.radius = box.slack;
  return form;
}
}  // namespace pkm_workspace
