// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/point_evaluation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/machine_model.h"
#include "pkm_workspace/interval/text_stream.h"

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

/// Takes in limits.
class Limits
{
public:
  explicit Limits(std::vector<Limit>& limits) : limits_(limits) {}

  void tell(const Limit& limit) { limits_.push_back(limit); }
  void atLeast(Kind kind, int leg, const Interval& value, double bound)
  {
    tell({ kind, leg, value, bound, value - Interval(bound) });
  }
  void atMost(Kind kind, int leg, const Interval& value, double bound)
  {
    tell({ kind, leg, value, bound, Interval(bound) - value });
  }

private:
  std::vector<Limit>& limits_;
};

/// A point, for the conditions of a criterion to tell their limits there.
class LimitsAt : public Limits
{
public:
  /// @param there of the point, where the result has values
  LimitsAt(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point,
           const std::optional<Configuration>& there, PointEvaluation& result)
    : Limits(result.limits)
    , machine_(machine)
    , criterion_(criterion)
    , place_(point)
    , point_(enclose(point))
    , there_(there)
    , result_(result)
  {}

  const Machine& machine() const { return machine_; }
  const Criterion& criterion() const { return criterion_; }
  const Eigen::Vector3d& place() const { return place_; }
  const IntervalVector& point() const { return point_; }
  /// @pre hasValues()
  const Configuration& configuration() const { return *there_; }
  bool hasValues() const { return result_.has_values; }
  const PointEvaluation& values() const { return result_; }

  template <class... Each>
  void askAll(const std::tuple<Each...>* /*conditions*/)
  {
    (Each::tellLimits(*this), ...);
    for (const CriterionBound& bound : CRITERION_BOUNDS)
      if (hasValues() && bound.enclose != nullptr && bound.isAskedBy(criterion_))
        bound.is_lower ? atLeast(bound.kind, -1, bound.enclose(result_), criterion_.*bound.value)
                       : atMost(bound.kind, -1, bound.enclose(result_), criterion_.*bound.value);
  }

private:
  const Machine& machine_;
  const Criterion& criterion_;
  Eigen::Vector3d place_;
  IntervalVector point_;
  const std::optional<Configuration>& there_;
  PointEvaluation& result_;
};

/// The margin without unit, in floating point.
double relativeMargin(const Limit& limit, double scale)
{
  const double margin = limit.margin.isBounded() ? limit.margin.mid() : -INF;
  switch (limit.kind)
  {
    case Kind::REACH:
    case Kind::JOINT_LOWER:
    case Kind::JOINT_UPPER:
    case Kind::HINGE_LOWER:
    case Kind::HINGE_UPPER:
    case Kind::KEEP_IN:
    case Kind::KEEP_OUT:
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
  Limits limits(found);
  JointLimits<double>::tellLimits(machine, rho, limits);
  return found;
}

std::string name(Limit::Kind kind)
{
  constexpr const char* NAMES[] = { "reach", "joint_lower", "joint_upper", "aspect" };
  if (isRate(kind))
    return kind == Kind::JOINT_SPEED ? "joint_speed_max" : "joint_acceleration_max";
  if (kind == Kind::HINGE_LOWER || kind == Kind::HINGE_UPPER)
    return kind == Kind::HINGE_LOWER ? "hinge_lower" : "hinge_upper";
  if (kind == Kind::KEEP_IN || kind == Kind::KEEP_OUT)
    return ZONE_USES[kind == Kind::KEEP_IN ? 0 : 1];
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
  : machine_(machine), criterion_(criterion), test_(machine, criterion), reach_test_(machine, reachOnly())
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
  const auto there = configurationAt(machine_, point);
  result.has_values = there && motion.joint[0].upper < INF;
  if (result.has_values)
    addValues(*there, motion, result);
  LimitsAt(machine_, test_.model().criterion(), point, there, result).askAll(static_cast<Conditions<double>*>(nullptr));
  return result;
}

void PointEvaluator::addValues(const Configuration& there, const PieceMotion& motion, PointEvaluation& result)
{
  const Interval not_negative(0.0, INF);
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.psi[i] = intersection(asInterval(motion.psi[i]), not_negative);
    result.rho[i] = intersection(asInterval(motion.joint[i]), there.rho[i]);
  }
  result.condition = intersection(result.psi[2] * inverse(result.psi[0]), Interval(1.0, INF));
  result.det_a = there.det_a;
}

PointEvaluation evaluatePoint(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& point)
{
  return PointEvaluator(machine, criterion)(point);
}
}  // namespace pkm_workspace
