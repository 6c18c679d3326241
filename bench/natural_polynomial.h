// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "natural_forms.h"
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
namespace bench
{
/// The box verification of the paper's section 2.2 as the text has it: the verdict on the center holds on the box where
/// P(sigma; .) = det(A A^T - sigma B^2) has no zero, which its natural interval extension tells, without derivatives.
/// For psi in [0.5, 2] and the machine's own aspect.
class NaturalPolynomial
{
public:
  /// @param machine with rails along axes of the root frame
  explicit NaturalPolynomial(const Machine& machine) : forms_(machine) {}

  BoxVerdict operator()(const Box& box) const;

private:
  BoxVerdict classify(const Box& box) const;

  upward::NaturalForms forms_;
};
}  // namespace bench
}  // namespace pkm_workspace
