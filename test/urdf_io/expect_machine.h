// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
namespace test
{
/// Expects the same numbers, bit for bit, in everything but names and limits.
inline void expectSameGeometry(const Machine& a, const Machine& b)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(a.leg(i).origin, b.leg(i).origin) << "leg " << i;
    EXPECT_EQ(a.leg(i).axis, b.leg(i).axis) << "leg " << i;
    EXPECT_EQ(a.leg(i).platform, b.leg(i).platform) << "leg " << i;
    EXPECT_EQ(a.leg(i).length, b.leg(i).length) << "leg " << i;
    EXPECT_EQ(a.leg(i).working_mode, b.leg(i).working_mode) << "leg " << i;
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// Expects enclosures that may stand for the same numbers.
inline void expectOverlap(const Machine& a, const Machine& b)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(intersects(a.leg(i).origin, b.leg(i).origin)) << "leg " << i;
    EXPECT_TRUE(intersects(a.leg(i).axis, b.leg(i).axis)) << "leg " << i;
    EXPECT_TRUE(intersects(a.leg(i).platform, b.leg(i).platform)) << "leg " << i;
    EXPECT_TRUE(a.leg(i).length.intersects(b.leg(i).length)) << "leg " << i;
    EXPECT_EQ(a.leg(i).working_mode, b.leg(i).working_mode) << "leg " << i;
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// The widest number of the machine [m].
inline double widest(const Machine& machine)
{
  double width = 0.0;
  for (const Leg& leg : machine.legs())
  {
    width = std::max(width, leg.length.width());
    for (const auto* const vector : { &leg.origin, &leg.axis, &leg.platform })
      for (const Interval& entry : *vector)
        width = std::max(width, entry.width());
  }
  return width;
}
}  // namespace test
}  // namespace pkm_workspace
