// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/tolerable_factor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/region/bad_machine.h"

namespace pkm_workspace
{
namespace
{
/// Factors that are tried: beyond the last one tolerances say nothing.
constexpr double LEAST_FACTOR = 1e-9;
constexpr double MOST_FACTOR = 1e9;
/// How often the gap below the factor with which some are no machines is halved.
constexpr int REFUSED_STEPS = 10;

/// The factor by which the largest angle is as large as is allowed, or the most that is tried.
double mostFactor(const Tolerances& tolerances)
{
  double most = MOST_FACTOR;
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    for (StrutTolerance leg : tolerances)
      for (std::size_t k = 0; k < (kind.is_per_axis ? 3U : 1U); ++k)
        if (const double value = kind.values(leg)[k]; value > 0.0)
          most = std::min(most, kind.most / value);
  return most;
}

/// Looks for the factor that is the border, from both sides.
class FactorSearch
{
public:
  FactorSearch(const Machine& machine, const FactorQuery& query)
    : machine_(machine), query_(query), tolerances_(tolerancesOf(machine)), running_(query.budget)
  {}

  TolerableFactor run()
  {
    const double most = mostFactor(tolerances_);
    if (attempt(0.0) != Containment::INSIDE)
      found_.fails = found_.bad_point ? 0.0 : INF;
    else
      bracket(most);
    found_.is_closed = areClose(found_.holds, found_.fails);
    found_.seconds = running_.seconds();
    return found_;
  }

private:
  Containment attempt(double factor)
  {
    try
    {
      const Machine machine = withTolerances(machine_, scaled(tolerances_, factor));
      accepted_ = std::max(accepted_, factor);
      Budget budget = running_.rest();
      budget.max_boxes =
          query_.budget.max_boxes > 0 ? std::max<std::int64_t>(query_.budget.max_boxes - found_.boxes, 1) : 0;
      const ContainmentResult found = checkContainment(BoxTest(machine, criterionFor(machine)), *query_.solid.shape,
                                                       query_.center, query_.solid.size, budget);
      found_.boxes += found.boxes;
      if (found.verdict == Containment::INSIDE)
        found_.holds = std::max(found_.holds, factor);
      if (found.verdict == Containment::OUTSIDE && factor < found_.fails)
      {
        found_.fails = factor;
        found_.bad_point = found.bad_point;
      }
      if (query_.tell)
        query_.tell(found_.holds, found_.fails);
      return found.verdict;
    }
    catch (const std::invalid_argument&)
    {
      refused_ = std::min(refused_, factor);  // one of them is no machine
      return Containment::UNDECIDED;
    }
  }

  /// A machine without tolerances, and with joints that are exact, has no errors of position.
  Criterion criterionFor(const Machine& machine) const
  {
    Criterion criterion = query_.criterion;
    const JointValues& errors = criterion.joint_error_max;
    if (!machine.hasTolerances() && std::find(errors.begin(), errors.end(), 0.0) != errors.end())
      criterion.position_error_max = 0.0;
    return criterion;
  }

  bool isOver() const { return running_.isOver(found_.boxes); }

  /// From 1 by powers of 4 to a factor that is proved good, one that is not, and one that is proved bad; then both
  /// borders by halving. Between them neither is proved.
  void bracket(double most)
  {
    double least_open = INF, most_open = 0.0, factor = std::min(1.0, most);
    const auto note = [&](Containment verdict) {
      if (verdict != Containment::INSIDE)
        least_open = std::min(least_open, factor);
      if (verdict != Containment::OUTSIDE && factor < refused_)
        most_open = std::max(most_open, factor);
      return verdict;
    };
    for (; note(attempt(factor)) != Containment::INSIDE && factor > LEAST_FACTOR && !isOver(); factor /= 4.0)
      continue;
    for (factor = std::min(1.0, most); found_.fails == INF && factor < most && !isOver();)
    {
      factor = std::min(4.0 * factor, most);
      note(attempt(factor));
    }
    // beyond some factor there are machines without a zero configuration: the largest below it is what tells most
    for (int step = 0; step < REFUSED_STEPS && found_.fails == INF && refused_ < INF && !isOver(); ++step)
    {
      factor = std::sqrt(std::max(accepted_, LEAST_FACTOR) * refused_);
      note(attempt(factor));
    }
    while (found_.holds > 0.0 && least_open < INF && !isOver() && !areClose(found_.holds, least_open))
    {
      factor = std::sqrt(found_.holds * least_open);
      note(attempt(factor));
    }
    while (found_.fails < INF && most_open > 0.0 && !isOver() && !areClose(most_open, found_.fails))
    {
      factor = std::sqrt(most_open * found_.fails);
      note(attempt(factor));
    }
  }

  bool areClose(double lower, double upper) const { return upper <= lower * (1.0 + query_.accuracy); }

  const Machine& machine_;
  const FactorQuery& query_;
  const Tolerances tolerances_;
  const RunningBudget running_;
  TolerableFactor found_;
  double accepted_ = 0.0;  ///< the largest factor within which all are machines
  double refused_ = INF;   ///< the least with which some are not
};

}  // namespace

Tolerances scaled(Tolerances tolerances, double factor)
{
  for (StrutTolerance& leg : tolerances)
    for (const ToleranceKind& kind : TOLERANCE_KINDS)
      for (std::size_t k = 0; k < (kind.is_per_axis ? 3U : 1U); ++k)
        kind.values(leg)[k] = std::min(kind.values(leg)[k] * factor, kind.most);
  return tolerances;
}

TolerableFactor tolerableFactor(const Machine& machine, const FactorQuery& query)
{
  Problems problems;
  if (!machine.hasTolerances())
    complain(problems, "the machine has no tolerances to be scaled: give one at least, such as tolerance_length");
  query.budget.validate(problems);
  throwProblems(problems);
  TolerableFactor report = FactorSearch(machine, query).run();
  if (report.bad_point && report.fails > 0.0)
  {
    const BadMachine bad = badMachineAt(withTolerances(machine, scaled(tolerancesOf(machine), report.fails)),
                                        query.criterion, *report.bad_point);
    report.bad_machine = bad.machine;
    report.bad_limit = bad.limit;
    report.shares = bad.shares;
  }
  return report;
}
}  // namespace pkm_workspace
