// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace test
{
/// The numbers of a leg.
inline std::vector<Interval> numbersOf(const SlidingStrut& leg)
{
  return { leg.origin[0],
           leg.origin[1],
           leg.origin[2],
           leg.axis[0],
           leg.axis[1],
           leg.axis[2],
           leg.platform[0],
           leg.platform[1],
           leg.platform[2],
           leg.length,
           Interval(leg.working_mode) };
}
inline std::vector<Interval> numbersOf(const TelescopicStrut& leg)
{
  return { leg.foot[0], leg.foot[1], leg.foot[2], leg.platform[0], leg.platform[1], leg.platform[2], leg.length };
}
inline std::vector<Interval> numbersOf(const Crank& leg)
{
  return { leg.pivot[0],    leg.pivot[1],    leg.pivot[2],  leg.along[0],  leg.along[1],
           leg.along[2],    leg.across[0],   leg.across[1], leg.across[2], leg.platform[0],
           leg.platform[1], leg.platform[2], leg.radius,    leg.length,    Interval(leg.working_mode) };
}
inline std::vector<Interval> numbersOf(const Leg& leg)
{
  return visitLeg([](const auto& kind) { return numbersOf(kind); }, leg.kind);
}

/// Expects the same numbers, bit for bit, in everything but names and limits.
inline void expectSameGeometry(const Machine& a, const Machine& b)
{
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_EQ(a.leg(i).kind.index(), b.leg(i).kind.index());
    EXPECT_EQ(numbersOf(a.leg(i)), numbersOf(b.leg(i))) << "leg " << i;
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// Expects enclosures that may stand for the same numbers.
inline void expectOverlap(const Machine& a, const Machine& b)
{
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_EQ(a.leg(i).kind.index(), b.leg(i).kind.index());
    const auto first = numbersOf(a.leg(i)), second = numbersOf(b.leg(i));
    for (std::size_t k = 0; k < first.size(); ++k)
      EXPECT_TRUE(first[k].intersects(second[k])) << "leg " << i << ", number " << k << ": " << first[k] << second[k];
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// The widest number of the machine [m].
inline double widest(const Machine& machine)
{
  double width = 0.0;
  for (const Leg& leg : machine.legs())
    for (const Interval& number : numbersOf(leg))
      width = std::max(width, number.width());
  return width;
}
}  // namespace test
}  // namespace pkm_workspace
