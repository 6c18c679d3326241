// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "machine_numbers.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// A colour by name, red, green, blue, opacity.
struct Material
{
  const char* name;
  const char* rgba;
};
const std::vector<Material>& materials();

/// A solid that rviz draws: from the origin of its link, along the axes of the machine.
struct Solid
{
  enum class Shape
  {
    BOX,
    CYLINDER,
    SPHERE
  };
  Shape shape;
  Eigen::Vector3d size;      ///< box: edges; cylinder: radius, -, length; sphere: radius [m]
  Eigen::Vector3d center;    ///< [m]
  Eigen::Matrix3d rotation;  ///< a cylinder's axis is its z
  const char* material;
};

/// What rviz draws of one leg: all solids but the rail move with the link that they are named after.
struct LegLooks
{
  Solid rail;                 ///< on the root link; or what carries a crank or a strut of variable length
  std::vector<Solid> slider;  ///< or the crank
  Solid short_bar;            ///< of the parallelogram, on the knuckle at the slider and on the wrist at the platform
  Solid bar;  ///< one of the two long bars, from its own end at the slider; or the rod of a strut that gets longer
  std::vector<Solid> barrel;  ///< of such a strut, in which the rod goes
  std::vector<Solid> tip;
  Eigen::Vector3d half_width;  ///< from the strut to one of the two bars [m]
};

struct Looks
{
  std::array<LegLooks, 3> legs;
  std::vector<Solid> base;      ///< on the root link, where no leg has a rail
  std::vector<Solid> platform;  ///< with the tool, seen from the tool point
};
/// @param tool the tool point, seen from the middle of the platform [m]; 0: a tool is drawn beyond it
Looks looksOf(const std::array<LegNumbers, 3>& numbers, const Eigen::Vector3d& tool = Eigen::Vector3d::Zero());
}  // namespace urdf_io
}  // namespace pkm_workspace
