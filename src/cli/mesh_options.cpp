// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_options.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "common_options.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/paving/mesh_file.h"
#include "progress.h"

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

/// Why there is no file.
/// @param what of what
/// @param ended the limit that ended it
std::string notProved(const std::string& what, const std::string& ended)
{
  return "the " + what + " was not proved within the limits: " + ended +
         " ended it; the sets of both aspects, surfaces and maps take turns: give more time (--time-limit) or a "
         "coarser "
         "--resolution";
}
}  // namespace

void MeshOptions::declare(Options& options, const std::string& other)
{
  declareOutput(options, "mesh", inner_,
                "file for a closed surface [m] in the aspect that is asked for, STL or PLY by its ending: all points "
                "within it are proved to belong to the set; a file there is replaced");
  declareOutput(options, "outer-mesh", outer_,
                "the same for a surface that has all of the set within it; how far the two are apart is told");
  declareOutput(
      options, "octomap", map_file_,
      "file for a map of the set for planners, in OctoMap's binary format (.bt), with --resolution as the edge "
      "of its voxels: a free voxel is proved to belong to the set, all others in the box and a layer around "
      "it are occupied; a file there is replaced");
  options.check({ "octomap" }, [this](Problems& problems) {
    if (!map_file_.empty() && !isOctreeFile(map_file_))
      problems.push_back("the name must end in .bt");
  });
  for (const auto& [name, path] : { std::make_pair("mesh", &inner_), std::make_pair("outer-mesh", &outer_) })
    options.check({ name }, [path = path](Problems& problems) {
      if (!path->empty() && !isMeshFile(*path))
        problems.push_back("the name must end in .stl or .ply");
    });
  options.check({ "mesh", "outer-mesh", "octomap", "save" }, [this, &other](Problems& problems) {
    const std::pair<const char*, const std::string*> files[] = {
      { "--mesh", &inner_ }, { "--outer-mesh", &outer_ }, { "--octomap", &map_file_ }, { "--save", &other }
    };
    for (const auto& a : files)
      for (const auto& b : files)
        if (&a < &b && isSameFile(*a.second, *b.second))
          problems.push_back(std::string(a.first) + " and " + b.first + " are one file, " + *a.second +
                             ": give two names");
  });
}

void MeshOptions::compute(const Machine& machine, const PavingQuery& query, const std::function<Progress()>& progress)
{
  criterion_ = query.criterion;
  if (hasMeshes())
    computeMeshes(machine, query, progress());
  if (!map_file_.empty())
    computeMap(machine, query, progress());
}

void MeshOptions::computeMeshes(const Machine& machine, const PavingQuery& query, Progress progress)
{
  MeshQuery wanted;
  wanted.criterion = query.criterion;
  wanted.resolution = query.resolution;
  wanted.box = query.box;
  wanted.budget = query.budget;
  wanted.progress = [&progress](const MeshProgress& state) {
    progress.tell(std::string(state.outer ? "outer" : "inner") + " surface, " + std::to_string(state.border) +
                  " cubes at it, " + std::to_string(state.open) + " not proved");
  };
  meshes_ = setMeshes(machine, wanted);
  if (!meshes_->complete)
    why_no_mesh_ = notProved("surface", query.budget.endedBy(meshes_->seconds, 0));
  else if (meshes_->outer.triangles.empty())
    why_no_mesh_ = "no point of the box belongs to the set: there is no surface";
  else if (!inner_.empty() && meshes_->inner.triangles.empty())
    why_no_mesh_ = "no part of the set is proved at a resolution of " + exact(query.resolution) +
                   " m: there is no inner surface; give a finer --resolution";
}

void MeshOptions::computeMap(const Machine& machine, PavingQuery query, Progress progress)
{
  query.progress = [&progress](const PavingProgress& state) {
    progress.tell("map, free " + nearly(state.volume_inside) + " m^3, " + std::to_string(state.boxes) + " boxes");
  };
  map_ = octreeMap(machine, query);
  if (!map_->complete)
    why_no_map_ = notProved("map", query.budget.endedBy(map_->seconds, 0));
}

void MeshOptions::addTo(Json& json) const
{
  if (meshes_ && !why_no_mesh_.empty())
    json["surfaces"] = Json();
  else if (meshes_)
    json["surfaces"] = { { "inner", meshJson(meshes_->inner) },
                         { "outer", meshJson(meshes_->outer) },
                         { "distance", finite(meshes_->distance) },
                         { "seconds", meshes_->seconds } };
  if (map_ && !why_no_map_.empty())
    json["octomap"] = Json();
  else if (map_)
    json["octomap"] = { { "resolution", map_->resolution },
                        { "free_voxels", map_->free_voxels },
                        { "occupied_voxels", map_->occupied_voxels },
                        { "free_volume", toJson(map_->freeVolume()) },
                        { "seconds", map_->seconds } };
}

std::vector<Words> MeshOptions::rows() const
{
  std::vector<Words> rows;
  if (meshes_ && why_no_mesh_.empty())
    rows = { { "inner surface", meshText(meshes_->inner, true) },
             { "outer surface", meshText(meshes_->outer, false) + ", nowhere farther than " +
                                    significantAbove(meshes_->distance, 3) + " m from the inner one's solid" },
             { "their effort", seconds(meshes_->seconds) } };
  if (map_ && why_no_map_.empty())
    rows.push_back({ "map", std::to_string(map_->free_voxels) + " free voxels, " +
                                significantBelow(map_->freeVolume().lower(), 6) + " m^3, and " +
                                std::to_string(map_->occupied_voxels) + " occupied ones of " + exact(map_->resolution) +
                                " m, " + seconds(map_->seconds) });
  return rows;
}

void MeshOptions::save(const Machine& machine) const
{
  const std::string title = machine.name() + ", pkm_workspace, m, ";
  if (meshes_ && why_no_mesh_.empty())
  {
    if (!inner_.empty())
      saveMesh(inner_, meshes_->inner, title + "within, " + describe(criterion_));
    if (!outer_.empty())
      saveMesh(outer_, meshes_->outer, title + "around, " + describe(criterion_));
  }
  if (map_ && why_no_map_.empty())
    saveOctree(map_file_, *map_, title + "free: " + describe(criterion_));
  if (const std::string& why = why_no_mesh_.empty() ? why_no_map_ : why_no_mesh_; !why.empty())
    throw std::invalid_argument(why);
}
}  // namespace cli
}  // namespace pkm_workspace
