// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "violations.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// The machine at one tool point: verdicts that are proved, and values in floating point.
struct PointState
{
  BoxVerdict reachable = BoxVerdict::UNDECIDED;
  BoxVerdict dextrous = BoxVerdict::UNDECIDED;
  BoxVerdict aspect_ok = BoxVerdict::UNDECIDED;  ///< whether det A has the sign of the machine's aspect
  std::optional<Eigen::Vector3d> rho;            ///< joint values [m]
  std::optional<Jacobians> jacobian;
};

BoxVerdict ownAspect(const Machine& machine, const Eigen::Vector3d& p)
{
  const auto configuration = configurationAt(machine, p);
  if (!configuration || configuration->det_a.contains(0.0))
    return BoxVerdict::UNDECIDED;
  const int sign = configuration->det_a.certainlyPositive() ? 1 : -1;
  return sign == machine.aspect() ? BoxVerdict::INSIDE : BoxVerdict::OUTSIDE;
}

PointState stateAt(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p)
{
  Criterion reach;
  reach.set = Criterion::Set::REACHABLE;
  reach.aspect = Criterion::Aspect::BOTH;
  PointState state;
  state.reachable = BoxTest(machine, reach).classify(p);
  state.dextrous = BoxTest(machine, criterion).classify(p);
  if (state.reachable == BoxVerdict::OUTSIDE)
    return state;
  state.aspect_ok = ownAspect(machine, p);
  state.rho = inverseKinematics(machine, p);
  state.jacobian = jacobians(machine, p);
  return state;
}

std::string message(const Machine& machine, const Criterion& criterion, const PointState& state,
                    const Eigen::Vector3d& p)
{
  if (state.dextrous == BoxVerdict::INSIDE)
    return "The point is dextrous.";
  if (state.dextrous == BoxVerdict::UNDECIDED)
    return "Whether the point is dextrous is not decided: it is within rounding of the border.";
  const Words found = violations(machine, criterion, p);
  return "The point is not dextrous: " +
         (found.empty() ? "it misses a bound by less than the rounding of doubles" : joined(found, "; ")) + ".";
}

Json numbersOf(const Machine& machine, const PointState& state)
{
  Json json = { { "psi", Json() },
                { "rho", Json() },
                { "condition", Json() },
                { "det_a", Json() },
                { "serial_singularity", Json() },
                { "parallel_singularity", Json() } };
  if (state.rho)
    json["rho"] = toJson(*state.rho);
  if (!state.jacobian)
    return json;
  const Eigen::Vector3d psi = transmissionFactors(*state.jacobian);
  const SingularityMeasures measures = singularityMeasures(machine, *state.jacobian);
  json["psi"] = toJson(psi);
  json["condition"] = psi[2] / psi[0];
  json["det_a"] = state.jacobian->a.determinant();
  json["serial_singularity"] = measures.serial;
  json["parallel_singularity"] = measures.parallel;
  return json;
}

/// A boolean, a number or a list of numbers, for people.
std::string text(const Json& value, const std::string& unit)
{
  if (value.is_boolean())
    return (value.get<bool>() ? "yes" : "no") + unit;
  if (value.is_number())
    return nearly(value) + unit;
  Words words;
  for (const Json& entry : value)
    words.push_back(text(entry, unit));
  return joined(words, "  ");
}

std::string verdictText(const Json& value)
{
  return value.is_null() ? "undecided" : text(value, " (proved)");
}

class Evaluate : public Command
{
public:
  std::string description() const override
  {
    return "Tells how the machine stands at one tool point: joint values, velocity transmission factors psi "
           "(singular values of J^-1), condition number of J, nearness to singularities, and whether the "
           "point is dextrous. The verdicts are proved; the other numbers are in floating point.";
  }

  Words examples() const override { return { "pkm evaluate --urdf orthoglide.urdf --point -0.1 0 0.2" }; }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("point", point_, "X Y Z", LENGTH, "tool point, in the frame of the root link");
    options.require({ "point" });
    declareCriterion(options, criterion_);
  }

  Words warnings() const override { return machine_.warnings(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    const PointState state = stateAt(machine, criterion_, *point_);
    Json json = contextOf(machine, criterion_);
    json.update(numbersOf(machine, state));
    json["point"] = toJson(*point_);
    json["reachable"] = toJson(state.reachable);
    json["dextrous"] = toJson(state.dextrous);
    json["aspect_ok"] = state.reachable == BoxVerdict::OUTSIDE ? Json() : toJson(state.aspect_ok);
    json["joints"] = Json::array();
    for (const Leg& leg : machine.legs())
      json["joints"].push_back(leg.joint);
    json["message"] = message(machine, criterion_, state, *point_);
    return { json, print(json) };
  }

private:
  std::string print(const Json& json) const
  {
    std::vector<Words> rows = { { "reachable", verdictText(json["reachable"]) },
                                { "dextrous", verdictText(json["dextrous"]) } };
    const auto add = [&](const char* label, const char* key, const std::string& unit) {
      if (!json[key].is_null())
        rows.push_back({ label, text(json[key], unit) });
    };
    add("own aspect", "aspect_ok", " (proved)");
    add("psi", "psi", "");
    add("condition of J", "condition", "");
    add("rho", "rho", " m");
    add("serial", "serial_singularity", "   (least |eta| / L; 0 at a serial singularity)");
    add("parallel", "parallel_singularity", "   (|det A| / (L1 L2 L3); 0 at a parallel singularity)");
    add("det A", "det_a", " m^3");
    return "Machine '" + machine_.machine().name() + "' at the tool point " + describe(*point_) + "\n\n" +
           aligned(rows, Align::LEFT) + "\n" + wrapped(json["message"]) + wrapped(definition(criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  std::optional<Eigen::Vector3d> point_;
};
}  // namespace

std::unique_ptr<Command> makeEvaluate()
{
  return std::make_unique<Evaluate>();
}
}  // namespace cli
}  // namespace pkm_workspace
