// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <string>

#include "pkm_workspace/ros/legend.h"

namespace pkm_workspace
{
class Scene;

/// What the colours of a set stand for: the verdict on its parts, or the condition that ends it there.
enum class SetColors
{
  CONDITION,
  VERDICT
};
constexpr std::array<const char*, 2> SET_COLORS_NAMES = { "condition", "verdict" };

/// What a set is drawn as: the surfaces of docs/surfaces.md, or the boxes of its paving.
enum class SetStyle
{
  SURFACE,
  BOXES
};
constexpr std::array<const char*, 2> SET_STYLE_NAMES = { "surface", "boxes" };

/// A set as rviz shows it. By conditions, each part of its surface has the colour of what ends the set close to it
/// (endOfSet(): no proof). Where nothing does, the set goes on, and the part has the colour of its verdict.
class SetPicture
{
public:
  virtual ~SetPicture() = default;

  /// The conditions whose colours it has, in their order; none by verdict.
  virtual const Legend& legend() const = 0;
  /// Whether it is around a region that lies in it.
  virtual bool isSolid() const = 0;
  /// Adds a list of triangles for what is inside, one for what is undecided.
  /// @param inside, undecided namespaces
  /// @param ceiling what is above it is left out [m]
  virtual void addTo(Scene& scene, const std::string& inside, const std::string& undecided,
                     double ceiling = std::numeric_limits<double>::infinity()) const = 0;
};
}  // namespace pkm_workspace
