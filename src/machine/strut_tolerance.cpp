// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/strut_tolerance.h"

#include <algorithm>

#include "numbers.h"

namespace pkm_workspace
{
bool StrutTolerance::isZero() const
{
  const auto none = [](double x) { return x == 0.0; };
  return std::all_of(slider.begin(), slider.end(), none) && std::all_of(platform.begin(), platform.end(), none) &&
         none(slider_ball) && none(platform_ball) && none(direction) && none(length) && none(zero);
}

std::string exactText(const StrutTolerance& tolerance)
{
  if (tolerance.isZero())
    return "";
  std::string text = " tolerance";
  for (std::size_t k = 0; k < 3; ++k)
    text += exactText(tolerance.axes[k]) + exactText(Interval(tolerance.slider[k])) +
            exactText(Interval(tolerance.platform[k]));
  for (const double x :
       { tolerance.slider_ball, tolerance.platform_ball, tolerance.direction, tolerance.length, tolerance.zero })
    text += exactText(Interval(x));
  return text;
}
}  // namespace pkm_workspace
