// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
/// The box verification of the paper's section 2.2: one point decides, and the characteristic polynomial carries its
/// verdict over the box.
///
/// With S(sigma) = A A^T - sigma B^2, the polynomial is P(sigma; p) = det S(sigma) (docs/theory.md: without
/// division); where B is regular it vanishes exactly where sigma is an eigenvalue of (J J^T)^-1, and S(sigma) has as
/// many positive, zero and negative eigenvalues as (J J^T)^-1 has above, at and below sigma (Sylvester). A box on which
/// every radicand L_i^2 - |q_i|^2 is positive (the paper's cylinders, section 4.2) is connected and the eigenvalues are
/// continuous on it: while P(sigma; .) has no zero there, the number of eigenvalues below sigma is the one at the
/// center. Ranges of P come from interval arithmetic with derivatives: mean-value forms, and variables set to their
/// ends where P is monotone.
///
/// A way to verdicts that shares nothing with BoxTest but the arithmetic: the two are held against each other.
/// Thread-safe: constant after construction.
class CharacteristicTest
{
public:
  /// @throws std::invalid_argument when the criterion is not valid, or asks for more than the transmission factors
  CharacteristicTest(const Machine& machine, const Criterion& criterion);

  /// One look at the box, or at a point as a box of zero width. Cost: some tens of microseconds; less for a point.
  BoxVerdict classify(const Box& box) const;
  BoxVerdict operator()(const Box& box) const { return classify(box); }

private:
  Machine machine_;
  int aspect_;          ///< wanted sign of det A; 0: either
  Interval sigma_min_;  ///< psi_min^2
  Interval sigma_max_;  ///< psi_max^2
};
}  // namespace pkm_workspace
