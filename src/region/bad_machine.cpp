// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/bad_machine.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pkm_workspace/dexterity/built_error.h"
#include "pkm_workspace/machine/tolerated_strut.h"

namespace pkm_workspace
{
namespace
{
/// Shares below this do not matter.
constexpr double SHARE_THAT_MATTERS = 1e-3;

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

/// What the machine whose tool is farthest off breaks, where the least that it may be off by is more than is allowed.
std::optional<Limit> brokenError(const Machine& all, const Criterion& criterion, const Eigen::Vector3d& point)
{
  for (const Limit& limit : evaluatePoint(all, criterion, point).limits)
    if (limit.kind == ConditionKind::POSITION_ERROR_MAX && limit.value.lower() > limit.bound)
      return limit;
  return std::nullopt;
}

/// What this machine breaks, if it is proved to be bad.
std::optional<Limit> brokenBy(const Machine& built, const Criterion& criterion, const Eigen::Vector3d& point)
{
  const PointEvaluation there = evaluatePoint(built, criterion, point);
  return there.verdict == BoxVerdict::OUTSIDE ? std::optional<Limit>(there.binding()) : std::nullopt;
}
}  // namespace

BadMachine badMachineAt(const Machine& all, const Criterion& criterion, const Eigen::Vector3d& point)
{
  WorstMachine worst = BoxTest(all, criterion).kernel().worst(point);
  const bool errs = worst.subject.kind == ConditionKind::POSITION_ERROR_MAX;
  if (errs)
    worst = worstOfBuilt(all, criterion, point).value_or(worst);
  BadMachine bad;
  bad.shares = sharesOf(worst, all);
  try
  {
    const Machine built = builtWith(all, worst.parameter);
    bad.limit = errs ? brokenError(all, criterion, point) : brokenBy(built, criterion, point);
    if (bad.limit)
      bad.machine = built;
  }
  catch (const std::invalid_argument&)
  {
    bad.limit.reset();  // it is singular at zero, and not to be named
  }
  return bad;
}
}  // namespace pkm_workspace
