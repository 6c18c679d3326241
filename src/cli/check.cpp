// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
#include "pkm_workspace/report/set_reach.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Boxes of centers that tell how far the rails go.
constexpr std::size_t MOST_CARRIERS = 100;

const char* nameOf(Share share)
{
  constexpr const char* NAMES[] = { "all", "none", "some", "undecided" };  // as Share
  return NAMES[static_cast<std::size_t>(share)];
}

std::string sentence(Share share)
{
  return share == Share::SOME        ? "some are proved to, and some not to,"
         : share == Share::UNDECIDED ? "it is undecided how many"
                                     : std::string(nameOf(share)) + " are proved to";
}

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
    options.box("centers", centers_,
                "in place of --center, centers that the box may have: tells whether all, none or some carry it");
    options.vector("sides", sides_, "A B C", LENGTH_NOT_NEGATIVE,
                   "full sides of the box along x, y and z; 0 for no thickness, at least one above 0");
    options.require({ "sides" });
    declareCriterion(options, criterion_);
    budget_.max_boxes = 1000000;
    options.count("max-boxes", budget_.max_boxes, MOST_BOXES, "boxes looked at before it ends undecided");
    declareTimeLimit(options, budget_.time_limit);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.flag("multi-precision", multi_precision_, MULTI_PRECISION_HELP);
    options.check({ "sides" }, [this](Problems& problems) { setShape(problems); });
    options.check({ "center", "centers" }, [this](Problems& problems) {
      if (center_.has_value() == centers_.has_value())
        problems.push_back("give either --center or --centers");
    });
  }

  Words warnings() const override { return machine_.warnings(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    const Progress progress(progress_);
    const BoxTest test(machine, criterion_, multi_precision_ ? Precision::MULTIPLE : Precision::DOUBLE);
    if (centers_)
      return answerForAll(test);
    budget_.stop = stopOnSignal();
    const ContainmentResult result = checkContainment(test, *shape_, *center_, 1.0, budget_);
    Json json = contextOf(machine, criterion_);
    json["verdict"] = name(result.verdict);
    json["center"] = toJson(*center_);
    json["sides"] = toJson(*sides_);
    json["bad_point"] = result.bad_point ? toJson(*result.bad_point) : Json();
    json["bad_within"] = result.bad_within;
    json["boxes"] = result.boxes;
    if (result.verdict == Containment::INSIDE && !criterion_.joint_limits)
      addLimits(machine, criterion_, reach(), json);
    json["message"] = message(result);
    return { json, print(result) };
  }

private:
  /// The paper's G(B, w).
  Answer answerForAll(const BoxTest& test) const
  {
    BisectionLimits limits;
    limits.stop = stopOnSignalOrAfter(budget_.time_limit);
    limits.center_width *= machine_.machine().scale();
    limits.part_width *= machine_.machine().scale();
    std::vector<Box> carriers;
    limits.carried = [&carriers](const Box& part) {
      if (carriers.size() < MOST_CARRIERS)
        carriers.push_back(part);
    };
    const Share share = checkCenters(test, *centers_, *sides_, limits);
    const Machine& machine = machine_.machine();
    std::optional<JointReaches> reaches;
    if (!criterion_.joint_limits && (share == Share::ALL || share == Share::SOME))
      reaches = reachOverCenters(machine, criterion_, *centers_, *sides_, share, carriers);
    Json json = contextOf(machine, criterion_);
    json["share"] = nameOf(share);
    json["centers"] = toJson(*centers_);
    json["sides"] = toJson(*sides_);
    addLimits(machine, criterion_, reaches, json);
    const std::string reason = share == Share::UNDECIDED && isTimeOver() ? "; " + timeIsOver(budget_.time_limit) : "";
    const std::string text = "Of the centers from " + describe(centers_->lower) + " to " + describe(centers_->upper) +
                             ", " + sentence(share) + " carry a box with sides " + describe(*sides_) + reason + ".";
    const std::string remark = remarkOnLimits(machine, criterion_, reaches);
    json["message"] = withRemark(text, remark);
    return { json, wrapped(text) + wrapped(definition(machine, criterion_)) + wrapped(remark) };
  }

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

  /// @pre the box is inside
  JointReaches reach() const { return reachOver(machine_.machine(), *shape_, *center_, 1.0); }

  std::string message(const ContainmentResult& result) const
  {
    const PointEvaluator evaluator(machine_.machine(), criterion_);
    return describe(result, evaluator, *shape_, *center_, 1.0, budget_);
  }

  std::string print(const ContainmentResult& result) const
  {
    std::vector<Words> rows = { { "verdict", name(result.verdict) } };
    if (result.bad_point)
      rows.push_back({ "bad point", describe(*result.bad_point) });
    rows.push_back({ "effort", std::to_string(result.boxes) + " boxes" });
    return "Box of machine '" + machine_.machine().name() + "' with center " + describe(*center_) + " and sides " +
           describe(*sides_) + "\n\n" + aligned(rows, Align::LEFT) + "\n" + wrapped(message(result)) +
           wrapped(definition(machine_.machine(), criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  std::optional<Eigen::Vector3d> center_;
  std::optional<Eigen::Vector3d> sides_;
  std::optional<Box> centers_;
  bool multi_precision_ = false;
  ShapePtr shape_;
  Budget budget_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeCheck()
{
  return std::make_unique<Check>();
}
}  // namespace cli
}  // namespace pkm_workspace
