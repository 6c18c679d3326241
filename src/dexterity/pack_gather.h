// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Vectors, forms and half-spaces side by side. For packs only, see box_kernel_impl.h.

#include <utility>

#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// One truth value a lane.
template <class Real>
using MaskOf = decltype(std::declval<Real>() < std::declval<Real>());

template <class Real>
inline std::array<Real, 3> pointOf(const double (&coordinates)[3][Real::WIDTH])
{
  return { Real::load(coordinates[0]), Real::load(coordinates[1]), Real::load(coordinates[2]) };
}

/// Vectors side by side; lanes beyond the last repeat it.
template <class Real>
inline std::array<Real, 3> gather(const Eigen::Vector3d* vectors, std::size_t count)
{
  double coordinates[3][Real::WIDTH];
  for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
    for (std::size_t k = 0; k < 3; ++k)
      coordinates[k][lane] = vectors[lane < count ? lane : count - 1].data()[k];
  return pointOf<Real>(coordinates);
}

/// A box, moved to several places side by side.
template <class Real>
inline CenteredBox<Real> gatherMoved(const CenteredBox<Real>& box, const Real& size, const GrowingVector* offsets,
                                     std::size_t count)
{
  double fixed[3][Real::WIDTH], per_size[3][Real::WIDTH];
  for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const GrowingVector& offset = offsets[lane < count ? lane : count - 1];
      fixed[k][lane] = offset.fixed.data()[k];
      per_size[k][lane] = offset.per_size.data()[k];
    }
  return box.moved(size, pointOf<Real>(fixed), pointOf<Real>(per_size));
}

/// Boxes side by side.
template <class Real>
inline CenteredBox<Real> gather(const Box* boxes, std::size_t count)
{
  double lower[3][Real::WIDTH], upper[3][Real::WIDTH];
  for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Box& box = boxes[lane < count ? lane : count - 1];
      lower[k][lane] = box.lower.data()[k];
      upper[k][lane] = box.upper.data()[k];
    }
  return { pointOf<Real>(lower), pointOf<Real>(upper) };
}

template <class Real>
inline AffineForm<double> laneOf(const AffineForm<Real>& form, int lane)
{
  return { form.center[lane],
           { form.gradient[0][lane], form.gradient[1][lane], form.gradient[2][lane] },
           form.radius[lane] };
}

/// Boxes side by side. @param box that of an index
template <class Real, class BoxOf>
inline SkewBox<Real> gatherBoxes(const BoxOf& box, std::size_t count)
{
  double numbers[13][Real::WIDTH];
  for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
  {
    const SkewBox<double>& from = box(lane < count ? lane : count - 1);
    for (std::size_t k = 0; k < 3; ++k)
    {
      numbers[k][lane] = from.center[k];
      for (std::size_t j = 0; j < 3; ++j)
        numbers[3 + 3 * k + j][lane] = from.edges[k][j];
    }
    numbers[12][lane] = from.slack;
  }
  SkewBox<Real> result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result.center[k] = Real::load(numbers[k]);
    for (std::size_t j = 0; j < 3; ++j)
      result.edges[k][j] = Real::load(numbers[3 + 3 * k + j]);
  }
  result.slack = Real::load(numbers[12]);
  return result;
}

/// One of the boxes of each piece.
template <class Real>
inline SkewBox<Real> gather(const CurvePiece* pieces, SkewBox<double> CurvePiece::*box, std::size_t count)
{
  return gatherBoxes<Real>([=](std::size_t k) -> const SkewBox<double>& { return pieces[k].*box; }, count);
}
template <class Real>
inline SkewBox<Real> gather(const SkewBox<double>* boxes, std::size_t count)
{
  return gatherBoxes<Real>([=](std::size_t k) -> const SkewBox<double>& { return boxes[k]; }, count);
}

/// Form by form.
template <class Real>
inline AffineForm<Real> select(MaskOf<Real> mask, const AffineForm<Real>& a, const AffineForm<Real>& b)
{
  AffineForm<Real> result;
  result.center = select(mask, a.center, b.center);
  for (std::size_t j = 0; j < result.gradient.size(); ++j)
    result.gradient[j] = select(mask, a.gradient[j], b.gradient[j]);
  result.radius = select(mask, a.radius, b.radius);
  return result;
}

/// Encloses offset - normal . p.
template <class Real>
inline AffineForm<Real> slackOf(const HalfSpace* within, std::size_t count, const CenteredBox<Real>& box)
{
  double normal[3][Real::WIDTH], offset[Real::WIDTH];
  for (std::size_t lane = 0; lane < Real::WIDTH; ++lane)
  {
    const HalfSpace& half = within[lane < count ? lane : count - 1];
    offset[lane] = half.offset;
    for (std::size_t k = 0; k < 3; ++k)
      normal[k][lane] = half.normal.data()[k];
  }
  const std::array<Real, 3> n = pointOf<Real>(normal);
  AffineForm<Real> slack;
  slack.center = Real::load(offset);
  for (std::size_t k = 0; k < 3; ++k)
    slack = slack + Enclosed<Real>(-n[k], Real(0.0)) * coordinate(box, k);
  return slack;
}
}  // namespace pkm_workspace
