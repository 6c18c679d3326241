// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "pkm_workspace/interval/centered_box.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// The points p with normal . p <= offset. A normal of 0 with an offset of 0 stands for all points.
struct HalfSpace
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0.0;  ///< [m]
};

/// Encloses offset - normal . p over the box.
inline AffineForm<double> slackOf(const HalfSpace& half, const CenteredBox<double>& box)
{
  AffineForm<double> slack;
  slack.center = half.offset;
  for (std::size_t k = 0; k < 3; ++k)
    slack = slack + Enclosed<double>(-half.normal[static_cast<int>(k)], 0.0) * coordinate(box, k);
  return slack;
}

/// The factor y >= 0 that makes the least of form - y slack over the box large: where slack >= 0, form is above that.
template <class Real>
inline Real multiplier(const AffineForm<Real>& form, const AffineForm<Real>& slack)
{
  using std::abs;
  using std::max;
  Real best(0.0);
  Real highest = form.center - form.swing();
  for (std::size_t j = 0; j < 3; ++j)
  {
    const Real y =
        select(slack.gradient[j] * form.gradient[j] > Real(0.0), form.gradient[j] / slack.gradient[j], Real(0.0));
    Real least = form.center - y * slack.center;
    for (std::size_t k = 0; k < 3; ++k)
      least = least - abs(form.gradient[k] - y * slack.gradient[k]);
    best = select(least > highest, y, best);
    highest = max(least, highest);
  }
  return best;
}

/// Encloses form - y slack.
template <class Real>
inline AffineForm<Real> lowered(const AffineForm<Real>& form, const Real& y, const AffineForm<Real>& slack)
{
  return form + Enclosed<Real>(-y, Real(0.0)) * slack;
}
}  // namespace pkm_workspace
