// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/conditioning_sentence.h"

#include <gtest/gtest.h>

namespace pkm_workspace
{
namespace test
{
TEST(ConditioningSentence, saysNothingOfAnIndexThatMayBeAny)
{
  GlobalConditioning found;
  found.index = Interval(0.0, 1.0);
  EXPECT_EQ(describe(found, {}), "Nothing is proved of the global conditioning index: the set has no proved volume.");
  Budget budget;
  budget.max_boxes = found.boxes = 7;
  EXPECT_EQ(describe(found, budget),
            "Nothing is proved of the global conditioning index: the limit of 7 boxes ended the computation.");
}

TEST(ConditioningSentence, saysWhatKeptTheAccuracyFromBeingMet)
{
  GlobalConditioning found;
  found.index = Interval(0.25, 0.5);
  EXPECT_EQ(describe(found, {}),
            "Proved: the global conditioning index is from 0.250 to 0.500. The accuracy was not met: "
            "doubles do not tell it more closely.");
  Budget budget;
  budget.max_boxes = found.boxes = 7;
  EXPECT_EQ(describe(found, budget),
            "Proved: the global conditioning index is from 0.250 to 0.500. The accuracy was not "
            "met: the limit of 7 boxes ended it.");
  found.complete = true;
  EXPECT_EQ(describe(found, {}),
            "Proved: the global conditioning index is from 0.250 to 0.500, to the accuracy asked for.");
}
}  // namespace test
}  // namespace pkm_workspace
