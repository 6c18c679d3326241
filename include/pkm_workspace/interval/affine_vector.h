// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/centered_box.h"
#include "pkm_workspace/interval/enclosed_constants.h"
#include "pkm_workspace/interval/skew_box.h"

namespace pkm_workspace
{
/// A vector-valued affine form: component k lies within center_k + linear_k . delta + [-along, along] axis_k +
/// [-radius, radius], with one and the same member of [-along, along] for all components.
template <class Real>
struct AffineVector
{
  std::array<Real, 3> center;
  std::array<Gradient<Real>, 3> linear;  ///< [component][delta, parameters]
  Real radius = Real(0);
  Real along = Real(0);
  std::array<Real, 3> axis = { Real(0), Real(0), Real(0) };

  /// Sum of the magnitudes of a component's slopes, rounded.
  Real swing(std::size_t k) const
  {
    using std::abs;
    Real sum = abs(linear[k][0]);
    for (std::size_t j = 1; j < linear[k].size(); ++j)
      sum = sum + abs(linear[k][j]);
    return sum;
  }
  /// An approximate bound on the sum of the components' magnitudes, without the errors.
  Real magnitude() const
  {
    using std::abs;
    Real sum = Real(0);
    for (std::size_t k = 0; k < 3; ++k)
      sum = sum + (abs(center[k]) + swing(k));
    return sum;
  }
};

namespace affine
{
/// |axis . v| over the cube, errors of v left out: roundings are the caller's.
template <class Real>
inline Real reach(const std::array<Real, 3>& axis, const AffineVector<Real>& v)
{
  using std::abs;
  Real bound = abs(axis[0] * v.center[0] + axis[1] * v.center[1] + axis[2] * v.center[2]);
  for (std::size_t j = 0; j < v.linear[0].size(); ++j)
    bound = bound + abs(axis[0] * v.linear[0][j] + axis[1] * v.linear[1][j] + axis[2] * v.linear[2][j]);
  return bound;
}

template <class Real>
inline Real sumOfMagnitudes(const std::array<Real, 3>& v)
{
  using std::abs;
  return abs(v[0]) + abs(v[1]) + abs(v[2]);
}

/// What the error terms of two vectors can change in their dot product, roundings left out.
template <class Real>
inline Real dotError(const AffineVector<Real>& u, const AffineVector<Real>& v, const Real& size_u, const Real& size_v)
{
  const Real axis_u = sumOfMagnitudes(u.axis);
  const Real axis_v = sumOfMagnitudes(v.axis);
  const Real isotropic =
      u.radius * (size_v + v.along * axis_v) + v.radius * (size_u + u.along * axis_u) + Real(3) * u.radius * v.radius;
  using std::abs;
  const Real axes = abs(u.axis[0] * v.axis[0] + u.axis[1] * v.axis[1] + u.axis[2] * v.axis[2]);
  return isotropic + u.along * reach(u.axis, v) + v.along * reach(v.axis, u) + u.along * v.along * axes;
}
/// What a box adds to a matrix row: its entry for one delta.
template <class Real>
inline Real alongDelta(const std::array<Real, 3>& row, const CenteredBox<Real>& box, std::size_t j)
{
  return row[j] * box.half_widths[j];
}
template <class Real>
inline Real alongDelta(const std::array<Real, 3>& row, const SkewBox<Real>& box, std::size_t j)
{
  return row[0] * box.edges[0][j] + row[1] * box.edges[1][j] + row[2] * box.edges[2][j];
}

/// Sum of the magnitudes of a box's edges, component by component.
template <class Real>
inline Real sumOfEdges(const CenteredBox<Real>& box)
{
  return sumOfMagnitudes(box.half_widths);
}
template <class Real>
inline Real sumOfEdges(const SkewBox<Real>& box)
{
  return sumOfMagnitudes(box.edges[0]) + sumOfMagnitudes(box.edges[1]) + sumOfMagnitudes(box.edges[2]);
}
}  // namespace affine

/// Encloses M (p - c) for p in the box, in place: copies of packs of vectors cost as much as their arithmetic.
/// @param box a CenteredBox or a SkewBox
template <class Real, template <class> class Domain>
inline void mapOffset(const EnclosedMatrix<Real>& m, const EnclosedVector<Real>& c, const Domain<Real>& box,
                      AffineVector<Real>& image)
{
  const std::array<Real, 3> x = { box.center[0] - c.value[0], box.center[1] - c.value[1], box.center[2] - c.value[2] };
  for (std::size_t k = 0; k < 3; ++k)
  {
    image.center[k] = m.value[k][0] * x[0] + m.value[k][1] * x[1] + m.value[k][2] * x[2];
    for (std::size_t j = 0; j < 3; ++j)
      image.linear[k][j] = affine::alongDelta(m.value[k], box, j);
    for (std::size_t j = 3; j < image.linear[k].size(); ++j)
      image.linear[k][j] = Real(0);
  }
  const Real size = affine::sumOfMagnitudes(x) + affine::sumOfEdges(box);
  const Real shift = Real(3) * (m.magnitude + m.radius) * (c.radius + box.slack);
  image.radius = affine::widened(m.radius * size + shift, m.magnitude * size, 16);
  image.along = Real(0);
  image.axis = { Real(0), Real(0), Real(0) };
}

/// Encloses u . v. The products of two deltas are summed over the components before they are bounded.
template <class Real>
inline AffineForm<Real> dot(const AffineVector<Real>& u, const AffineVector<Real>& v)
{
  using std::abs;
  AffineForm<Real> result;
  Real center = u.center[0] * v.center[0] + u.center[1] * v.center[1] + u.center[2] * v.center[2];
  std::array<std::array<Real, 3>, 3> p;
  for (std::size_t j = 0; j < 3; ++j)
  {
    result.gradient[j] = (u.center[0] * v.linear[0][j] + v.center[0] * u.linear[0][j]) +
                         (u.center[1] * v.linear[1][j] + v.center[1] * u.linear[1][j]) +
                         (u.center[2] * v.linear[2][j] + v.center[2] * u.linear[2][j]);
    for (std::size_t l = 0; l < 3; ++l)
      p[j][l] = u.linear[0][j] * v.linear[0][l] + u.linear[1][j] * v.linear[1][l] + u.linear[2][j] * v.linear[2][l];
  }
  for (std::size_t j = 3; j < result.gradient.size(); ++j)
    result.gradient[j] = (u.center[0] * v.linear[0][j] + v.center[0] * u.linear[0][j]) +
                         (u.center[1] * v.linear[1][j] + v.center[1] * u.linear[1][j]) +
                         (u.center[2] * v.linear[2][j] + v.center[2] * u.linear[2][j]);
  const Real half = Real(1) / Real(2);
  result.center = center + half * (p[0][0] + p[1][1] + p[2][2]);
  Real quadratic = half * (abs(p[0][0]) + abs(p[1][1]) + abs(p[2][2])) + abs(p[0][1] + p[1][0]) +
                   abs(p[0][2] + p[2][0]) + abs(p[1][2] + p[2][1]);
  for (std::size_t k = 0; k < 3 && SYMBOLS < Real >> 3; ++k)
    quadratic = quadratic + affine::parameterProducts<Real>(u.linear[k], v.linear[k]);
  const Real size_u = u.magnitude();
  const Real size_v = v.magnitude();
  const Real unit = rounding::roundoff<Real>();
  const Real error = affine::dotError(u, v, size_u * (Real(1) + Real(32) * unit), size_v * (Real(1) + Real(32) * unit));
  // 32: `reach` and the product of the axes sum signed products, each rounded relative to what they multiply
  const Real along_u = u.along * affine::sumOfMagnitudes(u.axis);
  const Real along_v = v.along * affine::sumOfMagnitudes(v.axis);
  result.radius = affine::widened(quadratic + error, size_u * size_v, 32) +
                  Real(32) * unit * (along_u * size_v + along_v * size_u + along_u * along_v);
  return result;
}

/// Encloses v . v, more cheaply than dot(v, v).
/// @pre v has no error along an axis
template <class Real>
inline AffineForm<Real> squaredNorm(const AffineVector<Real>& v)
{
  using std::abs;
  AffineForm<Real> result;
  const auto product = [&v](std::size_t j, std::size_t l) {
    return v.linear[0][j] * v.linear[0][l] + v.linear[1][j] * v.linear[1][l] + v.linear[2][j] * v.linear[2][l];
  };
  const Real squares = product(0, 0) + product(1, 1) + product(2, 2);
  const Real half = Real(0.5) * squares;
  const Real mixed = abs(product(0, 1)) + abs(product(0, 2)) + abs(product(1, 2));
  result.center = v.center[0] * v.center[0] + v.center[1] * v.center[1] + v.center[2] * v.center[2] + half;
  for (std::size_t j = 0; j < result.gradient.size(); ++j)
  {
    const Real slope = v.center[0] * v.linear[0][j] + v.center[1] * v.linear[1][j] + v.center[2] * v.linear[2][j];
    result.gradient[j] = slope + slope;
  }
  const Real size = v.magnitude();
  const Real blown_up = size * (Real(1) + Real(32) * rounding::roundoff<Real>());
  Real error = v.radius * (Real(2) * blown_up + Real(3) * v.radius);
  for (std::size_t k = 0; k < 3 && SYMBOLS < Real >> 3; ++k)
    error = error + affine::parameterProducts<Real>(v.linear[k], v.linear[k]);
  result.radius = affine::widened(half + Real(2) * mixed + error, size * size, 32);
  return result;
}

/// Adds f a for a form f and a constant vector a; the radius of f goes along a.
/// @pre v has no error along an axis yet
template <class Real>
inline void addAlong(AffineVector<Real>& v, const AffineForm<Real>& f, const EnclosedVector<Real>& a)
{
  Real size = Real(0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    using std::abs;
    size = size + abs(v.center[k]);
    v.center[k] = v.center[k] + f.center * a.value[k];
    for (std::size_t j = 0; j < f.gradient.size(); ++j)
    {
      size = size + abs(v.linear[k][j]);
      v.linear[k][j] = v.linear[k][j] + f.gradient[j] * a.value[k];
    }
  }
  const Real magnitude = f.magnitude();
  v.radius = affine::widened(v.radius + a.radius * magnitude, size + magnitude * affine::sumOfMagnitudes(a.value), 8);
  v.along = f.radius;
  v.axis = a.value;
}

namespace affine
{
/// Makes the error along an axis one in all directions.
template <class Real>
inline void spreadError(AffineVector<Real>& v)
{
  using std::abs;
  using std::max;
  v.radius = widened(v.radius + v.along * max(max(abs(v.axis[0]), abs(v.axis[1])), abs(v.axis[2])), Real(0), 0);
  v.along = Real(0);
  v.axis = { Real(0), Real(0), Real(0) };
}
}  // namespace affine

/// Adds f a for a form f and a vector a that depends on parameters alone; the radius of f goes along the center of a.
/// @pre v and a have no error along an axis
template <class Real>
inline void addAlong(AffineVector<Real>& v, const AffineForm<Real>& f, const AffineVector<Real>& a)
{
  const Real size = v.magnitude();
  Real products(0);
  for (std::size_t k = 0; k < 3; ++k)
  {
    using std::max;
    v.center[k] = v.center[k] + f.center * a.center[k];
    for (std::size_t j = 0; j < f.gradient.size(); ++j)
      v.linear[k][j] = v.linear[k][j] + (f.gradient[j] * a.center[k] + f.center * a.linear[k][j]);
    products = max(products, affine::parameterProducts<Real>(f.gradient, a.linear[k]) + f.radius * a.swing(k));
  }
  const Real magnitude = f.magnitude();
  v.radius = affine::widened(v.radius + products + a.radius * magnitude, size + magnitude * a.magnitude(), 32);
  v.along = f.radius;
  v.axis = a.center;
}

namespace affine
{
/// The radius of one component.
template <class Real>
inline Real radiusOf(const AffineVector<Real>& v, std::size_t k)
{
  using std::abs;
  return widened(v.radius + v.along * abs(v.axis[k]), Real(0), 0);
}
}  // namespace affine

/// One component as a scalar form.
template <class Real>
inline AffineForm<Real> component(const AffineVector<Real>& v, std::size_t k)
{
  return { v.center[k], v.linear[k], affine::radiusOf(v, k) };
}

/// Encloses u . v for a constant vector u.
template <class Real>
inline AffineForm<Real> dot(const EnclosedVector<Real>& u, const AffineVector<Real>& v)
{
  using std::abs;
  const auto times = [&u](const Real& x, const Real& y, const Real& z) {
    return u.value[0] * x + u.value[1] * y + u.value[2] * z;
  };
  AffineForm<Real> sum;
  sum.center = times(v.center[0], v.center[1], v.center[2]);
  for (std::size_t j = 0; j < sum.gradient.size(); ++j)
    sum.gradient[j] = times(v.linear[0][j], v.linear[1][j], v.linear[2][j]);
  const Real size_u = affine::sumOfMagnitudes(u.value) + u.radius;
  const Real size_v = v.magnitude() + v.radius + v.along * affine::sumOfMagnitudes(v.axis);
  const Real errors = v.along * abs(times(v.axis[0], v.axis[1], v.axis[2])) + v.radius * size_u + u.radius * size_v;
  sum.radius = affine::widened(errors, size_u * size_v, 32);
  return sum;
}

/// Encloses a . (p - c) for p in the box. @param rows the first of which is a
template <class Real, template <class> class Domain>
inline AffineForm<Real> dotOffset(const EnclosedMatrix<Real>& rows, const EnclosedVector<Real>& c,
                                  const Domain<Real>& box)
{
  AffineVector<Real> image;
  mapOffset(rows, c, box, image);
  return component(image, 0);
}

/// The same at delta = 0 only.
template <class Real>
inline Enclosed<Real> componentAtCenter(const AffineVector<Real>& v, std::size_t k)
{
  return { v.center[k], affine::radiusOf(v, k) };
}
}  // namespace pkm_workspace
