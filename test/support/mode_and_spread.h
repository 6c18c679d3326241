// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "support/operands.h"
#include "support/rounding_mode.h"

namespace pkm_workspace
{
namespace test
{
/// A property that is tried under every mode with operands of every spread.
class ModeAndSpread : public testing::TestWithParam<std::tuple<RoundingMode, Spread>>
{
protected:
  const RoundingMode& mode() const { return std::get<0>(GetParam()); }
  const Spread& spread() const { return std::get<1>(GetParam()); }
  /// The operands of one case, and how to name it when it fails.
  Operands operands(int seed) const { return Operands(spread(), static_cast<std::uint64_t>(seed)); }
};

inline auto everyModeAndSpread()
{
  return testing::Combine(testing::ValuesIn(MODES), testing::ValuesIn(SPREADS));
}

/// For what reads subnormal numbers as zero where the thread does.
inline auto everyRoundingModeAndSpread()
{
  return testing::Combine(testing::ValuesIn(ROUNDING_MODES), testing::ValuesIn(SPREADS));
}

inline std::string nameOf(const testing::TestParamInfo<std::tuple<RoundingMode, Spread>>& info)
{
  return std::string(std::get<0>(info.param).name) + std::get<1>(info.param).name;
}

inline std::string nameOfMode(const testing::TestParamInfo<RoundingMode>& info)
{
  return info.param.name;
}
}  // namespace test
}  // namespace pkm_workspace
