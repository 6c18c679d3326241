// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/fitting_bounds.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "pkm_workspace/dexterity/verdict.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// How much wider than at the best point: the Orthoglide's factors are 1 there, and the paper's bounds [0.5, 2].
constexpr double ROOM = 2.0;
/// Points to either side of the middle that the search looks at first, along each axis.
constexpr int GRID = 5;
/// A point is better by at least this share: less is rounding.
constexpr double LEAST_GAIN = 1e-9;
constexpr int MOST_MOVES = 1000;

/// The middle of the travels as a tool point; the zero configuration where they have no ends or no such pose.
Vector3d middleOf(const Machine& machine)
{
  Vector3d joints;
  for (int i = 0; i < 3; ++i)
    joints[i] = machine.leg(i).limits.isBounded() ? machine.leg(i).limits.mid() : 0.0;
  return forwardKinematics(machine, joints).value_or(machine.zero());
}

/// The factors at a point of the set; nothing elsewhere.
std::optional<Vector3d> factorsAt(const Machine& machine, const Criterion& criterion, const Vector3d& p)
{
  const auto at = jacobians(machine, p);
  const auto joints = inverseKinematics(machine, p);
  const int sign = criterion.wantedSign(machine.aspect());
  if (!at || !joints || !(sign == 0 || sign * at->a.determinant() > 0.0))
    return std::nullopt;
  for (int i = 0; criterion.joint_limits && i < 3; ++i)
    if (!machine.leg(i).limits.contains((*joints)[i]))
      return std::nullopt;
  const Vector3d psi = transmissionFactors(*at);
  return psi.allFinite() && psi[0] > 0.0 ? std::make_optional(psi) : std::nullopt;
}

/// How far the factors are from 1.
double spread(const Vector3d& psi)
{
  return std::max(psi[2], 1.0 / psi[0]);
}

/// All that the criterion asks for besides the factors, and joint limits, at which a point may stand.
Criterion restOf(Criterion criterion)
{
  criterion.set = Criterion::Set::REACHABLE;
  criterion.joint_limits = false;
  return criterion;
}

/// The least spread that was found, and where.
class BestPoint
{
public:
  BestPoint(const Machine& machine, const Criterion& criterion)
    : machine_(machine), criterion_(criterion), rest_(machine, restOf(criterion))
  {}

  bool tryPoint(const Vector3d& p)
  {
    const auto psi = factorsAt(machine_, criterion_, p);
    if (!psi || (best_ && spread(*psi) >= (1.0 - LEAST_GAIN) * spread(best_->psi)) || isExcluded(p))
      return false;
    best_ = FittingBounds{ p, *psi, 0.0, 0.0 };
    return true;
  }

  /// Compass search: to better neighbours, with a step that is halved where there is none. Ends by counting at the
  /// latest: where nothing changes along the rails, rounding could lead it on.
  void refine(double step, double least)
  {
    for (int moves = 0; best_ && step > least && moves < MOST_MOVES; ++moves)
    {
      bool better = false;
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : { -step, step })
          better = tryPoint(best_->point + side * Vector3d::Unit(axis)) || better;
      step = better ? step : 0.5 * step;
    }
  }

  const std::optional<FittingBounds>& best() const { return best_; }

private:
  bool isExcluded(const Vector3d& p) const { return rest_.classify(Box{ p, p }) == BoxVerdict::OUTSIDE; }

  const Machine& machine_;
  const Criterion& criterion_;
  BoxTest rest_;
  std::optional<FittingBounds> best_;
};

/// The largest number of two significant digits that is not above, but for rounding.
double twoDigitsBelow(double value)
{
  const double power = std::pow(10.0, 1.0 - std::floor(std::log10(value)));
  return *parseNumber(nearly(std::floor(value * power * (1.0 + 1e-12)) / power, 2));
}

std::string rangeOf(const Vector3d& psi)
{
  return nearly(psi[0], 3) + " to " + nearly(psi[2], 3);
}

std::string placeOf(const Vector3d& p)
{
  return "(" + nearly(p.x(), 3) + ", " + nearly(p.y(), 3) + ", " + nearly(p.z(), 3) + ") m";
}
}  // namespace

std::optional<FittingBounds> fittingBounds(const Machine& machine, const Criterion& criterion)
{
  BestPoint search(machine, criterion);
  const Vector3d middle = middleOf(machine);
  search.tryPoint(machine.zero());
  search.tryPoint(middle);
  const double step = machine.scale() / GRID;
  for (int i = -GRID; i <= GRID; ++i)
    for (int j = -GRID; j <= GRID; ++j)
      for (int k = -GRID; k <= GRID; ++k)
        search.tryPoint(middle + step * Vector3d(i, j, k));
  search.refine(step, 1e-4 * machine.scale());
  std::optional<FittingBounds> bounds = search.best();
  if (bounds)
  {
    // Rounding noise of a symmetric machine must show neither in a coordinate nor in a third digit.
    const double noise = 1e-9 * machine.scale();
    bounds->point = bounds->point.unaryExpr([noise](double x) { return std::abs(x) < noise ? 0.0 : x; });
    bounds->psi_max = *parseNumber(significantAbove(ROOM * spread(bounds->psi) * (1.0 - 1e-6), 2));
    bounds->psi_min = twoDigitsBelow(1.0 / bounds->psi_max);
  }
  return bounds;
}

FittingBounds chooseBounds(const Machine& machine, Criterion& criterion)
{
  const auto bounds = fittingBounds(machine, criterion);
  if (!bounds)
    throw std::invalid_argument(
        "no point of the machine was found for which bounds of the velocity transmission factors "
        "could be chosen: none keeps all other conditions, zones too; give the bounds");
  criterion.psi_min = bounds->psi_min;
  criterion.psi_max = bounds->psi_max;
  return *bounds;
}

std::string describe(const FittingBounds& bounds)
{
  TextStream text;
  text << "psi in [" << bounds.psi_min << ", " << bounds.psi_max << "]: about twice as wide as at the best point, "
       << placeOf(bounds.point) << ", where the factors are " << rangeOf(bounds.psi);
  return text.str();
}

std::string remarkOnDefaultBounds(const Machine& machine, const Criterion& criterion, const std::string& remedy)
{
  const Vector3d middle = middleOf(machine);
  Criterion anywhere = criterion;
  anywhere.joint_limits = false;
  const auto psi = factorsAt(machine, anywhere, middle);
  if (criterion.set != Criterion::Set::DEXTROUS || !psi ||
      ((*psi)[0] >= criterion.psi_min && (*psi)[2] <= criterion.psi_max))
    return "";
  const auto fitting = fittingBounds(machine, criterion);
  TextStream text;
  text << "the default bounds of psi, [" << criterion.psi_min << ", " << criterion.psi_max
       << "], suit the paper's machines; the middle of this one, " << placeOf(middle)
       << ", fails them: its factors are " << rangeOf(*psi) << " there";
  if (fitting)
    text << ". " << remedy << " asks for [" << fitting->psi_min << ", " << fitting->psi_max << "]";
  return text.str();
}
}  // namespace pkm_workspace
