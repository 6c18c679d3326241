// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/leg.h"

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

IntervalVector OuterBound::offsets() const
{
  const auto offset = [this](std::size_t k) {
    const double most = (radius * sqrtAboveZero(projector[k][k])).upper();
    return Interval(-most, most);
  };
  return { offset(0), offset(1), offset(2) };
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
