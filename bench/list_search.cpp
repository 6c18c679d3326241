// SPDX-License-Identifier: BSD-3-Clause
#include "list_search.h"

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <vector>

#include "list_test.h"

namespace pkm_workspace
{
namespace bench
{
namespace
{
using upward::Real;
using upward::Vector;

/// A box of centers, and the corner of its regions to ask first.
struct Open
{
  Box box;
  std::size_t corner = 0;
};

class ListSearch
{
public:
  ListSearch(ListWay way, const Machine& machine, const Eigen::Vector3d& edges, const Box& centers)
    : way_(way), forms_(machine), edges_(edges), centers_(centers), center_(machine.zero())
  {
    for (int corner = 0; corner < 8; ++corner)
      if (edges[2] != 0.0 || corner < 4)
        corners_.push_back({ corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5 });
    for (Eigen::Vector3d& corner : corners_)
      corner = corner.cwiseProduct(edges);
  }

  /// Not inlined: nothing of it may be moved to where the rounding mode is not set yet.
  [[gnu::noinline]] ListAnswer run(double accuracy)
  {
    if (way_ == ListWay::EIGENVALUES)
      for (double step = 0.1; step > 1.5 * accuracy; step /= 10)
        sweep(step);
    sweep(accuracy);
    return answer_;
  }

  [[gnu::noinline]] std::int64_t verify(const Box& box) { return isInside(box, 1e-9) ? answer_.looks : 0; }

private:
  /// Goes through the list until no center of a region of edge w + step is left.
  void sweep(double step)
  {
    improve(center_, step);
    std::deque<Open> list = { { centers_, 0 } };
    while (!list.empty())
    {
      Open open = list.front();
      list.pop_front();
      ++answer_.boxes;
      if (isDiscarded(open, answer_.size + step))
        continue;
      improve(open.box.center(), step);
      const int axis = open.box.widestAxis();
      if (!open.box.canBisect(axis))
        throw std::runtime_error("the list algorithm came to the precision of doubles");
      const auto halves = open.box.bisect(axis);
      list.push_back({ halves.first, open.corner });
      list.push_back({ halves.second, open.corner });
    }
    answer_.size_upper_bound = answer_.size + step;
  }

  /// The points at one corner of the regions of that size with their centers in the box.
  Vector cornerOf(const Box& centers, std::size_t corner, double size) const
  {
    Vector p;
    for (int k = 0; k < 3; ++k)
      p[static_cast<std::size_t>(k)] = Real(centers.lower[k], centers.upper[k]) + Real(corners_[corner][k]) * size;
    return p;
  }

  BoxVerdict look(const Vector& p)
  {
    ++answer_.looks;
    return verdict(forms_.at(p), way_);
  }

  /// Whether one corner of all these regions is bad; the one that was bad last is asked first.
  bool isDiscarded(Open& open, double size)
  {
    for (std::size_t n = 0; n < corners_.size(); ++n)
    {
      const std::size_t corner = (open.corner + n) % corners_.size();
      if (look(cornerOf(open.box, corner, size)) == BoxVerdict::OUTSIDE)
      {
        open.corner = corner;
        return true;
      }
    }
    return false;
  }

  /// Takes the region around a center if it is larger by a good part of the step: its size by its corners, less a
  /// margin in which bisection proves it.
  void improve(const Eigen::Vector3d& center, double step)
  {
    Open single{ { center, center }, 0 };
    double good = answer_.size + step / 2, bad = good;
    if (isDiscarded(single, good))
      return;
    for (double more = step; !isDiscarded(single, bad = good + more); more *= 2)
      good = bad;
    while (bad - good > step / 8)
      (isDiscarded(single, 0.5 * (good + bad)) ? bad : good) = 0.5 * (good + bad);
    const double size = good - step / 4;
    Box region;
    for (int k = 0; k < 3; ++k)
    {
      const Real side = center[k] + Real(-0.5, 0.5) * (size * edges_[k]);
      region.lower[k] = side.lower();
      region.upper[k] = side.upper();
    }
    if (!isInside(region, step / 1024) || !forms_.isOwnAspect(forms_.at(upward::enclose(Box{ center, center }))))
      return;
    answer_.size = size;
    center_ = center;
  }

  /// By bisection, down to parts of that width.
  bool isInside(const Box& box, double width)
  {
    std::vector<Box> parts = { box };
    while (!parts.empty())
    {
      const Box part = parts.back();
      parts.pop_back();
      const BoxVerdict is_valid = look(upward::enclose(part));
      if (is_valid == BoxVerdict::INSIDE)
        continue;
      if (is_valid == BoxVerdict::OUTSIDE || part.maxWidth() < width)
        return false;
      const auto halves = part.bisect(part.widestAxis());
      parts.push_back(halves.first);
      parts.push_back(halves.second);
    }
    return true;
  }

  ListWay way_;
  upward::NaturalForms forms_;
  Eigen::Vector3d edges_;
  std::vector<Eigen::Vector3d> corners_;
  Box centers_;
  Eigen::Vector3d center_;  ///< of the largest region so far
  ListAnswer answer_;
};
}  // namespace

ListAnswer findLargestByList(ListWay way, const Machine& machine, const Eigen::Vector3d& edges, const Box& centers,
                             double accuracy)
{
  const upward::RoundingUpward mode;
  return ListSearch(way, machine, edges, centers).run(accuracy);
}

std::int64_t verifyByList(ListWay way, const Machine& machine, const Box& box)
{
  const upward::RoundingUpward mode;
  return ListSearch(way, machine, Eigen::Vector3d::Ones(), box).verify(box);
}
}  // namespace bench
}  // namespace pkm_workspace
