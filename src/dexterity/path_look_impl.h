// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about pieces of paths.

#include "box_kernel_impl.h"
#include "piece_ranges.h"

namespace pkm_workspace
{
template <class Real, class Model>
void PackKernel<Real, Model>::look(const CurvePiece* pieces, std::size_t count, BoxVerdict* verdicts,
                                   PieceMotion* motions) const
{
  const WideRegisters<Real> wide;
  for (std::size_t first = 0; first < count; first += W)
  {
    const std::size_t rest = count - first;
    const SkewBox<Real> points = gather<Real>(pieces + first, &CurvePiece::points, rest);
    const auto forms = model_.evaluate(points);
    Question<Real> question;
    const BoxLook<Real> found = look(forms, points, question);
    for (std::size_t lane = 0; lane < W && lane < rest; ++lane)
      verdicts[first + lane] = found.verdict(static_cast<int>(lane));
    if (motions)
      scatter(rangesOver(model_.legs(), forms, model_.lifted(points),
                         model_.lifted(gather<Real>(pieces + first, &CurvePiece::tangents, rest))),
              motions + first, rest);
  }
}

template <class Real, class Model>
void PackKernel<Real, Model>::rates(const CurvePiece* pieces, const SkewBox<double>* curvatures, std::size_t count,
                                    PieceRates* rates) const
{
  const WideRegisters<Real> wide;
  for (std::size_t first = 0; first < count; first += W)
  {
    const std::size_t rest = count - first;
    const SkewBox<Real> points = gather<Real>(pieces + first, &CurvePiece::points, rest);
    const auto forms = model_.evaluate(points);
    const SkewBox<Real> tangents = gather<Real>(pieces + first, &CurvePiece::tangents, rest);
    const SkewBox<Real> bends = gather<Real>(curvatures + first, rest);
    scatter(ratesOver(model_.legs(), forms, model_.lifted(points), asVector(model_.lifted(tangents)),
                      asVector(model_.lifted(bends))),
            rates + first, rest);
  }
}
}  // namespace pkm_workspace
