// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/box.h"

#include <gtest/gtest.h>

#include <sstream>

#include "support/exact.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
Box randomBox(Operands& operands)
{
  const IntervalVector sides = { operands.interval(), operands.interval(), operands.interval() };
  return boundingBox(sides);
}

std::string toText(const Box& box)
{
  std::ostringstream text;
  text << box.side(0) << " x " << box.side(1) << " x " << box.side(2);
  return text.str();
}

class BoxContainment : public ModeAndSpread
{
protected:
  template <class Check>
  void forEachBox(const Check& check)
  {
    for (int seed = 0; seed < cases() && !HasFailure(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Operands values = operands(seed);
      check(randomBox(values), values);
    }
  }
};

TEST_P(BoxContainment, centerLiesInsideAndHalfWidthsReachTheFaces)
{
  forEachBox([this](const Box& box, Operands&) {
    const auto middle = under<Eigen::Vector3d>(mode(), [&] { return box.center(); });
    const auto half = under<Eigen::Vector3d>(mode(), [&] { return box.halfWidths(); });
    ASSERT_TRUE(box.contains(middle)) << toText(box);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_FALSE((Exact(box.upper[axis]) - Exact(middle[axis]) - Exact(half[axis])).certainlyPositive())
          << toText(box);
      ASSERT_FALSE((Exact(middle[axis]) - Exact(box.lower[axis]) - Exact(half[axis])).certainlyPositive())
          << toText(box);
    }
  });
}

TEST_P(BoxContainment, halvesShareAFaceAndCoverTheBox)
{
  forEachBox([this](const Box& box, Operands& operands) {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto halves = under<std::pair<Box, Box>>(mode(), [&] { return box.bisect(axis); });
      ASSERT_EQ(halves.first.upper[axis], halves.second.lower[axis]) << toText(box);
      ASSERT_TRUE(halves.first.isValid() && halves.second.isValid()) << toText(box);
      ASSERT_EQ(halves.first.lower, box.lower);
      ASSERT_EQ(halves.second.upper, box.upper);
      const Eigen::Vector3d p(operands.member(box.side(0)), operands.member(box.side(1)), operands.member(box.side(2)));
      ASSERT_TRUE(halves.first.contains(p) || halves.second.contains(p)) << toText(box) << " lost " << p.transpose();
      const bool shrinks = halves.first.upper[axis] < box.upper[axis] && halves.second.lower[axis] > box.lower[axis];
      ASSERT_EQ(shrinks, under<bool>(mode(), [&] { return box.canBisect(axis); })) << toText(box);
    }
  });
}

TEST_P(BoxContainment, volumeHoldsTheExactProduct)
{
  forEachBox([this](const Box& box, Operands&) {
    const auto volume = under<Interval>(mode(), [&] { return box.volume(); });
    const auto side = [&](int axis) { return Exact(box.upper[axis]) - Exact(box.lower[axis]); };
    ASSERT_TRUE((side(0) * side(1) * side(2)).mayLieIn(volume)) << volume << " " << toText(box);
    ASSERT_GE(volume.lower(), 0.0) << toText(box);
  });
}

INSTANTIATE_TEST_SUITE_P(All, BoxContainment, everyRoundingModeAndSpread(), nameOf);

TEST(Box, bisectsUntilItsFacesAreNeighbouringDoubles)
{
  Box box{ { 0.1, -1.0, 3.0 }, { 0.3, 1.0, 3.0 } };
  int steps = 0;
  for (; box.canBisect(0); ++steps)
    box = steps % 2 ? box.bisect(0).first : box.bisect(0).second;
  EXPECT_EQ(box.upper[0], std::nextafter(box.lower[0], 1.0));
  EXPECT_GT(steps, 50);
  EXPECT_FALSE(box.canBisect(2)) << "a side of zero width";
}

TEST(Box, splitsAtAPlaneAndFindsTheWidestAxis)
{
  const Box box{ { 0.0, 0.0, 0.0 }, { 1.0, 3.0, 3.0 } };
  EXPECT_EQ(box.widestAxis(), 1) << "the first of equals";
  EXPECT_EQ(box.maxWidth(), 3.0);
  const auto halves = box.splitAt(1, 0.5);
  EXPECT_EQ(halves.first.upper, Eigen::Vector3d(1.0, 0.5, 3.0));
  EXPECT_EQ(halves.second.lower, Eigen::Vector3d(0.0, 0.5, 0.0));
  EXPECT_EQ(box.volume(), Interval(9.0));
}

TEST(Box, intersectionIsInvalidWhenNothingIsCommon)
{
  const Box box{ { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
  EXPECT_TRUE(intersection(box, { { 1.0, 0.5, -1.0 }, { 2.0, 2.0, 2.0 } }).isValid()) << "a common face";
  EXPECT_FALSE(intersection(box, { { 1.5, 0.0, 0.0 }, { 2.0, 1.0, 1.0 } }).isValid());
  EXPECT_FALSE(box.contains(Eigen::Vector3d(0.5, std::numeric_limits<double>::quiet_NaN(), 0.5)));
  EXPECT_EQ(boundingBox(enclose(box)).upper, box.upper);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
