// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_section.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

struct ShadedPoint
{
  Vector3d point;
  float shade;
};
using Polygon = std::vector<ShadedPoint>;

/// Part of a section's border.
struct BorderLine
{
  Vector2d left, right;
  int turn;  ///< how often more the surface goes around what is above the line, along y, than around what is below
  bool of_hole;

  double at(double x) const
  {
    const double share = (x - left.x()) / (right.x() - left.x());
    return left.y() + share * (right.y() - left.y());
  }
};

/// The same, bit for bit, for both triangles of an edge.
ShadedPoint crossing(const ShadedPoint& a, const ShadedPoint& b, double height)
{
  const bool in_order =
      std::lexicographical_compare(a.point.data(), a.point.data() + 3, b.point.data(), b.point.data() + 3);
  const ShadedPoint &from = in_order ? a : b, &to = in_order ? b : a;
  const double share = (height - from.point.z()) / (to.point.z() - from.point.z());
  Vector3d point = from.point + share * (to.point - from.point);
  point.z() = height;
  return { point, from.shade + static_cast<float>(share) * (to.shade - from.shade) };
}

/// What of a triangle is not above the height. @param line gets the ends of the part of its border at the height
Polygon cutOff(const PaintedTriangle& triangle, double height, std::vector<Vector3d>& line)
{
  Polygon kept;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    const ShadedPoint from{ triangle.corners[k], triangle.shades[k] };
    const ShadedPoint to{ triangle.corners[next], triangle.shades[next] };
    const bool is_below = from.point.z() <= height;
    if (is_below)
      kept.push_back(from);
    if (is_below == (to.point.z() <= height))
      continue;
    kept.push_back(crossing(from, to, height));
    // along the border of what is kept the line goes from where the triangle rises above the height
    line.insert(is_below ? line.begin() : line.end(), kept.back().point);
  }
  return kept;
}

void addLine(const std::vector<Vector3d>& line, bool of_hole, std::vector<BorderLine>& border)
{
  if (line.size() != 2 || line[0].x() == line[1].x())
    return;
  // seen from above, the solid is on the right of the line
  const bool is_forward = line[0].x() < line[1].x();
  const Vector3d &left = line[is_forward ? 0 : 1], &right = line[is_forward ? 1 : 0];
  border.push_back({ left.head<2>(), right.head<2>(), is_forward ? -1 : 1, of_hole });
}

/// The part of a section between two lines across x.
void addSlab(double from, double to, std::vector<const BorderLine*>& lines, double height, PaintedSurface& surface)
{
  const double middle = 0.5 * (from + to);
  std::sort(lines.begin(), lines.end(),
            [middle](const BorderLine* a, const BorderLine* b) { return a->at(middle) < b->at(middle); });
  int around = 0, around_hole = 0;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k)
  {
    (lines[k]->of_hole ? around_hole : around) += lines[k]->turn;
    if (around == 0 || around_hole != 0)
      continue;
    const auto point = [height](const BorderLine* line, double x) { return Vector3d(x, line->at(x), height); };
    const BorderLine *low = lines[k], *high = lines[k + 1];
    surface.push_back({ { point(low, from), point(low, to), point(high, to) } });
    surface.push_back({ { point(low, from), point(high, to), point(high, from) } });
  }
}

/// Cut into slabs at all ends of lines: in each of them lines do not meet but at their ends.
void addSection(const std::vector<BorderLine>& border, double height, PaintedSurface& surface)
{
  std::vector<double> cuts;
  for (const BorderLine& line : border)
    cuts.insert(cuts.end(), { line.left.x(), line.right.x() });
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<const BorderLine*> across;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
  {
    across.clear();
    for (const BorderLine& line : border)
      if (line.left.x() <= cuts[k] && line.right.x() >= cuts[k + 1])
        across.push_back(&line);
    addSlab(cuts[k], cuts[k + 1], across, height, surface);
  }
}
}  // namespace

PaintedSurface below(const PaintedSurface& surface, const PaintedSurface& hole, double height)
{
  PaintedSurface kept;
  std::vector<BorderLine> border;
  for (const PaintedTriangle& triangle : surface)
  {
    std::vector<Vector3d> line;
    const Polygon part = cutOff(triangle, height, line);
    for (std::size_t k = 2; k < part.size(); ++k)
      kept.push_back({ { part[0].point, part[k - 1].point, part[k].point },
                       { part[0].shade, part[k - 1].shade, part[k].shade },
                       triangle.paint });
    addLine(line, false, border);
  }
  for (const PaintedTriangle& triangle : hole)
  {
    std::vector<Vector3d> line;
    cutOff(triangle, height, line);
    addLine(line, true, border);
  }
  addSection(border, height, kept);
  return kept;
}
}  // namespace pkm_workspace
