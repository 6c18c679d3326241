// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path_tree.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// How far bounds may be beyond the moves, relative to the farthest coordinate.
constexpr double TIGHT = 1e-13;
constexpr double SHORTEST_PATH = 1e-150;  ///< [m]
}  // namespace

void PathTree::add(const Curve& curve, const Interval& tool_speed)
{
  curves_.push_back(curve);
  speeds_.push_back(tool_speed);
}

void PathTree::close()
{
  groups_.clear();
  for (std::uint32_t level = 0; level == 0 || countAt(level) > 1; ++level)
  {
    std::vector<Group> groups((countAt(level) + GROUP - 1) / GROUP);
    for (std::size_t k = 0; k < countAt(level); ++k)
    {
      const Part part{ level, static_cast<std::uint32_t>(k) };
      const Group member{ box(part), speed(part), curvature(part) };
      Group& group = groups[k / GROUP];
      if (k % GROUP == 0)
        group = member;
      group.box = { group.box.lower.cwiseMin(member.box.lower), group.box.upper.cwiseMax(member.box.upper) };
      group.speed = hull(group.speed, member.speed);
      group.curvature = std::max(group.curvature, member.curvature);
    }
    groups_.push_back(std::move(groups));
  }
}

Box PathTree::box(const Part& part) const
{
  if (part.level > 0)
    return groups_[part.level - 1][part.index].box;
  const SkewBox<double> points = curves_[part.index].piece(part.first, part.last).points;
  Box box;
  for (int k = 0; k < 3; ++k)
  {
    const AffineForm<double> form = coordinate(points, static_cast<std::size_t>(k));
    box.lower[k] = form.lower();
    box.upper[k] = form.upper();
  }
  return box;
}

Box PathTree::bounds() const
{
  Box bounds{ Eigen::Vector3d::Constant(INF), Eigen::Vector3d::Constant(-INF) };
  const auto widen = [&bounds](const Box& box) {
    bounds = { bounds.lower.cwiseMin(box.lower), bounds.upper.cwiseMax(box.upper) };
  };
  for (std::uint32_t index = 0; index < curves_.size(); ++index)
    for (const double t : { 0.0, 1.0 })
      widen(box({ 0, index, t, t }));
  const double tolerance =
      TIGHT * std::max({ bounds.lower.cwiseAbs().maxCoeff(), bounds.upper.cwiseAbs().maxCoeff(), SHORTEST_PATH });
  std::vector<Part> open;
  for (std::uint32_t index = 0; index < curves_.size(); ++index)
    for (open.push_back({ 0, index }); !open.empty();)
    {
      const Part part = open.back();
      open.pop_back();
      const Box around = box(part);
      const double over = std::max((bounds.lower - around.lower).maxCoeff(), (around.upper - bounds.upper).maxCoeff());
      const double middle = 0.5 * part.first + 0.5 * part.last;
      if (over <= tolerance || !(part.first < middle && middle < part.last))
        widen(around);
      else
      {
        widen(box({ 0, index, middle, middle }));
        open.insert(open.end(), { { 0, index, part.first, middle }, { 0, index, middle, part.last } });
      }
    }
  return bounds;
}

Interval PathTree::speed(const Part& part) const
{
  return part.level > 0 ? groups_[part.level - 1][part.index].speed : speeds_[part.index];
}

double PathTree::curvature(const Part& part) const
{
  if (part.level > 0)
    return groups_[part.level - 1][part.index].curvature;
  const SkewBox<double> bends = curves_[part.index].curvatures(part.first, part.last);
  double most = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const AffineForm<double> form = coordinate(bends, k);
    most = std::max({ most, form.upper(), -form.lower() });
  }
  return most;
}
}  // namespace pkm_workspace
