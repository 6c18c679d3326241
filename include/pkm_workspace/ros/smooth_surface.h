// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pkm_workspace/paving/set_mesh.h"
#include "pkm_workspace/ros/set_picture.h"

namespace pkm_workspace
{
/// The surfaces of a set (docs/surfaces.md): the inner one, and around it the outer one for what is undecided. Shaded
/// as if lit, by colours of its own: rviz has no lamp for what has them, and none that is smooth for others.
class SmoothSurface : public SetPicture
{
public:
  /// @param meshes complete, of the criterion's set; where there is no outer one, nothing of what is undecided is shown
  SmoothSurface(const SetMeshes& meshes, const Machine& machine, const Criterion& criterion, SetColors colors);
  ~SmoothSurface() override;

  const Legend& legend() const override { return legend_; }
  bool isSolid() const override { return true; }
  void addTo(Scene& scene, const std::string& inside, const std::string& undecided, double ceiling) const override;

private:
  struct Skins;

  std::unique_ptr<const Skins> skins_;
  Legend legend_;
};
}  // namespace pkm_workspace
