// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/interval/affine_form.h"

namespace pkm_workspace
{
/// A box with edges in any direction: center + edges * delta + [-slack, slack]^3 with delta in [-1, 1]^3. An edge may
/// be 0: a piece of a line has one, a piece of a curve has two more that hold what is not straight.
template <class Real>
struct SkewBox
{
  std::array<Real, 3> center;
  std::array<std::array<Real, 3>, 3> edges;  ///< [component][delta]
  Real slack = Real(0);
};

/// Encloses one coordinate of the points of the box.
template <class Real>
inline AffineForm<Real> coordinate(const SkewBox<Real>& box, std::size_t axis)
{
  AffineForm<Real> form;
  form.center = box.center[axis];
  for (std::size_t j = 0; j < 3; ++j)
    form.gradient[j] = box.edges[axis][j];
  form.radius = box.slack;
  return form;
}
}  // namespace pkm_workspace
