// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/leg.h"

#include <algorithm>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "numbers.h"

namespace pkm_workspace
{
namespace
{
std::string exactText(double x)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::hexfloat << ' ' << (x == 0.0 ? 0.0 : x);
  return text.str();
}
}  // namespace

std::string exactText(const Interval& x)
{
  return exactText(x.lower()) + exactText(x.upper());
}

std::string exactText(const IntervalVector& v)
{
  return exactText(v[0]) + exactText(v[1]) + exactText(v[2]);
}

/// Exact at both ends, and where both numbers are the same.
Interval between(const Interval& first, const Interval& last, const Interval& t)
{
  if (first == last || t == Interval(0.0))
    return first;
  return t == Interval(1.0) ? last : first + t * (last - first);
}

IntervalVector between(const IntervalVector& first, const IntervalVector& last, const Interval& t)
{
  return { between(first[0], last[0], t), between(first[1], last[1], t), between(first[2], last[2], t) };
}

bool OuterBound::isBound() const
{
  return std::any_of(projector.begin(), projector.end(),
                     [](const IntervalVector& row) { return row != IntervalVector(); });
}

IntervalVector OuterBound::offsets() const
{
  const auto offset = [this](std::size_t k) {
    const double most = (radius * sqrtAboveZero(projector[k][k])).upper();
    return Interval(-most, most);
  };
  return { offset(0), offset(1), offset(2) };
}

const StrutTolerance& toleranceOf(const Leg& leg)
{
  static const StrutTolerance none;
  const auto* const strut = std::get_if<SlidingStrut>(&leg.kind);
  return strut ? strut->tolerance : none;
}

void setTolerance(const StrutTolerance& tolerance, Leg& leg)
{
  if (auto* const strut = std::get_if<SlidingStrut>(&leg.kind))
    strut->tolerance = tolerance;
  else if (!tolerance.isZero())
    throw std::invalid_argument("leg '" + leg.joint +
                                "' is no strut of fixed length on a slider: tolerances are known of these only, leave "
                                "its tolerances at 0");
}

const SlidingStrut& slidingStrut(const Leg& leg)
{
  if (const auto* const strut = std::get_if<SlidingStrut>(&leg.kind))
    return *strut;
  throw std::invalid_argument("leg '" + leg.joint + "' has to be a strut of fixed length on a slider");
}

SlidingStrut& slidingStrut(Leg& leg)
{
  return const_cast<SlidingStrut&>(slidingStrut(std::as_const(leg)));
}
}  // namespace pkm_workspace
