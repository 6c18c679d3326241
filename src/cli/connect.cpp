// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/tasks/connection.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
std::string nameOf(ConnectionReport::Verdict verdict)
{
  constexpr const char* NAMES[] = { "connected", "apart", "outside", "open" };
  return NAMES[static_cast<std::size_t>(verdict)];
}

/// How far joints are moved into limits at which the zero configuration stands, over the longest strut: rounding has it
/// on either side of them.
constexpr double INTO_LIMITS = 1e-9;

/// The zero configuration, with its joints within their limits if they are nearly.
Eigen::Vector3d startOf(const Machine& machine, const Criterion& criterion)
{
  const double step = INTO_LIMITS * machine.scale();
  Eigen::Vector3d joints = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3 && criterion.joint_limits; ++i)
  {
    const Interval& limits = machine.leg(i).limits;
    if (std::abs(limits.lower()) <= step)
      joints[i] = step;
    else if (std::abs(limits.upper()) <= step)
      joints[i] = -step;
  }
  return joints.isZero(0.0) ? machine.zero() : forwardKinematics(machine, joints).value_or(machine.zero());
}

class Connect : public Command
{
public:
  std::string description() const override
  {
    return "Whether the tool can get from one point to another one without leaving the dextrous or the reachable set. "
           "connected: a path of straight lines is given, and every point of it is proved to be in the set. apart: "
           "proved that no path in the set joins the points. outside: one of them is proved not to be in the set. "
           "open: not decided, at the finest resolution or when a limit ended it. Without --from it starts at the zero "
           "configuration, or within a millionth of a strut from it where that is what keeps joints within limits that "
           "begin there. With --json: verdict, path (a list of points [m], or null), resolution [m], boxes, seconds.";
  }

  Words examples() const override
  {
    return { "pkm connect --urdf orthoglide.urdf --to 0.3 0.2 -0.1",
             "pkm connect --urdf orthoglide.urdf --from 0.2 0.2 0.2 --to 0.3 0.2 -0.1 --resolution 0.02" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("from", from_, "X Y Z", LENGTH, "tool point to start at; without it, the zero configuration's");
    options.vector("to", to_, "X Y Z", LENGTH, "tool point to get to");
    options.number("resolution", task_.resolution, LENGTH_POSITIVE,
                   "the finest boxes that are tried; without it, a thirty-second part of what pkm pave takes");
    options.box("box", task_.query.box, "what the path may not leave; without it, no bound but the set");
    declareCriterion(options, task_.query.criterion, machine_);
    declareBudget(options, task_.query.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.require({ "to" });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }
  Remedy remedy() const override { return { "--joint-limits on", "a --box" }; }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    const Progress progress = caller().progress(progress_);
    task_.query.budget.stop = caller().stop();
    task_.from = from_ ? *from_ : startOf(machine, task_.query.criterion);
    task_.to = *to_;
    ConnectionReport report = connect(machine, task_);
    if (!from_ && report.bad_point == task_.from)
      report.message += " That is where it starts without --from, the zero configuration: give --from X Y Z.";
    Json json = contextOf(machine, task_.query.criterion);
    json["verdict"] = nameOf(report.verdict);
    json["from"] = toJson(task_.from);
    json["to"] = toJson(task_.to);
    json["bad_point"] = report.bad_point ? toJson(*report.bad_point) : Json();
    json["path"] = Json();
    for (const Eigen::Vector3d& point : report.path)
      json["path"].push_back(toJson(point));
    json["resolution"] = report.paving.resolution;
    json["boxes"] = report.paving.boxes;
    json["seconds"] = report.seconds;
    json["message"] = report.message;
    return { json, print(report) };
  }

private:
  std::string print(const ConnectionReport& report) const
  {
    std::vector<Words> rows = { { "verdict", nameOf(report.verdict) },
                                { "from", describe(task_.from) },
                                { "to", describe(task_.to) } };
    if (report.bad_point)
      rows.push_back({ "bad point", describe(*report.bad_point) });
    for (const Eigen::Vector3d& point : report.path)
      rows.push_back({ "path", describe(point) });
    rows.push_back({ "effort", std::to_string(report.paving.boxes) + " boxes, " + seconds(report.seconds) });
    return "Machine '" + machine_.machine().name() + "', from one tool point to another\n\n" +
           aligned(rows, Align::LEFT) + "\n" + wrapped(report.message) +
           wrapped(definition(machine_.machine(), task_.query.criterion));
  }

  MachineOptions machine_;
  ConnectionTask task_;
  std::optional<Eigen::Vector3d> from_;
  std::optional<Eigen::Vector3d> to_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeConnect()
{
  return std::make_unique<Connect>();
}
}  // namespace cli
}  // namespace pkm_workspace
