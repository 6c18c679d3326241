// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/forms.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
/// A property of forms that is tried under every rounding mode.
class FormLaws : public testing::TestWithParam<RoundingMode>
{
protected:
  static constexpr int MEMBERS = 4;  ///< how many members of each form are tried

  /// Hands each random case to @p check until one fails.
  template <class Check>
  void forEachCase(const Check& check)
  {
    for (int seed = 0; seed < cases(400) && !HasFailure(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Forms forms(static_cast<std::uint64_t>(seed));
      check(forms);
    }
  }
  /// What @p operation returns under the rounding mode.
  template <class Result>
  Result evaluate(const std::function<Result()>& operation) const
  {
    return under<Result>(GetParam(), operation);
  }
};
}  // namespace test
}  // namespace pkm_workspace
