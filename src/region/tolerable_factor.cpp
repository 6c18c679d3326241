// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/tolerable_factor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/machine/tolerated_strut.h"

namespace pkm_workspace
{
namespace
{
/// Factors that are tried: beyond the last one tolerances say nothing.
constexpr double LEAST_FACTOR = 1e-9;
constexpr double MOST_FACTOR = 1e9;
/// Shares below this do not matter.
constexpr double SHARE_THAT_MATTERS = 1e-3;
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
      const ContainmentResult found = checkContainment(BoxTest(machine, query_.criterion), *query_.solid.shape,
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

/// What each kind of each leg takes: the parameters of c belong to both ends of the strut.
std::vector<ToleranceShare> sharesOf(const WorstMachine& worst, const Machine& machine)
{
  std::vector<ToleranceShare> shares;
  double all = 0.0;
  for (const double loss : worst.loss)
    all += loss;
  const auto add = [&](const char* name, int leg, double loss) {
    if (all > 0.0 && loss > SHARE_THAT_MATTERS * all)
      shares.push_back({ toleranceKind(name), leg, loss / all });
  };
  for (int i = 0; i < 3; ++i)
  {
    const StrutTolerance& by = slidingStrut(machine.leg(i)).tolerance;
    const double* const loss = worst.loss.data() + static_cast<std::size_t>(i) * STRUT_PARAMETERS;
    const ParameterSet set = spreadOf(slidingStrut(machine.leg(i))).set;
    double part[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double parameter = std::abs(worst.parameter[static_cast<std::size_t>(i) * STRUT_PARAMETERS + k]);
      const double of_box = parameter > 0.0 ? std::min(set.box[k] / parameter, 1.0) : 0.0;
      const double boxes = by.slider[k] + by.platform[k], balls = by.slider_ball + by.platform_ball;
      part[0] += boxes > 0.0 ? loss[k] * of_box * by.slider[k] / boxes : 0.0;
      part[1] += balls > 0.0 ? loss[k] * (1.0 - of_box) * by.slider_ball / balls : 0.0;
      part[2] += boxes > 0.0 ? loss[k] * of_box * by.platform[k] / boxes : 0.0;
      part[3] += balls > 0.0 ? loss[k] * (1.0 - of_box) * by.platform_ball / balls : 0.0;
    }
    const char* const ends[4] = { "tolerance_slider", "tolerance_slider_ball", "tolerance_platform",
                                  "tolerance_platform_ball" };
    for (std::size_t n = 0; n < 4; ++n)
      add(ends[n], i, part[n]);
    add("tolerance_zero", i, loss[3]);
    add("tolerance_direction", i, std::hypot(loss[4], loss[5]));
    add("tolerance_length", i, loss[6]);
  }
  std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return shares;
}

/// Names the machine that is bad at the bad point, if one machine alone is proved to be.
void nameBadMachine(const Machine& machine, const FactorQuery& query, TolerableFactor& report)
{
  const Machine all = withTolerances(machine, scaled(tolerancesOf(machine), report.fails));
  const WorstMachine worst = BoxTest(all, query.criterion).kernel().worst(*report.bad_point);
  report.shares = sharesOf(worst, all);
  try
  {
    const Machine built = builtWith(all, worst.parameter);
    const PointEvaluation there = PointEvaluator(built, query.criterion)(*report.bad_point);
    if (there.verdict != BoxVerdict::OUTSIDE)
      return;
    report.bad_machine = built;
    report.bad_limit = there.binding();
  }
  catch (const std::invalid_argument&)
  {
    return;  // it is singular at zero, and not to be named
  }
}
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
    nameBadMachine(machine, query, report);
  return report;
}
}  // namespace pkm_workspace
