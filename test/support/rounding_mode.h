// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cfenv>
#include <functional>
#include <ostream>

namespace pkm_workspace
{
namespace test
{
/// A direction in which this thread's processor may round.
struct RoundingMode
{
  const char* name;
  int value;
};

constexpr RoundingMode ROUNDING_MODES[] = {
  { "ToNearest", FE_TONEAREST }, { "Upward", FE_UPWARD }, { "Downward", FE_DOWNWARD }, { "TowardZero", FE_TOWARDZERO }
};

inline std::ostream& operator<<(std::ostream& stream, const RoundingMode& mode)
{
  return stream << mode.name;
}

/// Sets the rounding mode of this thread for as long as it lives.
class RoundingScope
{
public:
  explicit RoundingScope(const RoundingMode& mode) : saved_(std::fegetround()) { std::fesetround(mode.value); }
  ~RoundingScope() { std::fesetround(saved_); }
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

private:
  int saved_;
};

/// @return what @p compute returns under @p mode; the compiler cannot see through this call, so nothing moves across
/// it.
template <class Result>
[[gnu::noipa]] Result under(const RoundingMode& mode, const std::function<Result()>& compute)
{
  const RoundingScope scope(mode);
  return compute();
}
}  // namespace test
}  // namespace pkm_workspace
