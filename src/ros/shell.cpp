// SPDX-License-Identifier: BSD-3-Clause
#include "shell.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace pkm_workspace
{
namespace
{
using Index = std::array<std::size_t, 3>;

enum class Content : std::uint8_t
{
  NOTHING,
  BOXES,
  OTHERS,
};

/// The cells between all planes that boxes end at.
class Cells
{
public:
  Cells(const std::vector<Box>& boxes, const std::vector<Box>& others, const std::vector<Box>& absent)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      for (const std::vector<Box>* some : { &boxes, &others, &absent })
        for (const Box& box : *some)
          planes_[k].insert(planes_[k].end(), { box.lower[static_cast<int>(k)], box.upper[static_cast<int>(k)] });
      std::sort(planes_[k].begin(), planes_[k].end());
      planes_[k].erase(std::unique(planes_[k].begin(), planes_[k].end()), planes_[k].end());
    }
    contents_.resize(planes_[0].size() * planes_[1].size() * planes_[2].size(), Content::NOTHING);
    fill(others, Content::OTHERS);
    fill(boxes, Content::BOXES);
  }

  /// How many planes there are across an axis.
  std::size_t planes(std::size_t axis) const { return planes_[axis].size(); }
  double plane(std::size_t axis, std::size_t number) const { return planes_[axis][number]; }
  Content at(const Index& cell) const { return contents_[numberOf(cell)]; }

private:
  std::size_t numberOf(const Index& cell) const
  {
    return (cell[0] * planes_[1].size() + cell[1]) * planes_[2].size() + cell[2];
  }

  Index firstOf(const Eigen::Vector3d& corner) const
  {
    Index index{};
    for (std::size_t k = 0; k < 3; ++k)
      index[k] = static_cast<std::size_t>(
          std::lower_bound(planes_[k].begin(), planes_[k].end(), corner[static_cast<int>(k)]) - planes_[k].begin());
    return index;
  }

  void fill(const std::vector<Box>& boxes, Content content)
  {
    for (const Box& box : boxes)
    {
      const Index first = firstOf(box.lower);
      const Index end = firstOf(box.upper);
      Index cell{};
      for (cell[0] = first[0]; cell[0] < end[0]; ++cell[0])
        for (cell[1] = first[1]; cell[1] < end[1]; ++cell[1])
          for (cell[2] = first[2]; cell[2] < end[2]; ++cell[2])
            contents_[numberOf(cell)] = content;
    }
  }

  std::array<std::vector<double>, 3> planes_;
  std::vector<Content> contents_;
};

/// One plane's faces that point to one side.
class Sheet
{
public:
  Sheet(const Cells& cells, std::size_t axis, std::size_t plane, bool is_upper, const Paint& paint)
    : cells_(cells), axis_(axis), plane_(plane), is_upper_(is_upper), faces_(columns() * rows())
  {
    for (std::size_t u = 0; u + 1 < columns(); ++u)
      for (std::size_t v = 0; v + 1 < rows(); ++v)
        if (isBorder(u, v))
          at(u, v) = static_cast<std::uint8_t>(1 + paint(patchAt({ u, u + 1 }, { v, v + 1 })));
  }

  /// Takes rectangles of one paint out, each as long as can be along one axis and then along the other.
  void cut(std::vector<Patch>& patches)
  {
    for (std::size_t v = 0; v < rows(); ++v)
      for (std::size_t u = 0; u < columns(); ++u)
        if (at(u, v))
          patches.push_back(take(u, v));
  }

private:
  using Range = std::pair<std::size_t, std::size_t>;  ///< of planes

  std::size_t columns() const { return cells_.planes((axis_ + 1) % 3); }
  std::size_t rows() const { return cells_.planes((axis_ + 2) % 3); }
  std::uint8_t& at(std::size_t u, std::size_t v) { return faces_[v * columns() + u]; }

  bool isBorder(std::size_t u, std::size_t v) const
  {
    Index below{};
    below[axis_] = plane_ - 1;
    below[(axis_ + 1) % 3] = u;
    below[(axis_ + 2) % 3] = v;
    Index above = below;
    above[axis_] = plane_;
    const Content before = plane_ > 0 ? cells_.at(below) : Content::NOTHING;
    const Content after = plane_ + 1 < cells_.planes(axis_) ? cells_.at(above) : Content::NOTHING;
    return is_upper_ ? before == Content::BOXES && after == Content::NOTHING
                     : before == Content::NOTHING && after == Content::BOXES;
  }

  bool isFull(std::size_t first, std::size_t end, std::size_t v, std::uint8_t mark)
  {
    for (std::size_t u = first; u < end; ++u)
      if (at(u, v) != mark)
        return false;
    return true;
  }

  Patch take(std::size_t u, std::size_t v)
  {
    const std::uint8_t mark = at(u, v);
    std::size_t right = u;
    while (right < columns() && at(right, v) == mark)
      ++right;
    std::size_t top = v;
    for (; top < rows() && isFull(u, right, top, mark); ++top)
      std::fill(&at(u, top), &at(u, top) + (right - u), std::uint8_t(0));
    Patch patch = patchAt({ u, right }, { v, top });
    patch.paint = static_cast<std::uint8_t>(mark - 1);
    return patch;
  }

  Patch patchAt(const Range& u, const Range& v) const
  {
    Patch patch{ static_cast<int>(axis_), is_upper_, {} };
    set(patch, axis_, plane_, plane_);
    set(patch, (axis_ + 1) % 3, u.first, u.second);
    set(patch, (axis_ + 2) % 3, v.first, v.second);
    return patch;
  }

  void set(Patch& patch, std::size_t axis, std::size_t first, std::size_t last) const
  {
    patch.box.lower[static_cast<int>(axis)] = cells_.plane(axis, first);
    patch.box.upper[static_cast<int>(axis)] = cells_.plane(axis, last);
  }

  const Cells& cells_;
  std::size_t axis_;
  std::size_t plane_;
  bool is_upper_;
  std::vector<std::uint8_t> faces_;  ///< 1 + its paint, or 0 where no face is left
};
}  // namespace

std::vector<Patch> shellOf(const std::vector<Box>& boxes, const std::vector<Box>& others,
                           const std::vector<Box>& absent, const Paint& paint)
{
  const Cells cells(boxes, others, absent);
  std::vector<Patch> patches;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t plane = 0; plane < cells.planes(axis); ++plane)
      for (const bool is_upper : { false, true })
        Sheet(cells, axis, plane, is_upper, paint).cut(patches);
  return patches;
}
}  // namespace pkm_workspace
