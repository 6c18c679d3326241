// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "list_search.h"
#include "natural_forms.h"
#include "pkm_workspace/dexterity/verdict.h"

namespace pkm_workspace
{
namespace bench
{
namespace upward
{
/// Whether all members of the matrix are positive definite (INSIDE), or none is even semidefinite (OUTSIDE).
///
/// Weyl, Rohn: the eigenvalues of the members differ from those of the middle by the spectral radius rho of the matrix
/// of radii at the most.
BoxVerdict definiteness(const Symmetric& m, ListWay way);

/// The verdict on the points of the forms, in either aspect.
BoxVerdict verdict(const Forms& forms, ListWay way);
}  // namespace upward
}  // namespace bench
}  // namespace pkm_workspace
