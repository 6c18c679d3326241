// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Vectors, forms and half-spaces side by side. For packs only, see box_kernel_impl.h.

#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
template <int W>
inline std::array<Pack<W>, 3> pointOf(const double (&coordinates)[3][W])
{
  return { Pack<W>::load(coordinates[0]), Pack<W>::load(coordinates[1]), Pack<W>::load(coordinates[2]) };
}

/// Vectors side by side; lanes beyond the last repeat it.
template <int W>
inline std::array<Pack<W>, 3> gather(const Eigen::Vector3d* vectors, std::size_t count)
{
  double coordinates[3][W];
  for (std::size_t lane = 0; lane < W; ++lane)
    for (std::size_t k = 0; k < 3; ++k)
      coordinates[k][lane] = vectors[lane < count ? lane : count - 1].data()[k];
  return pointOf<W>(coordinates);
}

/// Boxes side by side.
template <int W>
inline CenteredBox<Pack<W>> gather(const Box* boxes, std::size_t count)
{
  double lower[3][W], upper[3][W];
  for (std::size_t lane = 0; lane < W; ++lane)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Box& box = boxes[lane < count ? lane : count - 1];
      lower[k][lane] = box.lower.data()[k];
      upper[k][lane] = box.upper.data()[k];
    }
  return { pointOf<W>(lower), pointOf<W>(upper) };
}

template <int W>
inline AffineForm<double> laneOf(const AffineForm<Pack<W>>& form, int lane)
{
  return { form.center[lane],
           { form.gradient[0][lane], form.gradient[1][lane], form.gradient[2][lane] },
           form.radius[lane] };
}

/// One of the boxes of each piece.
template <int W>
inline SkewBox<Pack<W>> gather(const CurvePiece* pieces, SkewBox<double> CurvePiece::*box, std::size_t count)
{
  double numbers[13][W];
  for (std::size_t lane = 0; lane < W; ++lane)
  {
    const SkewBox<double>& from = pieces[lane < count ? lane : count - 1].*box;
    for (std::size_t k = 0; k < 3; ++k)
    {
      numbers[k][lane] = from.center[k];
      for (std::size_t j = 0; j < 3; ++j)
        numbers[3 + 3 * k + j][lane] = from.edges[k][j];
    }
    numbers[12][lane] = from.slack;
  }
  SkewBox<Pack<W>> result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result.center[k] = Pack<W>::load(numbers[k]);
    for (std::size_t j = 0; j < 3; ++j)
      result.edges[k][j] = Pack<W>::load(numbers[3 + 3 * k + j]);
  }
  result.slack = Pack<W>::load(numbers[12]);
  return result;
}

/// Form by form.
template <int W>
inline AffineForm<Pack<W>> select(LaneMask<W> mask, const AffineForm<Pack<W>>& a, const AffineForm<Pack<W>>& b)
{
  return { select(mask, a.center, b.center),
           { select(mask, a.gradient[0], b.gradient[0]), select(mask, a.gradient[1], b.gradient[1]),
             select(mask, a.gradient[2], b.gradient[2]) },
           select(mask, a.radius, b.radius) };
}

/// Encloses offset - normal . p.
template <int W>
inline AffineForm<Pack<W>> slackOf(const HalfSpace* within, std::size_t count, const CenteredBox<Pack<W>>& box)
{
  double normal[3][W], offset[W];
  for (std::size_t lane = 0; lane < W; ++lane)
  {
    const HalfSpace& half = within[lane < count ? lane : count - 1];
    offset[lane] = half.offset;
    for (std::size_t k = 0; k < 3; ++k)
      normal[k][lane] = half.normal.data()[k];
  }
  const std::array<Pack<W>, 3> n = pointOf<W>(normal);
  AffineForm<Pack<W>> slack;
  slack.center = Pack<W>::load(offset);
  for (std::size_t k = 0; k < 3; ++k)
    slack = slack + Enclosed<Pack<W>>(-n[k], Pack<W>(0.0)) * coordinate(box, k);
  return slack;
}
}  // namespace pkm_workspace
