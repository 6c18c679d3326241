// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/joint_ranges.h"

#include <queue>
#include <stdexcept>

#include "pkm_workspace/dexterity/machine_forms.h"

namespace pkm_workspace
{
namespace
{
/// Which quantity of a leg is meant.
enum class Quantity
{
  JOINT,
  ETA
};

constexpr int MAX_BOXES = 20000;

/// Encloses the least value of sign * quantity over c + h K by branch and bound (best first).
class Minimum
{
public:
  Minimum(const MachineModel<double>& model, std::size_t leg, Quantity quantity, double sign)
    : model_(model), leg_(leg), quantity_(quantity), sign_(sign)
  {}

  Interval over(const Shape& shape, const Eigen::Vector3d& center, double size, double accuracy) const
  {
    double attained = form(Box{ center, center }).upper();
    for (const Eigen::Vector3d& k : shape.extremePoints())
      attained = std::min(attained, form(cornerBox(center, size, k)).upper());
    std::priority_queue<Node> open;
    const Box all = shape.boundingBox(center, size);
    open.push({ form(all).lower(), all });
    for (int boxes = 0; boxes < MAX_BOXES && attained - open.top().lower > accuracy; ++boxes)
    {
      const Node node = open.top();
      const int axis = node.box.widestAxis();
      if (!node.box.canBisect(axis))
        break;
      open.pop();
      const auto halves = node.box.bisect(axis);
      for (const Box& half : { halves.first, halves.second })
      {
        if (shape.misses(half, center, size))
          continue;
        const Eigen::Vector3d point = shape.nearest(half.center(), center, size);
        if (shape.contains(point, Box{ center, center }, size))
          attained = std::min(attained, form(Box{ point, point }).upper());
        open.push({ std::max(node.lower, form(half).lower()), half });
      }
    }
    return Interval(std::min(open.top().lower, attained), attained);
  }

private:
  struct Node
  {
    double lower;
    Box box;
    bool operator<(const Node& other) const { return lower > other.lower; }
  };

  /// A box that holds the exact point c + h k and little else.
  static Box cornerBox(const Eigen::Vector3d& center, double size, const Eigen::Vector3d& k)
  {
    return boundingBox(enclose(center) + Interval(size) * enclose(k));
  }

  AffineForm<double> form(const Box& box) const
  {
    const CenteredBox<double> centered(box);
    const MachineForms<double> forms = model_.evaluate(centered);
    if (forms.radicand[leg_].upper() < 0.0)
      throw std::domain_error("joint ranges: a strut does not reach part of the region");
    const AffineForm<double> value =
        quantity_ == Quantity::JOINT ? model_.joint(leg_, forms, centered) : forms.eta[leg_];
    return sign_ > 0.0 ? value : -value;
  }

  const MachineModel<double>& model_;
  std::size_t leg_;
  Quantity quantity_;
  double sign_;
};
}  // namespace

std::array<JointRange, 3> jointRanges(const Machine& machine, const Shape& shape, const Eigen::Vector3d& center,
                                      double size, double accuracy)
{
  Criterion reachable;
  reachable.set = Criterion::Set::REACHABLE;
  const MachineModel<double> model(machine, reachable);
  std::array<JointRange, 3> ranges;
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const auto least = [&](Quantity quantity, double sign) {
      return Minimum(model, leg, quantity, sign).over(shape, center, size, accuracy);
    };
    ranges[leg].lower = least(Quantity::JOINT, 1.0);
    ranges[leg].upper = -least(Quantity::JOINT, -1.0);
    ranges[leg].stroke = ranges[leg].upper - ranges[leg].lower;
    ranges[leg].across = -least(Quantity::ETA, -1.0) - least(Quantity::ETA, 1.0);
  }
  return ranges;
}
}  // namespace pkm_workspace
