// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "leg_forms.h"
#include "model.h"
#include "pkm_workspace/common/problems.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// One actuated joint of the machine, seen from the root link: a rail, or what drives a leg of another form.
struct Rail
{
  const urdf::Joint* joint;
  LegForm form = LegForm::SLIDER;
  Frame slider;  ///< frame of the link that the leg's passive joints begin at, which never turns, at joint value 0
  IntervalVector axis;    ///< unit direction
  IntervalVector origin;  ///< where the joint is, at joint value 0 [m]
  int direction;          ///< as in SlidingStrut
  std::string start;      ///< this link: the slider, the foot, or what the elbow carries
  std::string first;      ///< the joint there that the leg goes on with; empty: all
};

/// Finds the three rails: those named, or the only joints there are that may drive a leg. Rails that are proved to be
/// parallel share a direction, and no others do.
/// @throws std::invalid_argument when there are other than three, or what carries them moves
std::array<Rail, 3> findRails(const Model& model, const std::vector<std::string>& names);
}  // namespace urdf_io
}  // namespace pkm_workspace
