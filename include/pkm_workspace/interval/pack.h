// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "pkm_workspace/interval/rounding.h"
#include "pkm_workspace/interval/symbols.h"

namespace pkm_workspace
{
/// The vector types of the compiler.
template <int W>
struct LanesOf;
template <>
struct LanesOf<2>
{
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Masks __attribute__((vector_size(16)));
};
template <>
struct LanesOf<4>
{
  typedef double Numbers __attribute__((vector_size(32)));
  typedef std::int64_t Masks __attribute__((vector_size(32)));
};
template <>
struct LanesOf<8>
{
  typedef double Numbers __attribute__((vector_size(64)));
  typedef std::int64_t Masks __attribute__((vector_size(64)));
};

/// One truth value a lane: all bits set, or none.
template <int W>
struct LaneMask
{
  using Lanes = typename LanesOf<W>::Masks;
  Lanes lanes;

  bool operator[](int lane) const { return lanes[lane] != 0; }
  friend LaneMask operator&(LaneMask a, LaneMask b) { return { a.lanes & b.lanes }; }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return { a.lanes | b.lanes }; }
  friend LaneMask operator!(LaneMask a) { return { ~a.lanes }; }
};

/// W doubles that are worked on side by side: a number type for the templates of this folder, each lane bit for bit
/// what double gives. W = 2 is for every x86-64 processor; a wider pack belongs only into a source file that is
/// compiled for it and chosen at run time (see dexterity/box_kernel.h).
/// PARAMETERS of a machine are what forms in it depend on besides delta; see interval/symbols.h.
template <int W, std::size_t PARAMETERS = 0>
struct Pack
{
  static constexpr int WIDTH = W;
  using Lanes = typename LanesOf<W>::Numbers;
  Lanes lanes;

  Pack() = default;
  explicit Pack(double value)
  {
    for (int lane = 0; lane < W; ++lane)
      lanes[lane] = value;  // adding it to zeros would lose the sign of -0
  }
  explicit Pack(Lanes values) : lanes(values) {}
  template <std::size_t OTHERS>
  explicit Pack(Pack<W, OTHERS> other) : lanes(other.lanes)
  {}

  /// The lanes from an array of W numbers.
  static Pack load(const double* values)
  {
    Pack result;
    __builtin_memcpy(&result.lanes, values, sizeof(result.lanes));
    return result;
  }

  double operator[](int lane) const { return lanes[lane]; }
  /// Doubles on either side of a lane's number, here itself.
  double below(int lane) const { return lanes[lane]; }
  double above(int lane) const { return lanes[lane]; }

  friend Pack operator-(Pack a) { return Pack(-a.lanes); }
  friend Pack operator+(Pack a, Pack b) { return Pack(a.lanes + b.lanes); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.lanes - b.lanes); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.lanes * b.lanes); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.lanes / b.lanes); }
  friend LaneMask<W> operator<(Pack a, Pack b) { return { a.lanes < b.lanes }; }
  friend LaneMask<W> operator>(Pack a, Pack b) { return { a.lanes > b.lanes }; }
  friend LaneMask<W> operator>=(Pack a, Pack b) { return { a.lanes >= b.lanes }; }
};

/// a where the mask is set, b elsewhere.
template <int W, std::size_t P>
inline Pack<W, P> select(LaneMask<W> mask, Pack<W, P> a, Pack<W, P> b)
{
  return Pack<W, P>(mask.lanes ? a.lanes : b.lanes);
}
template <class Real>
inline Real select(bool condition, const Real& a, const Real& b)
{
  return condition ? a : b;
}

template <int W, std::size_t P>
inline Pack<W, P> max(Pack<W, P> a, Pack<W, P> b)
{
  return select(a < b, b, a);
}
template <int W, std::size_t P>
inline Pack<W, P> min(Pack<W, P> a, Pack<W, P> b)
{
  return select(b < a, b, a);
}
template <int W, std::size_t P>
inline Pack<W, P> abs(Pack<W, P> a)
{
  using Masks = typename LanesOf<W>::Masks;
  return Pack<W, P>(typename Pack<W, P>::Lanes(Masks(a.lanes) & (Masks{} + INT64_MAX)));
}
template <int W, std::size_t P>
inline Pack<W, P> sqrt(Pack<W, P> a)
{
#if defined(__AVX512F__)
  if constexpr (W == 8)
    return Pack<W, P>(_mm512_maskz_sqrt_pd(0xFF, a.lanes));  // g++ 12 warns of the plain one
#endif
#if defined(__AVX__)
  if constexpr (W == 4)
    return Pack<W, P>(_mm256_sqrt_pd(a.lanes));
#endif
#if defined(__SSE2__)
  if constexpr (W == 2)
    return Pack<W, P>(_mm_sqrt_pd(a.lanes));
#endif
  for (int lane = 0; lane < W; ++lane)
    a.lanes[lane] = std::sqrt(a.lanes[lane]);
  return a;
}

template <int W>
inline bool any(LaneMask<W> mask)
{
  bool result = false;
  for (int lane = 0; lane < W; ++lane)
    result |= mask[lane];
  return result;
}
inline bool any(bool condition)
{
  return condition;
}

namespace rounding
{
template <int W, std::size_t P>
struct ScalarOf<Pack<W, P>>
{
  using Type = double;
};
}  // namespace rounding

template <int W, std::size_t P>
struct ParametersOf<Pack<W, P>>
{
  static constexpr std::size_t COUNT = P;
};
}  // namespace pkm_workspace
