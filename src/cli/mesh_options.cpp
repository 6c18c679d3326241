// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_options.h"

#include <cmath>
#include <stdexcept>

#include "common_options.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/paving/mesh_file.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json meshJson(const Mesh& mesh)
{
  const Interval volume = mesh.volume();
  return { { "triangles", mesh.triangles.size() }, { "vertices", mesh.vertices.size() }, { "volume", toJson(volume) } };
}

std::string meshText(const Mesh& mesh)
{
  return std::to_string(mesh.triangles.size()) + " triangles around " + nearly(mesh.volume().mid(), 6) + " m^3";
}
}  // namespace

void MeshOptions::declare(Options& options)
{
  declareOutput(options, "mesh", inner_,
                "file for a closed surface [m] in the aspect that is asked for, STL or PLY by its ending: all points "
                "within it are proved to belong to the set; a file there is replaced");
  declareOutput(options, "outer-mesh", outer_,
                "the same for a surface that has all of the set within it; how far the two are apart is told");
  for (const auto& [name, path] : { std::make_pair("mesh", &inner_), std::make_pair("outer-mesh", &outer_) })
    options.check({ name }, [path = path](Problems& problems) {
      if (!path->empty() && !isMeshFile(*path))
        problems.push_back("the name must end in .stl or .ply");
    });
}

void MeshOptions::compute(const Machine& machine, const PavingQuery& query)
{
  if (!areAsked())
    return;
  MeshQuery wanted;
  wanted.criterion = criterion_ = query.criterion;
  wanted.resolution = query.resolution;
  wanted.box = query.box;
  wanted.budget = query.budget;
  meshes_ = setMeshes(machine, wanted);
  if (!meshes_->complete)
    throw std::invalid_argument(
        "the surface was not proved within the limits: " + query.budget.endedBy(meshes_->seconds, 0) +
        " ended it; give more time or a coarser resolution");
  if (!inner_.empty() && meshes_->inner.triangles.empty())
    throw std::invalid_argument(
        "no part of the set is proved at this resolution: there is no surface to write; give a "
        "finer resolution");
}

void MeshOptions::addTo(Json& json) const
{
  if (meshes_)
    json["surfaces"] = { { "inner", meshJson(meshes_->inner) },
                         { "outer", meshJson(meshes_->outer) },
                         { "distance", finite(meshes_->distance) },
                         { "seconds", meshes_->seconds } };
}

std::vector<Words> MeshOptions::rows() const
{
  if (!meshes_)
    return {};
  return { { "inner surface", meshText(meshes_->inner) },
           { "outer surface", meshText(meshes_->outer) + ", nowhere farther than " +
                                  significantAbove(meshes_->distance, 3) + " m from the inner one" } };
}

void MeshOptions::save(const Machine& machine) const
{
  if (!meshes_)
    return;
  const std::string title = machine.name() + ", pkm_workspace, m, ";
  if (!inner_.empty())
    saveMesh(inner_, meshes_->inner, title + "within: " + describe(criterion_));
  if (!outer_.empty())
    saveMesh(outer_, meshes_->outer, title + "around: " + describe(criterion_));
}
}  // namespace cli
}  // namespace pkm_workspace
