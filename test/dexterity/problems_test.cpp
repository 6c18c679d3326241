// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
TEST(Problems, areToldUpToTwenty)
{
  const Problems few(20, "wrong");
  test::expectThrow<std::invalid_argument>([&] { throwProblems(few); }, "^(wrong\n){19}wrong$");
  const Problems many(25, "wrong");
  test::expectThrow<std::invalid_argument>([&] { throwProblems(many); }, "^(wrong\n){20}and 5 more$");
}

TEST(Problems, areNoLongerThanPeopleRead)
{
  try
  {
    throwProblems({ "shape = '" + std::string(2000000, 'x') + "' must be cube" });
    FAIL() << "nothing was thrown";
  }
  catch (const std::invalid_argument& error)
  {
    const std::string text = error.what();
    EXPECT_LT(text.size(), 5000U);
    EXPECT_EQ(0U, text.find("shape = 'xxx"));
    EXPECT_NE(std::string::npos, text.find("' must be cube"));
  }
}

TEST(Shortened, keepsBothEndsAndWholeCharacters)
{
  EXPECT_EQ("0123456789", shortened("0123456789", 10));
  EXPECT_EQ("01 [7 bytes left out] 9A", shortened("0123456789A", 5));
  const std::string umlauts = shortened("\xC3\xA4\xC3\xB6\xC3\xBC\xC3\xA4\xC3\xB6\xC3\xBC", 6);
  EXPECT_EQ("\xC3\xA4 [8 bytes left out] \xC3\xBC", umlauts);
}
}  // namespace pkm_workspace
