// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/containment.h"

#include <limits>
#include <vector>

#include "pkm_workspace/region/bad_point.h"

namespace pkm_workspace
{
namespace
{
/// Parts narrower than this, relative to the longest strut, are beyond what doubles can settle.
constexpr double LEAST_WIDTH = 1e-13;
/// Steps of one local search for a bad point.
constexpr int STEPS = 8;

/// Subdivides one region; looks for a bad point wherever the margin is the least so far.
class Proof
{
public:
  Proof(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size)
    : test_(test), search_(test, shape, center, size), shape_(shape), center_(center), size_(size)
  {}

  ContainmentResult run(std::int64_t max_boxes, const std::atomic<bool>* stop)
  {
    for (const Eigen::Vector3d& k : shape_.extremePoints())
      if (refute(center_ + size_ * k))
        return result_;
    std::vector<Box> open = { shape_.boundingBox(center_, size_) };
    while (!open.empty())
    {
      if (result_.boxes >= max_boxes || (stop && *stop))
        return result_;
      const Box part = open.back();
      open.pop_back();
      if (shape_.misses(part, center_, size_))
        continue;
      ++result_.boxes;
      if (test_.classify(part) == BoxVerdict::INSIDE)
        continue;
      if (refute(part.center()))
        return result_;
      const int axis = part.widestAxis();
      if (part.width(axis) < LEAST_WIDTH * std::sqrt(test_.model().squaredScale()) || !part.canBisect(axis))
        return result_;
      const auto halves = part.bisect(axis);
      open.push_back(halves.second);
      open.push_back(halves.first);
    }
    result_.verdict = Containment::INSIDE;
    return result_;
  }

private:
  /// Follows the margin down from a point that is worse than all before it. @return whether a bad point is proved
  bool refute(const Eigen::Vector3d& start)
  {
    const double margin = test_.margin(start);
    if (margin >= least_margin_)
      return false;
    const Eigen::Vector3d worst = search_.descend(start, STEPS);
    least_margin_ = std::min(margin, test_.margin(worst));
    result_.bad_point = search_.proveBad(worst);
    if (result_.bad_point)
      result_.verdict = Containment::OUTSIDE;
    return result_.bad_point.has_value();
  }

  const BoxTest& test_;
  BadPointSearch search_;
  const Shape& shape_;
  Eigen::Vector3d center_;
  double size_;
  double least_margin_ = std::numeric_limits<double>::infinity();
  ContainmentResult result_;
};
}  // namespace

ContainmentResult checkContainment(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size,
                                   std::int64_t max_boxes, const std::atomic<bool>* stop)
{
  return Proof(test, shape, center, size).run(max_boxes, stop);
}
}  // namespace pkm_workspace
