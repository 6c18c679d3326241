// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <cfenv>
#include <functional>
#include <ostream>

namespace pkm_workspace
{
namespace test
{
/// A direction in which this thread's processor may round, and what it makes of subnormal numbers.
struct RoundingMode
{
  const char* name;
  int value;
  unsigned int flushed = 0;  ///< bits of MXCSR: 0x8000 makes subnormal results zero, 0x0040 subnormal operands
};

/// What IEEE 754 knows.
constexpr RoundingMode ROUNDING_MODES[] = {
  { "ToNearest", FE_TONEAREST }, { "Upward", FE_UPWARD }, { "Downward", FE_DOWNWARD }, { "TowardZero", FE_TOWARDZERO }
};

/// And what other libraries make of threads.
constexpr RoundingMode MODES[] = {
  ROUNDING_MODES[0],
  ROUNDING_MODES[1],
  ROUNDING_MODES[2],
  ROUNDING_MODES[3],
#ifdef __SSE2__
  { "Flushing", FE_TONEAREST, 0x8040 },
  { "FlushingResultsUpward", FE_UPWARD, 0x8000 },
  { "FlushingOperandsDownward", FE_DOWNWARD, 0x0040 },
#endif
};

inline std::ostream& operator<<(std::ostream& stream, const RoundingMode& mode)
{
  return stream << mode.name;
}

/// Sets the rounding mode of this thread for as long as it lives.
class RoundingScope
{
public:
#ifdef __SSE2__
  explicit RoundingScope(const RoundingMode& mode) : saved_(std::fegetround()), saved_bits_(_mm_getcsr())
  {
    std::fesetround(mode.value);
    _mm_setcsr(_mm_getcsr() | mode.flushed);
  }
  ~RoundingScope()
  {
    _mm_setcsr(saved_bits_);
    std::fesetround(saved_);
  }
#else
  explicit RoundingScope(const RoundingMode& mode) : saved_(std::fegetround())
  {
    std::fesetround(mode.value);
  }
  ~RoundingScope()
  {
    std::fesetround(saved_);
  }
#endif
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

private:
  int saved_;
#ifdef __SSE2__
  unsigned int saved_bits_;
#endif
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
