// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/plain_vector.h"

namespace pkm_workspace
{
/// One leg where the tool stands at p: the row n and the number b of n . pdot = b qdot, where q is the leg's joint
/// (docs/theory.md). In an arithmetic: Number and Vector are intervals, affine forms over a box or floating point.
template <class Number, class Vector>
struct LegState
{
  Vector row;            ///< n, a row of the parallel Jacobian A [m]
  Number squared_drive;  ///< b^2 [m^2]; nowhere negative where the leg reaches
  Number drive;          ///< b, an entry of the serial Jacobian B [m]; valid where the leg reaches
};

/// Weights that take no arithmetic.
struct Zero
{
};
struct One
{
};
struct MinusOne
{
};
template <class Number>
inline Number operator*(Zero, const Number& /*x*/)
{
  return Number();
}
template <class Number>
inline const Number& operator*(One, const Number& x)
{
  return x;
}
template <class Number>
inline Number operator*(MinusOne, const Number& x)
{
  return -x;
}

/// A leg at a point, in floating point.
struct LegAtPoint
{
  LegState<double, PlainVector<double>> state;
  double joint;  ///< q [m]
};
}  // namespace pkm_workspace
