// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/set_surface.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "pkm_workspace/ros/conversions.h"
#include "scene.h"
#include "set_paint.h"
#include "shell.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr std::int64_t MOST_BOXES = 20000;

std::vector<Box> boxesOf(const BoxTree& tree, const std::vector<CellState>& states)
{
  std::vector<Box> found;
  for (const CellState state : states)
    for (const std::vector<Box>& boxes : tree.boxes(state))
      found.insert(found.end(), boxes.begin(), boxes.end());
  return found;
}

/// Two triangles that are seen from both sides.
void addPatch(const Patch& patch, std::vector<geometry_msgs::Point>& points)
{
  const int u = (patch.axis + 1) % 3;
  std::array<Eigen::Vector3d, 4> corners{ patch.box.lower, patch.box.lower, patch.box.upper, patch.box.upper };
  corners[1][u] = patch.box.upper[u];
  corners[3][u] = patch.box.lower[u];
  if (!patch.is_upper)
    std::swap(corners[1], corners[3]);
  for (const std::size_t k : { 0U, 1U, 2U, 0U, 2U, 3U })
    points.push_back(toMessage(corners[k]));
}

constexpr float SHADES[] = { 0.92F, 0.84F, 1.0F };  ///< of faces across each axis
}  // namespace

SetSurface::SetSurface(const Paving& paving, const Machine& machine, SetColors colors, bool with_boundary)
  : whole_(paving.tree.bisection().root())
{
  const BoxTree coarse = paving.tree.coarsened(MOST_BOXES);
  const std::size_t level = coarse.levels() > 0 ? coarse.levels() - 1 : 0;
  const Box smallest = coarse.bisection().box({ 0, 0, 0 }, level);
  finest_ = smallest.upper - smallest.lower;
  good_ = boxesOf(coarse, { CellState::INSIDE });
  if (with_boundary)
    open_ = boxesOf(coarse, { CellState::BOUNDARY, CellState::PENDING });
  if (colors == SetColors::VERDICT)
    return;
  const PointEvaluator evaluate(machine, paving.premises.criterion);
  findEnds(evaluate, good_, {}, false);
  findEnds(evaluate, open_, good_, true);
  std::set<SetPaint> found;
  for (const auto& [part, end] : ends_)
    found.insert(end);
  legend_ = legendOf(found, paving.premises.criterion);
}

SetSurface::Part SetSurface::partOf(const Patch& patch, bool is_open) const
{
  Eigen::Vector3d middle = patch.box.center();
  for (int k = 0; k < 3; ++k)
    if (whole_.width(k) == 0.0)
      middle[k] = 0.0;  // wherever it is lowered to
  return { is_open, patch.axis, patch.is_upper, middle.x(), middle.y(), middle.z() };
}

/// Flat ones (their set does not change along the rails, and the region lies in their plane) get a little thickness,
/// just below it.
SetSurface::Boxes SetSurface::below(const std::vector<Box>& boxes, double unit, double ceiling) const
{
  const Eigen::Vector3d thickness = unit * ((whole_.upper - whole_.lower).array() == 0.0).cast<double>().matrix();
  const double lowered = thickness.z() > 0.0 ? std::min(0.0, ceiling - whole_.upper.z()) : 0.0;
  const Eigen::Vector3d shift(0.0, 0.0, lowered);
  Boxes found;
  for (const Box& box : boxes)
  {
    std::vector<Box>& part = box.upper.z() + lowered <= ceiling ? found.shown : found.absent;
    part.push_back({ box.lower + shift - 2.5 * thickness, box.upper + shift - 1.5 * thickness });
  }
  return found;
}

void SetSurface::findEnds(const PointEvaluator& evaluate, const std::vector<Box>& boxes, const std::vector<Box>& others,
                          bool is_open)
{
  constexpr double ANY = 1.0;
  constexpr double EVERYWHERE = std::numeric_limits<double>::infinity();
  shellOf(below(boxes, ANY, EVERYWHERE).shown, below(others, ANY, EVERYWHERE).shown, {},
          [&](const Patch& patch) { return ends_[partOf(patch, is_open)] = paintAt(evaluate, patch); });
}

std::uint8_t SetSurface::paintAt(const PointEvaluator& evaluate, const Patch& patch) const
{
  Eigen::Vector3d from = patch.box.center();
  for (int k = 0; k < 3; ++k)
    if (whole_.width(k) == 0.0)
      from[k] = whole_.lower[k];
  const bool is_flat_side = whole_.width(patch.axis) == 0.0;
  const Eigen::Vector3d across =
      (patch.is_upper ? 1.0 : -1.0) * finest_[patch.axis] * Eigen::Vector3d::Unit(patch.axis);
  std::optional<SetEnd> nearest;
  if (!is_flat_side)
    nearest = endOfSet(evaluate, from, across);
  if (nearest)
    return paintOf(nearest);
  for (int axis = 0; axis < 3; ++axis)
    for (const double step : { -finest_[axis], finest_[axis] })
      if (const auto end = endOfSet(evaluate, from, (is_flat_side ? 0.5 : 1.0) * step * Eigen::Vector3d::Unit(axis));
          end && (!nearest || (end->bad - from).norm() < (nearest->bad - from).norm()))
        nearest = end;
  return paintOf(nearest);
}

/// By colours of its own: rviz then leaves its lamp out, which would make most faces dark.
void SetSurface::addShell(const std::string& ns, const Color& color, const std::vector<Box>& others, const Boxes& boxes,
                          bool is_open, Scene& scene) const
{
  if (boxes.shown.empty())
    return;
  Marker& surface = scene.add(ns, Marker::TRIANGLE_LIST, color);
  const auto paint = [&](const Patch& patch) {
    const auto end = ends_.find(partOf(patch, is_open));
    return end == ends_.end() ? NO_END : end->second;
  };
  for (const Patch& patch : shellOf(boxes.shown, others, boxes.absent, paint))
  {
    addPatch(patch, surface.points);
    surface.colors.resize(surface.points.size(), toMessage(colorOf(patch.paint, color, SHADES[patch.axis])));
  }
}

void SetSurface::addTo(Scene& scene, const std::string& inside, const std::string& undecided, double ceiling) const
{
  const Boxes good = below(good_, scene.unit(), ceiling);
  Boxes open = below(open_, scene.unit(), ceiling);
  open.absent.insert(open.absent.end(), good.absent.begin(), good.absent.end());
  // of a solid four layers are seen through each other
  const float density = (isSolid() ? 1.0F : 2.2F) * (isSolid() && !legend_.empty() ? DENSER : 1.0F);
  addShell(inside, densely(SET_INSIDE, density), {}, good, false, scene);
  addShell(undecided, densely(SET_BOUNDARY, density), good.shown, open, true, scene);
}
}  // namespace pkm_workspace
