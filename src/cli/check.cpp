// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/region/containment.h"
#include "progress.h"
#include "violations.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
class Check : public Command
{
public:
  std::string description() const override
  {
    return "Tells whether every point of a box is dextrous: inside (proved), outside (with a point of the box "
           "that is proved not to be), or undecided. There is no tolerance.";
  }

  Words examples() const override
  {
    return { "pkm check --urdf orthoglide.urdf --center 0.08 0.08 0.08 --sides 0.6 0.6 0.6" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("center", center_, "X Y Z", LENGTH, "center of the box, in the frame of the root link");
    options.vector("sides", sides_, "A B C", LENGTH_NOT_NEGATIVE,
                   "full sides of the box along x, y and z; 0 for no thickness, at least one above 0");
    options.require({ "center", "sides" });
    criterion_options_.declare(options, criterion_);
    options.count("max-boxes", max_boxes_, MOST_BOXES, "boxes looked at before it ends undecided");
    options.check({ "sides" }, [this](Problems& problems) { setShape(problems); });
  }

  Words warnings() const override { return machine_.warnings(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    const BoxTest test(machine, criterion_);
    const ContainmentResult result = checkContainment(test, *shape_, *center_, 1.0, max_boxes_, stopOnSignal());
    Json json = contextOf(machine, criterion_);
    json["verdict"] = name(result.verdict);
    json["center"] = toJson(*center_);
    json["sides"] = toJson(*sides_);
    json["bad_point"] = result.bad_point ? toJson(*result.bad_point) : Json();
    json["boxes"] = result.boxes;
    json["message"] = message(result);
    return { json, print(result) };
  }

private:
  void setShape(Problems& problems)
  {
    if (sides_->isZero(0.0))
      problems.push_back("one side at least must be above 0 m; for a point there is pkm evaluate");
    else
      try
      {
        shape_ = makeBox(*sides_);
      }
      catch (const std::invalid_argument& reason)
      {
        problems.push_back(reason.what());
      }
  }

  std::string message(const ContainmentResult& result) const
  {
    if (result.verdict == Containment::INSIDE)
      return "Proved: every point of the box is " + cli::name(criterion_.set) + ".";
    if (result.verdict == Containment::UNDECIDED)
      return "Neither is proved: the border of the set is within rounding of the box, or " +
             std::to_string(max_boxes_) + " boxes (--max-boxes) were not enough.";
    const Words reasons = violations(machine_.machine(), criterion_, *result.bad_point);
    return "Proved: the bad point lies in the box and is not " + cli::name(criterion_.set) +
           std::string(reasons.empty() ? "" : ": ") + joined(reasons, "; ") + ".";
  }

  std::string print(const ContainmentResult& result) const
  {
    std::vector<Words> rows = { { "verdict", name(result.verdict) } };
    if (result.bad_point)
      rows.push_back({ "bad point", describe(*result.bad_point) });
    rows.push_back({ "effort", std::to_string(result.boxes) + " boxes" });
    return "Box of machine '" + machine_.machine().name() + "' with center " + describe(*center_) + " and sides " +
           describe(*sides_) + "\n\n" + aligned(rows, Align::LEFT) + "\n" + wrapped(message(result)) +
           wrapped(definition(criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  CriterionOptions criterion_options_;
  std::optional<Eigen::Vector3d> center_;
  std::optional<Eigen::Vector3d> sides_;
  ShapePtr shape_;
  std::int64_t max_boxes_ = 1000000;
};
}  // namespace

std::unique_ptr<Command> makeCheck()
{
  return std::make_unique<Check>();
}
}  // namespace cli
}  // namespace pkm_workspace
