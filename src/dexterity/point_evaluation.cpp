// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/point_evaluation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/machine/leg_forms.h"

namespace pkm_workspace
{
namespace
{
using Kind = Limit::Kind;

Criterion reachOnly()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  return criterion;
}

Interval asInterval(const Span<double>& span)
{
  return { span.lower, span.upper };
}

Limit atLeast(Kind kind, int leg, const Interval& value, double bound)
{
  return { kind, leg, value, bound, value - Interval(bound) };
}

Limit atMost(Kind kind, int leg, const Interval& value, double bound)
{
  return { kind, leg, value, bound, Interval(bound) - value };
}

/// The margin without unit, in floating point.
double relativeMargin(const Limit& limit, double scale)
{
  const double margin = limit.margin.isBounded() ? limit.margin.mid() : -INF;
  switch (limit.kind)
  {
    case Kind::REACH:
    case Kind::JOINT_LOWER:
    case Kind::JOINT_UPPER:
      return margin / scale;
    case Kind::ASPECT:
      return margin;
    default:
      return limit.value.isBounded() ? margin / std::max(limit.value.mid(), limit.bound) : margin;
  }
}
}  // namespace

std::vector<Limit> jointLimits(const Machine& machine, const std::array<Interval, 3>& rho)
{
  std::vector<Limit> found;
  for (int i = 0; i < 3; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    const Interval& value = rho[static_cast<std::size_t>(i)];
    if (limits.lower() > -INF)
      found.push_back(atLeast(Kind::JOINT_LOWER, i, value, limits.lower()));
    if (limits.upper() < INF)
      found.push_back(atMost(Kind::JOINT_UPPER, i, value, limits.upper()));
  }
  return found;
}

std::string name(Limit::Kind kind)
{
  constexpr const char* NAMES[] = { "reach", "joint_lower", "joint_upper", "aspect" };
  const CriterionBound* const bound = boundOf(kind);
  return bound == nullptr ? NAMES[static_cast<int>(kind)] : bound->name;
}

const Limit& PointEvaluation::binding() const
{
  return *std::min_element(limits.begin(), limits.end(), [this](const Limit& a, const Limit& b) {
    return relativeMargin(a, scale) < relativeMargin(b, scale);
  });
}

PointEvaluator::PointEvaluator(const Machine& machine, const Criterion& criterion)
  : machine_(machine), test_(machine, criterion), reach_test_(machine, reachOnly())
{}

PointEvaluation PointEvaluator::operator()(const Eigen::Vector3d& point) const
{
  if (!point.allFinite())
  {
    TextStream text;
    text << "the point (" << point.x() << ", " << point.y() << ", " << point.z() << ") m must be finite";
    throw std::invalid_argument(text.str());
  }
  PointEvaluation result;
  result.scale = machine_.scale();
  result.verdict = test_.classify(point);
  CurvePiece piece{};
  piece.points.center = { point.x(), point.y(), point.z() };
  PieceMotion motion;
  reach_test_.kernel().look(&piece, 1, &result.within_reach, &motion);
  addReach(point, result);
  const auto there = configurationAt(machine_, point);
  result.has_values = there && motion.joint[0].upper < INF;
  if (result.has_values)
    addValues(*there, motion, result);
  return result;
}

void PointEvaluator::addReach(const Eigen::Vector3d& point, PointEvaluation& result) const
{
  for (int i = 0; i < 3; ++i)
  {
    const LegReach reach = reachAt(machine_.enclosed(i), enclose(point));
    result.limits.push_back({ Kind::REACH, i, reach.value, reach.most.mid(), reach.most - reach.value });
  }
}

void PointEvaluator::addValues(const Configuration& there, const PieceMotion& motion, PointEvaluation& result) const
{
  const Criterion& criterion = test_.model().criterion();
  const Interval not_negative(0.0, INF);
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.psi[i] = intersection(asInterval(motion.psi[i]), not_negative);
    result.rho[i] = intersection(asInterval(motion.joint[i]), there.rho[i]);
  }
  if (criterion.joint_limits)
    for (const Limit& limit : jointLimits(machine_, result.rho))
      result.limits.push_back(limit);
  result.condition = intersection(result.psi[2] * inverse(result.psi[0]), Interval(1.0, INF));
  result.det_a = there.det_a;
  if (const int sign = criterion.wantedSign(machine_.aspect()))
  {
    Interval volume = 1.0;
    for (int i = 0; i < 3; ++i)
      volume *= sqrtAboveZero(squaredRow(machine_.enclosed(i)));
    const Interval value = Interval(sign) * there.det_a / volume;
    result.limits.push_back(atLeast(Kind::ASPECT, -1, value, 0.0));
  }
  addFactors(result);
}

void PointEvaluator::addFactors(PointEvaluation& result) const
{
  const Criterion& criterion = test_.model().criterion();
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.isAskedBy(criterion))
    {
      const auto limit = bound.is_lower ? atLeast : atMost;
      result.limits.push_back(limit(bound.kind, -1, bound.enclose(result), criterion.*bound.value));
    }
}

PointEvaluation evaluatePoint(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point)
{
  return PointEvaluator(machine, criterion)(point);
}
}  // namespace pkm_workspace
