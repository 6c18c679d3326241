// SPDX-License-Identifier: BSD-3-Clause
#include "common_options.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/dexterity/fitting_bounds.h"
#include "pkm_workspace/dexterity/joint_data.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Quantity quantityOf(const CriterionBound& bound)
{
  const bool is_positive = bound.least == LEAST_POSITIVE;
  const double most = bound.most < LARGEST_BOUND ? bound.most : std::numeric_limits<double>::infinity();
  return { bound.unit, is_positive ? 0.0 : bound.least, !is_positive, most };
}

Words namesOfCriterion()
{
  Words names = { "set", "aspect" };
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    names.push_back(optionOf(bound.name));
  for (const JointDatum& datum : JOINT_DATA)
    names.push_back(optionOf(datum.name));
  names.insert(names.end(), { "joint-limits", "hinge-limits", "keep-in", "keep-out", "zones", "tool-radius" });
  return names;
}
}  // namespace

void declareCriterion(Options& options, Criterion& criterion)
{
  criterion = defaultCriterion();
  options.choice("set", criterion.set, SET_NAMES,
                 "what is asked of every point: bounded velocity transmission factors, or the struts' reach only; with "
                 "all that is given below");
  options.choice("aspect", criterion.aspect, ASPECT_NAMES,
                 "sign of det A at the points that count: that of the machine's zero configuration, the other, or any");
  for (const CriterionBound& bound : CRITERION_BOUNDS)
    options.number(optionOf(bound.name), criterion.*bound.value, quantityOf(bound), bound.help);
  declareJointData(options, criterion, [](const JointDatum&) { return true; });
  requireEffect(options, criterion);
  options.onOff("joint-limits", criterion.joint_limits, "whether the URDF's limits of the driven joints hold too");
  options.onOff("hinge-limits", criterion.hinge_limits, "whether the URDF's limits of passive joints hold too");
  declareZones(options, criterion);
  Words of_dextrous = { "set" }, all = { "keep-in", "keep-out", "zones", "tool-radius" };
  for (const CriterionBound& bound : CRITERION_BOUNDS)
  {
    all.push_back(optionOf(bound.name));
    if (!bound.is_optional)
      of_dextrous.push_back(all.back());
  }
  options.check(of_dextrous, [&criterion, &options, of_dextrous](Problems& problems) {
    const auto is_given = [&](const std::string& name) { return options.given(name); };
    if (criterion.set == Criterion::Set::REACHABLE && std::any_of(of_dextrous.begin() + 1, of_dextrous.end(), is_given))
      problems.push_back("a reachable set has no bounds of velocity transmission factors: leave them out");
  });
  options.check(all, [&criterion, &options](Problems& problems) {
    const auto origin = [&](const std::string& name) { return options.given(optionOf(name)) ? "" : "the default"; };
    validateCriterion(criterion, origin, problems);
  });
}

void declareCriterion(Options& options, Criterion& criterion, MachineOptions& machine,
                      const std::function<bool()>& counts)
{
  declareCriterion(options, criterion);
  options.words(
      "psi", "auto",
      "in place of --psi-min and --psi-max: bounds [1/f, f], f twice as much as at the best point of the machine",
      [](const Words& words) { readChoice(words[0], { "auto" }); });
  machine.declareCollisions(options);
  Words names = criterionOptions();
  names.insert(names.end(), { "urdf", "rails", "tcp-links", "tool-link", "tool", "ball-axes" });
  options.check(names, [&criterion, &machine](Problems& problems) {
    criterion = withJointData(machine.machine(), criterion);
    machine.addCollisions(criterion, problems);
    requireProvable(machine.machine(), criterion, problems);
  });
  names.insert(names.end(), { "psi" });
  options.check(names, [&criterion, &options, &machine, counts](Problems& problems) {
    const bool is_given = options.given("psi-min") || options.given("psi-max");
    if (options.given("psi") && (is_given || criterion.set == Criterion::Set::REACHABLE))
      problems.push_back(
          "--psi auto chooses the bounds of a dextrous set: leave out --psi-min, --psi-max and --set "
          "reachable");
    else if (options.given("psi"))
      try
      {
        machine.note(describe(chooseBounds(machine.machine(), criterion)));
      }
      catch (const std::invalid_argument& reason)
      {
        problems.push_back(reason.what());
      }
    else if (!is_given && counts())
    {
      const std::string remark = remarkOnDefaultBounds(machine.machine(), criterion, "--psi auto");
      if (!remark.empty())
        machine.remark(remark);
    }
  });
}

const Words& criterionOptions()
{
  static const Words all = namesOfCriterion();
  return all;
}

void AccuracyOption::declare(Options& options, const std::string& help)
{
  options.number("accuracy", accuracy_, LENGTH_POSITIVE,
                 help + "; without it, a thousandth of the longest strut, to one digit");
}

void declareTimeLimit(Options& options, double& time_limit)
{
  time_limit = TIME_LIMIT;
  options.number("time-limit", time_limit, TIME_NOT_NEGATIVE, "ends with the best proved so far; 0: no limit");
}

void declareBudget(Options& options, Budget& budget)
{
  constexpr std::int64_t MOST_BYTES = std::int64_t(1) << 50;
  budget.max_memory = DEFAULT_MEMORY;
  declareTimeLimit(options, budget.time_limit);
  options.count("max-boxes", budget.max_boxes, MOST_BOXES,
                "boxes looked at before it ends with the best proved so far; without it, no limit");
  options.count("max-memory", budget.max_memory, MOST_BYTES,
                "bytes that boxes may take before it ends with the best proved so far");
  options.check({ "max-memory" }, [&budget](Problems& problems) {
    if (budget.max_memory < Budget::LEAST_MEMORY)
      problems.push_back("must be at least " + std::to_string(Budget::LEAST_MEMORY) + " bytes");
  });
  options.count("threads", budget.threads, 1024, "threads that compute; no answer depends on it");
}

void declareOutput(Options& options, const std::string& name, std::string& path, const std::string& help)
{
  options.text(name, path, "FILE", help);
  options.check({ name }, [&path](Problems& problems) {
    try
    {
      if (!path.empty())
        checkWholeFile(path);
    }
    catch (const std::invalid_argument& reason)
    {
      problems.push_back(std::string(reason.what()).substr(path.size() + 2));  // the option's words name the file
    }
  });
}
}  // namespace cli
}  // namespace pkm_workspace
