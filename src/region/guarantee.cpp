// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/guarantee.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/joint_data.h"

namespace pkm_workspace
{
namespace
{
constexpr int MOST_TRIALS = 200;
constexpr std::int64_t MOST_BOXES = 200000;  ///< of one trial

/// Reach and aspect, and what is known of the joints that is no bound.
Criterion reachedOnly(const Criterion& criterion)
{
  Criterion reached = criterion;
  reached.set = Criterion::Set::REACHABLE;
  reached.joint_limits = reached.hinge_limits = false;
  reached.zones.clear();
  reached.tool_radius = 0.0;
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    if (bound.is_optional)
      reached.*bound.value = 0.0;
  for (const JointDatum& datum : JOINT_DATA)
    if (datum.isBound())
      reached.*datum.values = JointValues{};
  return reached;
}

/// The same with a value of one bound.
Criterion asking(const Machine& machine, const Criterion& reached, const CriterionBound& bound, double value)
{
  Criterion criterion = reached;
  criterion.*bound.value = value;
  return withJointData(machine, criterion);
}

/// A value of the bound that every point keeps.
double anyValue(const CriterionBound& bound)
{
  return bound.is_lower ? bound.least : bound.most;
}

/// Narrows the bracket of one bound over one region.
class GuaranteeSearch
{
public:
  GuaranteeSearch(const Machine& machine, const GuaranteeQuery& query, const CriterionBound& bound, const Shape& shape,
                  const Eigen::Vector3d& center, double size)
    : machine_(machine)
    , query_(query)
    , bound_(bound)
    , shape_(shape)
    , center_(center)
    , size_(size)
    , reached_(reachedOnly(query.criterion))
    , values_(machine, asking(machine, reached_, bound, anyValue(bound)))
    , budget_(query.budget)
  {
    result_.bound = &bound;
    result_.counting = jointDataInWords(values_.test().model().criterion(), bound.value);
    proved_ = bound.is_lower ? 0.0 : INF;
    seen_ = doubtful_ = bound.is_lower ? INF : 0.0;
  }

  Guarantee run()
  {
    const ContainmentResult reach = check(reached_);
    result_.is_reached = reach.verdict == Containment::INSIDE;
    if (reach.verdict == Containment::OUTSIDE)
    {
      result_.place = reach.bad_point.value_or(center_);
      result_.limit = evaluatePoint(machine_, reached_, result_.place).binding();
      seen_ = 0.0;  // of a bound from below nothing is left, of one from above nothing is known
    }
    if (reach.verdict == Containment::INSIDE)
      narrow();
    result_.value =
        bound_.is_lower ? Interval(proved_, std::max(proved_, seen_)) : Interval(std::min(seen_, proved_), proved_);
    result_.complete = isMet() || reach.verdict == Containment::OUTSIDE;
    result_.seconds = budget_.seconds();
    return result_;
  }

private:
  ContainmentResult check(const Criterion& criterion)
  {
    Budget budget = budget_.rest(result_.boxes);
    budget.max_boxes = budget.max_boxes > 0 ? std::min(budget.max_boxes, MOST_BOXES) : MOST_BOXES;
    const ContainmentResult found = checkContainment(BoxTest(machine_, criterion), shape_, center_, size_, budget);
    result_.boxes += found.boxes;
    return found;
  }

  void narrow()
  {
    see(center_);
    for (const GrowingVector& point : shape_.extremePoints())
      if (const auto inside = nearestInside(shape_, center_ + point.at(size_), center_, size_))
        see(*inside);
    double step = 0.5 * query_.accuracy;
    for (int trial = 0; trial < MOST_TRIALS && !isSettled() && !budget_.isOver(result_.boxes); ++trial)
    {
      const double wanted = candidate(trial, step);
      const double value = std::clamp(wanted, bound_.least, bound_.most);
      if (!std::isfinite(wanted) || (value != wanted && value == last_end_))
        return;
      last_end_ = value != wanted ? value : last_end_;
      const ContainmentResult found = check(asking(machine_, reached_, bound_, value));
      if (found.verdict == Containment::INSIDE)
        proved_ = value;
      else if (found.verdict == Containment::UNDECIDED || !refute(value, found))
        doubtful_ = value;
      step = found.verdict == Containment::INSIDE ? 0.5 * query_.accuracy : std::min(0.9, 4.0 * step);
    }
  }

  /// Near to what no point allows to pass, or, every other time, half the way there.
  double candidate(int trial, double step) const
  {
    const double near = bound_.is_lower ? end() * (1.0 - step) : end() * (1.0 + step);
    const bool has_proof = bound_.is_lower ? proved_ > 0.0 : proved_ < INF;
    const bool is_between = bound_.is_lower ? near > proved_ : near < proved_;
    return has_proof && (trial % 2 == 1 || !is_between) ? 0.5 * (proved_ + end()) : near;
  }

  /// The value is not kept at the bad point: nor is a better one than that of the point.
  /// @return false where the point is only near
  bool refute(double value, const ContainmentResult& found)
  {
    if (!found.bad_point || found.bad_within > 0.0)
      return false;
    if (lower(value))
    {
      result_.place = *found.bad_point;
      result_.limit = evaluatePoint(machine_, asking(machine_, reached_, bound_, value), result_.place).binding();
    }
    see(*found.bad_point);
    return true;
  }

  void see(const Eigen::Vector3d& point)
  {
    const PointEvaluation there = values_(point);
    for (const Limit& limit : there.limits)
      if (limit.kind == bound_.kind && limit.value.isBounded() &&
          lower(bound_.is_lower ? limit.value.upper() : limit.value.lower()))
      {
        result_.place = point;
        result_.limit = limit;
      }
  }

  /// @return whether it is worse than all that was seen
  bool lower(double value)
  {
    const bool is_worse = bound_.is_lower ? value < seen_ : value > seen_;
    if (is_worse)
      seen_ = value;
    return is_worse;
  }

  /// What is not proved of every point, nor to be broken by one, begins here.
  double end() const { return bound_.is_lower ? std::min(seen_, doubtful_) : std::max(seen_, doubtful_); }

  bool isNear(double value) const
  {
    return std::isfinite(value) && std::isfinite(proved_) &&
           std::abs(value - proved_) <= query_.accuracy * std::abs(value);
  }
  bool isMet() const { return isNear(seen_); }
  /// Whether another trial could tell more.
  bool isSettled() const { return isNear(end()); }

  const Machine& machine_;
  const GuaranteeQuery& query_;
  const CriterionBound& bound_;
  const Shape& shape_;
  const Eigen::Vector3d& center_;
  double size_;
  Criterion reached_;
  PointEvaluator values_;
  RunningBudget budget_;
  double proved_;          ///< for every point
  double seen_;            ///< at the worst point
  double doubtful_;        ///< the value nearest to the proved one of which nothing could be told
  double last_end_ = 0.0;  ///< of the values that may be asked for, the one that was tried
  Guarantee result_;
};
}  // namespace

void GuaranteeQuery::validate(Problems& problems) const
{
  if (!(accuracy >= 1e-12 && accuracy <= 1.0))
    complain(problems, "accuracy = ", accuracy, " (relative, without unit) must be from 1e-12 to 1");
  validateJointData(criterion, problems);
  budget.validate(problems);
}

bool canBeGuaranteed(const Machine& machine, const Criterion& criterion, const CriterionBound& bound, Problems& missing)
{
  if (!bound.is_optional)
  {
    complain(missing, bound.name, " is not asked for by itself: ask for the force factors, which are 1 / psi");
    return false;
  }
  const std::size_t before = missing.size();
  requireProvable(machine, asking(machine, reachedOnly(criterion), bound, anyValue(bound)), missing);
  return missing.size() == before;
}

Guarantee guaranteed(const Machine& machine, const GuaranteeQuery& query, const CriterionBound& bound,
                     const Shape& shape, const Eigen::Vector3d& center, double size)
{
  Problems problems;
  query.validate(problems);
  canBeGuaranteed(machine, query.criterion, bound, problems);
  throwProblems(problems);
  return GuaranteeSearch(machine, query, bound, shape, center, size).run();
}
}  // namespace pkm_workspace
