// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/affine_form.h"
#include "pkm_workspace/interval/box.h"

namespace pkm_workspace
{
/// Where to divide a part that is undecided.
struct Cut
{
  int axis;
  double plane;
};

/// The form is negative in one corner of the part. Cutting off a slab that holds this corner leaves a part on which the
/// form is positive: across the axis where the slab is thinnest, unless that is not thin at all.
Cut cutOff(const Box& part, const AffineForm<double>& form);
}  // namespace pkm_workspace
