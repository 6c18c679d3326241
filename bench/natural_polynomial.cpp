// SPDX-License-Identifier: BSD-3-Clause
#include "natural_polynomial.h"

#include <algorithm>
#include <optional>

namespace pkm_workspace
{
namespace bench
{
namespace
{
using upward::Real;
using upward::Symmetric;

/// @return true: positive definite; false: not even semidefinite; nothing: not proved
std::optional<bool> isPositive(const Symmetric& s)
{
  const Real minors[] = { s.diagonal[0], minorOf(s, 2), determinant(s), s.diagonal[1],
                          s.diagonal[2], minorOf(s, 0), minorOf(s, 1) };
  if (std::any_of(std::begin(minors), std::end(minors), [](const Real& x) { return x.upper() < 0.0; }))
    return false;
  if (std::all_of(minors, minors + 3, [](const Real& x) { return x.lower() > 0.0; }))
    return true;
  return std::nullopt;
}
}  // namespace

BoxVerdict NaturalPolynomial::operator()(const Box& box) const
{
  const upward::RoundingUpward mode;
  return classify(box);
}

[[gnu::noinline]] BoxVerdict NaturalPolynomial::classify(const Box& box) const
{
  const upward::Forms on_box = forms_.at(upward::enclose(box));
  if (on_box.is_outside)
    return BoxVerdict::OUTSIDE;
  const bool is_regular =
      std::all_of(on_box.eta2.begin(), on_box.eta2.end(), [](const Real& x) { return x.lower() > 0.0; });
  if (!is_regular)
    return BoxVerdict::UNDECIDED;
  const upward::Forms center = forms_.at(upward::enclose(Box{ box.center(), box.center() }));
  const bool is_point = box.lower == box.upper;
  const auto holdsOnBox = [&](const Symmetric& pencil) { return is_point || !zero_in(determinant(pencil)); };
  if (forms_.isOtherAspect(center) && (is_point || forms_.isOtherAspect(on_box)))
    return BoxVerdict::OUTSIDE;
  const auto above_min = isPositive(center.s_min), below_max = isPositive(center.s_max);
  if ((!above_min.value_or(true) && holdsOnBox(on_box.s_min)) ||
      (!below_max.value_or(true) && holdsOnBox(on_box.s_max)))
    return BoxVerdict::OUTSIDE;
  const bool is_valid = above_min.value_or(false) && below_max.value_or(false) && forms_.isOwnAspect(center);
  return is_valid && holdsOnBox(on_box.s_min) && holdsOnBox(on_box.s_max) ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}
}  // namespace bench
}  // namespace pkm_workspace
