// SPDX-License-Identifier: BSD-3-Clause
#include "cut_off.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
/// The thinnest and the thickest slab that is cut off a part, as shares of its widest side. Chosen by counting boxes.
constexpr double LEAST_CUT = 1.0 / 16.0;
constexpr double MOST_CUT = 0.5;
constexpr double SAFETY = 0.9;  ///< 0.5 would be enough if the form said it all

}  // namespace

Cut cutOff(const Box& part, const AffineForm<double>& form)
{
  const int widest = part.widestAxis();
  Cut cut{ widest, part.center()[widest] };
  double thinnest = MOST_CUT;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slope = form.gradient[static_cast<std::size_t>(axis)];
    if (slope == 0.0 || !part.canBisect(axis))
      continue;
    const double narrow = part.width(widest) / part.width(axis);
    const double share = narrow * std::max(LEAST_CUT, -SAFETY * form.lower() / std::abs(slope));
    if (share >= thinnest)
      continue;
    thinnest = share;
    const double depth = share / narrow * part.width(axis);
    cut = { axis, slope > 0.0 ? part.lower[axis] + depth : part.upper[axis] - depth };
  }
  return cut;
}
}  // namespace pkm_workspace
