// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/smooth_surface.h"

#include <Eigen/Geometry>

#include "mesh_shading.h"
#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/ros/conversions.h"
#include "scene.h"

namespace pkm_workspace
{
namespace
{
/// How much less is seen through a surface than through boxes: of it two layers are seen through each other.
constexpr float DENSE = 2.4F;  ///< in colours that are to be told apart
constexpr float THIN = 2.2F;

/// Straight out of the surface at first close to it, then as far as four edges of the lattice.
SetPaint endBeyond(const PointEvaluator& evaluate, const PaintedTriangle& triangle, double resolution)
{
  const Eigen::Vector3d from = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
  for (const double step : { 0.25, 1.0 })
    if (const auto end = endOfSet(evaluate, from, step * resolution * outwards(triangle)))
      return paintOf(end);
  return NO_END;
}

/// rviz draws first what is far from whoever looks, mostly from above, by the places of markers: with the place of the
/// surface beneath it, what is within is seen through it and not the other way round.
Eigen::Vector3d placeBeneath(const PaintedSurface& skin)
{
  Eigen::AlignedBox<double, 3> box;
  for (const PaintedTriangle& triangle : skin)
    for (const Eigen::Vector3d& corner : triangle.corners)
      box.extend(corner);
  return { box.center().x(), box.center().y(), box.min().z() };
}

void addSkin(const std::string& ns, const Color& color, const PaintedSurface& skin, Scene& scene)
{
  if (skin.empty())
    return;
  const Eigen::Vector3d place = placeBeneath(skin);
  visualization_msgs::Marker& marker = scene.add(ns, visualization_msgs::Marker::TRIANGLE_LIST, color);
  marker.pose.position = toMessage(place);
  marker.points.reserve(3 * skin.size());
  marker.colors.reserve(3 * skin.size());
  for (const PaintedTriangle& triangle : skin)
    for (std::size_t k = 0; k < 3; ++k)
    {
      marker.points.push_back(toMessage(triangle.corners[k] - place));
      marker.colors.push_back(toMessage(colorOf(triangle.paint, color, triangle.shades[k])));
    }
}
}  // namespace

struct SmoothSurface::Skins
{
  PaintedSurface inner;
  PaintedSurface outer;
};

SmoothSurface::SmoothSurface(const SetMeshes& meshes, const Machine& machine, const Criterion& criterion,
                             SetColors colors)
{
  auto skins = std::make_unique<Skins>(Skins{ shaded(meshes.inner), shaded(meshes.outer) });
  if (colors == SetColors::CONDITION)
  {
    const PointEvaluator evaluate(machine, criterion);
    std::set<SetPaint> found;
    for (PaintedSurface* skin : { &skins->inner, &skins->outer })
      for (PaintedTriangle& triangle : *skin)
        found.insert(triangle.paint = endBeyond(evaluate, triangle, meshes.resolution));
    legend_ = legendOf(found, criterion);
  }
  skins_ = std::move(skins);
}

SmoothSurface::~SmoothSurface() = default;

void SmoothSurface::addTo(Scene& scene, const std::string& inside, const std::string& undecided, double ceiling) const
{
  const float density = legend_.empty() ? THIN : DENSE;
  addSkin(inside, densely(SET_INSIDE, density), below(skins_->inner, {}, ceiling), scene);
  addSkin(undecided, densely(SET_BOUNDARY, density), below(skins_->outer, skins_->inner, ceiling), scene);
}
}  // namespace pkm_workspace
