// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_options.h"

#include <cmath>
#include <filesystem>
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

bool isSameFile(const std::string& a, const std::string& b)
{
  const auto whole = [](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path));
  };
  return !a.empty() && !b.empty() && whole(a) == whole(b);
}

/// @param down whether the volume is told as a lower bound, or as an upper one
std::string meshText(const Mesh& mesh, bool down)
{
  const Interval volume = mesh.volume();
  return std::to_string(mesh.triangles.size()) + " triangles around " +
         (down ? significantBelow(volume.lower(), 6) : significantAbove(volume.upper(), 6)) + " m^3";
}
}  // namespace

void MeshOptions::declare(Options& options, const std::string& other)
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
  options.check({ "mesh", "outer-mesh", "save" }, [this, &other](Problems& problems) {
    if (isSameFile(inner_, outer_))
      problems.push_back("--mesh and --outer-mesh are one file, " + inner_ + ": give two names");
    for (const std::string& mesh : { inner_, outer_ })
      if (isSameFile(mesh, other))
        problems.push_back("a surface and --save are one file, " + mesh + ": give two names");
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
    why_none_ = "the surface was not proved within the limits: " + query.budget.endedBy(meshes_->seconds, 0) +
                " ended it; give more time or a coarser --resolution";
  else if (meshes_->outer.triangles.empty())
    why_none_ = "no point of the box belongs to the set: there is no surface";
  else if (!inner_.empty() && meshes_->inner.triangles.empty())
    why_none_ = "no part of the set is proved at a resolution of " + exact(query.resolution) +
                " m: there is no inner surface; give a finer --resolution";
}

void MeshOptions::addTo(Json& json) const
{
  if (!meshes_)
    return;
  if (!why_none_.empty())
    json["surfaces"] = Json();
  else
    json["surfaces"] = { { "inner", meshJson(meshes_->inner) },
                         { "outer", meshJson(meshes_->outer) },
                         { "distance", finite(meshes_->distance) },
                         { "seconds", meshes_->seconds } };
}

std::vector<Words> MeshOptions::rows() const
{
  if (!meshes_ || !why_none_.empty())
    return {};
  return { { "inner surface", meshText(meshes_->inner, true) },
           { "outer surface", meshText(meshes_->outer, false) + ", nowhere farther than " +
                                  significantAbove(meshes_->distance, 3) + " m from the inner one's solid" },
           { "their effort", seconds(meshes_->seconds) } };
}

void MeshOptions::save(const Machine& machine) const
{
  if (!meshes_)
    return;
  if (!why_none_.empty())
    throw std::invalid_argument(why_none_);
  const std::string title = machine.name() + ", pkm_workspace, m, ";
  if (!inner_.empty())
    saveMesh(inner_, meshes_->inner, title + "within: " + describe(criterion_));
  if (!outer_.empty())
    saveMesh(outer_, meshes_->outer, title + "around: " + describe(criterion_));
}
}  // namespace cli
}  // namespace pkm_workspace
