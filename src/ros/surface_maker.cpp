// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/surface_maker.h"

#include <ros/console.h>

#include <algorithm>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/ros/smooth_surface.h"

namespace pkm_workspace
{
namespace
{
constexpr double LIMIT = 60.0;       // [s] the boxes are shown meanwhile
constexpr double MOST_EDGES = 40.0;  // in the longest side of a box: rviz draws some ten thousand triangles with ease

MeshQuery queryOf(const Machine& machine, const Paving& paving)
{
  MeshQuery query;
  query.criterion = paving.premises.criterion;
  query.resolution = std::max(paving.resolution, paving.box.maxWidth() / MOST_EDGES);
  const Box all = defaultBox(machine, query.criterion);
  if (paving.box.lower != all.lower || paving.box.upper != all.upper)
    query.box = paving.box;
  query.budget.time_limit = LIMIT;
  return query;
}

/// Why pictures of a set are of its boxes; empty where they need not be.
std::string objectionTo(const SetMeshes& meshes)
{
  if (!meshes.complete)
    return "it takes more than " + nearly(LIMIT) + " s";
  if (meshes.inner.triangles.empty())
    return "nothing is left of it at a resolution of " + nearly(meshes.resolution, 3) + " m";
  return "";
}
}  // namespace

void SurfaceMaker::make(const FramedMachine& in, const std::shared_ptr<const Paving>& paving, bool with_outer,
                        const Show& show)
{
  const bool is_flat = !((paving->box.upper - paving->box.lower).array() > 0.0).all();
  const StopFlag stop = context_.modeller.makeStopFlag();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    *last_ = true;
    last_ = stop;
  }
  if (context_.parameters.set_style == SetStyle::BOXES || is_flat)
    return;
  context_.modeller.post([this, machine = in.machine, paving, with_outer, show, stop] {
    if (const auto surface = surfaceOf(*machine, *paving, with_outer, stop))
      context_.painter.post([surface, show, stop] {
        if (!*stop)
          show(surface);
      });
  });
}

std::shared_ptr<const SetPicture> SurfaceMaker::surfaceOf(const Machine& machine, const Paving& paving, bool with_outer,
                                                          const StopFlag& stop) const
{
  std::string objection;
  try
  {
    MeshQuery query = queryOf(machine, paving);
    query.budget.threads = std::max(1, context_.parameters.query.budget.threads / 2);  // who asks goes first
    query.budget.stop = stop.get();
    query.with_outer = with_outer;
    const SetMeshes meshes = setMeshes(machine, query);
    if (*stop)
      return nullptr;
    objection = objectionTo(meshes);
    if (objection.empty())
    {
      ROS_INFO_NAMED("paving", "surface of the set at resolution %.3g m: %zu triangles%s; %.3g s", meshes.resolution,
                     meshes.inner.triangles.size() + meshes.outer.triangles.size(),
                     with_outer ? (" in two surfaces, " + nearly(meshes.distance, 3) + " m apart at most").c_str() : "",
                     meshes.seconds);
      return std::make_shared<SmoothSurface>(meshes, machine, query.criterion, context_.parameters.set_colors);
    }
  }
  catch (const std::invalid_argument& error)
  {
    objection = error.what();
  }
  ROS_WARN_STREAM_NAMED("paving", "the set is shown by boxes, without its surface: " << objection);
  return nullptr;
}
}  // namespace pkm_workspace
