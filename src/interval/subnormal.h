// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace pkm_workspace
{
/// Other libraries set threads to flush subnormal results to zero (FTZ), or to read subnormal operands as zero (DAZ).
/// What may meet subnormal numbers is computed without either.
namespace subnormal
{
#if defined(__SSE2__)
constexpr unsigned int FLUSHING = 0x8040;  ///< FTZ and DAZ in MXCSR

inline bool areFlushed()
{
  return (_mm_getcsr() & FLUSHING) != 0;
}

/// For as long as it lives, this thread keeps them.
class KeepingScope
{
public:
  KeepingScope() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ & ~FLUSHING); }
  ~KeepingScope() { _mm_setcsr(saved_); }
  KeepingScope(const KeepingScope&) = delete;
  KeepingScope& operator=(const KeepingScope&) = delete;

private:
  unsigned int saved_;
};
#else
/// Not known here: rounding::selfTest() refuses threads that flush.
inline bool areFlushed()
{
  return false;
}
struct KeepingScope
{
  KeepingScope() {}
};
#endif

/// A call that the compiler cannot see through: it moves no arithmetic across.
template <class Compute>
[[gnu::noipa]] auto calledApart(const Compute& compute)
{
  return compute();
}

/// What @p compute returns where subnormal numbers are kept.
template <class Compute>
inline auto keeping(const Compute& compute)
{
  if (!areFlushed())
    return compute();
  const KeepingScope scope;
  return calledApart(compute);
}
}  // namespace subnormal
}  // namespace pkm_workspace
