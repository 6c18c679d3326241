// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// Expects an exception of exactly this type whose text the regular expression @p pattern is found in.
template <class Exception, class Action>
void expectThrow(const Action& action, const std::string& pattern)
{
  try
  {
    action();
    ADD_FAILURE() << "nothing was thrown, expected: " << pattern;
  }
  catch (const Exception& exception)
  {
    EXPECT_EQ(typeid(exception), typeid(Exception)) << exception.what();
    EXPECT_TRUE(std::regex_search(exception.what(), std::regex(pattern)))
        << "expected: " << pattern << "\n     got: " << exception.what();
  }
}
}  // namespace test
}  // namespace pkm_workspace
