// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cfloat>
#include <limits>
#include <string>

// A compiler that may reorder or drop roundings makes every proof void: refuse it.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "pkm_workspace proves its results: compile it without -ffast-math and without any of its parts"
#endif
static_assert(FLT_EVAL_METHOD == 0, "pkm_workspace needs doubles that are evaluated as doubles (SSE2, not x87)");
static_assert(std::numeric_limits<double>::is_iec559, "pkm_workspace needs IEEE 754 doubles");

namespace pkm_workspace
{
constexpr double INF = std::numeric_limits<double>::infinity();

/// What is known about floating-point rounding; every bound of the project rests on this file and on interval.cpp.
namespace rounding
{
/// Neighbouring doubles (or one double twice) between which an exact result lies.
struct Bounds
{
  double lower;
  double upper;
};

/// Enclosures of one exact operation by neighbouring doubles: as tight as doubles allow, on any thread in any mode.
/// Each takes the sign of the rounding error from an error-free transformation (Dekker 1971; Boldo, Graillat, Muller
/// 2017 for modes other than to nearest). Infinite operands follow IEEE 1788: 0 * infinity is 0.
Bounds add(double a, double b);
Bounds multiply(double a, double b);
Bounds divide(double a, double b);
Bounds squareRoot(double a);

/// Largest error of one operation, relative to its result, in any rounding mode; see roundoff().
#ifdef PKM_WORKSPACE_UNSOUND_ROUNDING
constexpr bool SOUND = false;  // the canary build: the tests must notice
#else
constexpr bool SOUND = true;
#endif

/// The type whose arithmetic that of Real is made of.
template <class Real>
struct ScalarOf
{
  using Type = Real;
};

/// @return a bound on |fl(x op y) - (x op y)| / |fl(x op y)| in any rounding mode, for the arithmetic of Real.
template <class Real>
inline Real roundoff()
{
  return Real(SOUND ? std::numeric_limits<typename ScalarOf<Real>::Type>::epsilon() : 0);
}

/// @return a bound on the underflow of one affine operation, also where it is flushed to zero; far below a length [m].
template <class Real>
inline Real underflow()
{
  return SOUND ? Real(1e-290) : Real(0);
}

/// Looks whether this thread's arithmetic is the one the proofs assume: sound enclosures, nothing lost to zero in them.
/// @return an empty string, or one sentence that says what is wrong.
std::string selfTest();
}  // namespace rounding
}  // namespace pkm_workspace
