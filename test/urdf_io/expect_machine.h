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
    EXPECT_EQ(slidingStrut(a.leg(i)).origin, slidingStrut(b.leg(i)).origin) << "leg " << i;
    EXPECT_EQ(slidingStrut(a.leg(i)).axis, slidingStrut(b.leg(i)).axis) << "leg " << i;
    EXPECT_EQ(slidingStrut(a.leg(i)).platform, slidingStrut(b.leg(i)).platform) << "leg " << i;
    EXPECT_EQ(slidingStrut(a.leg(i)).length, slidingStrut(b.leg(i)).length) << "leg " << i;
    EXPECT_EQ(slidingStrut(a.leg(i)).working_mode, slidingStrut(b.leg(i)).working_mode) << "leg " << i;
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// Expects enclosures that may stand for the same numbers.
inline void expectOverlap(const Machine& a, const Machine& b)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(intersects(slidingStrut(a.leg(i)).origin, slidingStrut(b.leg(i)).origin)) << "leg " << i;
    EXPECT_TRUE(intersects(slidingStrut(a.leg(i)).axis, slidingStrut(b.leg(i)).axis)) << "leg " << i;
    EXPECT_TRUE(intersects(slidingStrut(a.leg(i)).platform, slidingStrut(b.leg(i)).platform)) << "leg " << i;
    EXPECT_TRUE(slidingStrut(a.leg(i)).length.intersects(slidingStrut(b.leg(i)).length)) << "leg " << i;
    EXPECT_EQ(slidingStrut(a.leg(i)).working_mode, slidingStrut(b.leg(i)).working_mode) << "leg " << i;
  }
  EXPECT_EQ(a.aspect(), b.aspect());
}

/// The widest number of the machine [m].
inline double widest(const Machine& machine)
{
  double width = 0.0;
  for (const Leg& leg : machine.legs())
  {
    width = std::max(width, slidingStrut(leg).length.width());
    for (const auto* const vector : { &slidingStrut(leg).origin, &slidingStrut(leg).axis, &slidingStrut(leg).platform })
      for (const Interval& entry : *vector)
        width = std::max(width, entry.width());
  }
  return width;
}
}  // namespace test
}  // namespace pkm_workspace
