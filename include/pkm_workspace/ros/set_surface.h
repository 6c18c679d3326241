// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "pkm_workspace/paving/paving.h"
#include "pkm_workspace/ros/set_picture.h"

namespace pkm_workspace
{
class PointEvaluator;
struct Patch;

/// The surface of a paving's boxes as rviz shows it, as coarsely as it takes for about 20000 boxes.
///
/// What ends the set is looked for within four of the smallest boxes beyond a part or, if nothing does, beside it; of
/// flat boxes within two beside it.
class SetSurface : public SetPicture
{
public:
  /// @param machine in whose frame the paving is
  /// @param with_boundary whether its undecided boxes are to be shown
  SetSurface(const Paving& paving, const Machine& machine, SetColors colors, bool with_boundary);

  const Legend& legend() const override { return legend_; }
  /// @param ceiling boxes that reach above it are left out [m]; flat ones that do not change along z are lowered to it
  bool isSolid() const override { return (whole_.upper.array() > whole_.lower.array()).all(); }
  void addTo(Scene& scene, const std::string& inside, const std::string& undecided, double ceiling) const override;

private:
  /// Part of the surface: undecided or not, axis, side, and its middle.
  using Part = std::tuple<bool, int, bool, double, double, double>;
  struct Boxes
  {
    std::vector<Box> shown;
    std::vector<Box> absent;
  };

  Part partOf(const Patch& patch, bool is_open) const;
  Boxes below(const std::vector<Box>& boxes, double unit, double ceiling) const;
  void findEnds(const PointEvaluator& evaluate, const std::vector<Box>& boxes, const std::vector<Box>& others,
                bool is_open);
  std::uint8_t paintAt(const PointEvaluator& evaluate, const Patch& patch) const;
  void addShell(const std::string& ns, const Color& color, const std::vector<Box>& others, const Boxes& boxes,
                bool is_open, Scene& scene) const;

  Box whole_;
  Eigen::Vector3d finest_;  ///< sides of the smallest boxes [m]
  std::vector<Box> good_;
  std::vector<Box> open_;
  std::map<Part, std::uint8_t> ends_;  ///< 1 + the condition, where there is one
  Legend legend_;
};
}  // namespace pkm_workspace
