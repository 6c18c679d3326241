// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <ios>

namespace pkm_workspace
{
namespace test
{
/// Whether two doubles agree in every bit, that of a zero's sign too; one NaN is as good as another.
inline testing::AssertionResult sameBits(double a, double b)
{
  std::uint64_t first, second;
  std::memcpy(&first, &a, sizeof(first));
  std::memcpy(&second, &b, sizeof(second));
  if (first == second || (std::isnan(a) && std::isnan(b)))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << std::hexfloat << a << " is not " << b;
}
}  // namespace test
}  // namespace pkm_workspace
