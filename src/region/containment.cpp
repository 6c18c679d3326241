// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/containment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "cut_off.h"
#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/dexterity/sphere_crossing.h"
#include "pkm_workspace/region/bad_point.h"
#include "pkm_workspace/region/zone_contact.h"

namespace pkm_workspace
{
namespace
{
/// Steps of one local search for a bad point.
constexpr int DESCENT_STEPS = 8;
/// A proof of a round region that has taken so many parts looks for a bad point once more, from far.
constexpr std::int64_t LONG_PROOF = 1024;
/// Parts that are looked at side by side.
constexpr std::size_t BATCH = 8;
/// The axis of a cylinder along parallel rails, or -1. Nothing but joint values changes along it, and these in
/// proportion, so that parts need not be divided there.
int wholeAxis(const BoxTest& test, const Shape& shape)
{
  return shape.isPrism() && !shape.isBox() && test.model().axisOfRails() == 2 ? 2 : -1;
}

/// Subdivides one region; looks for a bad point wherever the margin is the least so far.
class Proof : public BranchingDefaults
{
public:
  Proof(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size, const Budget& budget,
        const CutLog& cuts)
    : test_(test)
    , limits_(budget)
    , cuts_(cuts)
    , budget_(budget)
    , search_(test, shape, center, size)
    , crossing_(test.spheres())
    , shape_(shape)
    , center_(center)
    , size_(size)
    , whole_axis_(wholeAxis(test, shape))
  {}

  ContainmentResult run()
  {
    prove();
    result_.seconds = budget_.seconds();
    return result_;
  }

  static constexpr std::int64_t WAVES_A_LOOK = 32;
  std::int64_t looks() const { return result_.boxes; }
  std::size_t waveSize() const
  {
    return limits_.max_boxes > 0 ? std::min(BATCH, static_cast<std::size_t>(limits_.max_boxes - result_.boxes)) : BATCH;
  }

  /// Looks at parts side by side, divides those that stay undecided. @return whether the proof can go on
  bool expand(const std::vector<Box>& parts)
  {
    std::array<BoxVerdict, BATCH> verdicts;
    std::array<AffineForm<double>, BATCH> worst;
    std::array<HalfSpace, BATCH> within;
    if (!shape_.isBox())
      std::transform(parts.begin(), parts.end(), within.begin(),
                     [&](const Box& part) { return shape_.halfSpace(part, center_, size_); });
    test_.kernel().classify(parts.data(), parts.size(), verdicts.data(), worst.data(),
                            shape_.isBox() ? nullptr : within.data());
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (verdicts[k] == BoxVerdict::UNDECIDED)
        if (const BoxKernel* finer = test_.finerKernel(parts[k]))
          finer->classify(&parts[k], 1, &verdicts[k], &worst[k], shape_.isBox() ? nullptr : &within[k]);
    result_.boxes += static_cast<std::int64_t>(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (verdicts[k] != BoxVerdict::INSIDE && !divide(parts[k], worst[k]))
        return false;
    return !refuteWithin(parts, verdicts) && !(becomesLong() && proveBad(search_.worstFromFar()));
  }

private:
  void prove()
  {
    if (refuteAtExtremes() || refuteAtZones() || refuteAtSpheres())
      return;
    result_.is_within_rounding = !aspectIsRight();
    if (result_.is_within_rounding)
      return;
    divideAtCenter(shape_.boundingBox(center_, size_));
    if (branchAndBound(open_, *this, budget_) == Ending::EXHAUSTED)
      result_.verdict = Containment::INSIDE;
  }

  /// Parts without a point of the region are none. A box has no such parts.
  void open(const Box& part)
  {
    if (shape_.isBox() || !shape_.misses(part, center_, size_))
      open_.put(part);
  }

  /// The first looks would be lost: halves along every axis at once.
  void divideAtCenter(const Box& bounds)
  {
    std::vector<Box> parts = { bounds };
    for (int axis = 0; axis < 3; ++axis)
      if (flattened(bounds).canBisect(axis))
        for (std::size_t k = parts.size(); k-- > 0;)
        {
          const auto halves = split(parts[k], axis, parts[k].center()[axis]);
          parts[k] = halves.first;
          parts.push_back(halves.second);
        }
    for (const Box& part : parts)
      open(part);
  }

  /// Looks within half-spaces leave the aspect open; the region is connected, so that a point in its middle settles it.
  bool aspectIsRight() const
  {
    if (shape_.isBox())
      return true;
    const Eigen::Vector3d middle = center_ + 0.5 * (shape_.lower() + shape_.upper()).at(size_);
    const auto inside = nearestInside(shape_, middle, center_, size_);
    return inside && test_.classify(*inside) == BoxVerdict::INSIDE;
  }

  bool refuteAtExtremes()
  {
    std::vector<Eigen::Vector3d> points = pointsOf(shape_.extremePoints(), center_, size_);
    points.push_back(center_);
    std::vector<double> margins(points.size());
    test_.kernel().margins(points.data(), points.size(), margins.data());
    const auto worst = std::min_element(margins.begin(), margins.end());
    return refute(points[static_cast<std::size_t>(worst - margins.begin())], *worst);
  }

  bool refuteAtZones()
  {
    return std::any_of(test_.zonesToKeepOut().begin(), test_.zonesToKeepOut().end(), [&](const ZoneToKeepOut& zone) {
      return proveBad(nearestToZone(zone.numbers, shape_, center_, size_));
    });
  }

  bool becomesLong() { return !is_long_ && !shape_.isBox() && (is_long_ = result_.boxes >= LONG_PROOF); }

  bool refuteAtSpheres()
  {
    bool is_refuted = false;
    for (const StrutSphere& sphere : test_.spheres())
      is_refuted = is_refuted || refuteNear(sphere.center());
    if (!test_.spheres().empty())
      for (const Eigen::Vector3d& extreme : pointsOf(shape_.extremePoints(), center_, size_))
        is_refuted = is_refuted || refuteNear(extreme);
    return is_refuted;
  }

  /// Looks whether the region reaches over a sphere from where it was seen before to its point nearest to this one.
  bool refuteNear(const Eigen::Vector3d& point)
  {
    const auto inside = nearestInside(shape_, point, center_, size_);
    const auto bad = inside ? crossing_.add(*inside) : std::nullopt;
    if (!bad)
      return false;
    result_.verdict = Containment::OUTSIDE;
    result_.bad_point = bad->point;
    result_.bad_within = bad->distance;
    return true;
  }

  /// Looks for a bad point from the worst center of the parts that stay undecided.
  bool refuteWithin(const std::vector<Box>& parts, const std::array<BoxVerdict, BATCH>& verdicts)
  {
    std::array<Eigen::Vector3d, 2 * BATCH> centers;
    std::array<double, 2 * BATCH> margins;
    std::size_t undecided = 0;
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (verdicts[k] != BoxVerdict::INSIDE)
        for (const double side : { -1.0, 1.0 })
          if (side < 0.0 || whole_axis_ >= 0)
            centers[undecided++] = shape_.nearest(endOf(parts[k], side), center_, size_);
    if (undecided == 0)
      return false;
    for (std::size_t k = 0; k < undecided && !test_.spheres().empty(); ++k)
      if (refuteNear(centers[k]))
        return true;
    test_.kernel().margins(centers.data(), undecided, margins.data());
    const auto worst = std::min_element(margins.begin(), margins.begin() + static_cast<std::ptrdiff_t>(undecided));
    return refute(centers[static_cast<std::size_t>(worst - margins.begin())], *worst);
  }

  /// Follows the margin down from a point that is worse than all before it. @return whether a bad point is proved
  bool refute(const Eigen::Vector3d& start, double margin)
  {
    if (margin >= least_margin_)
      return false;
    const Eigen::Vector3d worst = search_.descend(start, DESCENT_STEPS);
    least_margin_ = std::min(margin, test_.margin(worst));
    return proveBad(worst);
  }

  bool proveBad(const Eigen::Vector3d& point)
  {
    result_.bad_point = search_.proveBad(point);
    if (result_.bad_point)
      result_.verdict = Containment::OUTSIDE;
    return result_.bad_point.has_value();
  }

  /// The center of a part, at one end of it where it is not divided: there joint limits are at their worst.
  Eigen::Vector3d endOf(const Box& part, double side) const
  {
    Eigen::Vector3d end = part.center();
    if (whole_axis_ >= 0)
      end[whole_axis_] = side < 0.0 ? part.lower[whole_axis_] : part.upper[whole_axis_];
    return end;
  }

  /// The part as far as it may be divided.
  Box flattened(Box part) const
  {
    if (whole_axis_ >= 0)
      part.lower[whole_axis_] = part.upper[whole_axis_];
    return part;
  }

  std::pair<Box, Box> split(const Box& part, int axis, double plane) const
  {
    if (cuts_)
      cuts_(part, axis, plane);
    return part.splitAt(axis, plane);
  }

  bool divide(const Box& part, const AffineForm<double>& worst)
  {
    const Box flat = flattened(part);
    result_.is_within_rounding = test_.isBeyondPrecision(flat);
    if (result_.is_within_rounding)
      return false;
    const Cut cut = cutOff(flat, worst);
    const auto halves = split(part, cut.axis, cut.plane);
    open(halves.second);
    open(halves.first);
    return true;
  }

  const BoxTest& test_;
  const Budget& limits_;
  const CutLog& cuts_;
  const RunningBudget budget_;
  BadPointSearch search_;
  SphereCrossing crossing_;
  const Shape& shape_;
  Eigen::Vector3d center_;
  double size_;
  int whole_axis_;
  double least_margin_ = std::numeric_limits<double>::infinity();
  bool is_long_ = false;
  DepthFirst<Box> open_;
  ContainmentResult result_;
};
}  // namespace

ContainmentResult checkContainment(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size,
                                   const Budget& budget, const CutLog& cuts)
{
  return Proof(test, shape, center, size, budget, cuts).run();
}

ContainmentResult checkContainment(const BoxTest& test, const Shape& shape, const Eigen::Vector3d& center, double size,
                                   std::int64_t max_boxes)
{
  Budget budget;
  budget.max_boxes = max_boxes;
  return checkContainment(test, shape, center, size, budget);
}
}  // namespace pkm_workspace
