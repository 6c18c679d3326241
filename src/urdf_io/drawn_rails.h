// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// Between which joint values something is drawn along a leg's rail, beside it, that does not move: in floating point,
/// for display. Empty where there is nothing.
Interval drawnAlong(const Model& model, const Leg& leg);
}  // namespace urdf_io
}  // namespace pkm_workspace
