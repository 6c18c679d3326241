// SPDX-License-Identifier: BSD-3-Clause
#include "certificate_option.h"
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/dexterity/region_check.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/bad_machine.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/report/containment_sentence.h"
#include "pkm_workspace/report/set_reach.h"
#include "pkm_workspace/report/tolerate_sentence.h"
#include "progress.h"
#include "region_option.h"

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
    return "Tells whether every point of a region is dextrous: inside (proved), outside (with a point of the region "
           "that is proved not to be), or undecided. There is no tolerance.";
  }

  Words examples() const override
  {
    return { "pkm check --urdf orthoglide.urdf --center 0.08 0.08 0.08 --sides 0.6 0.6 0.6",
             "pkm check --urdf orthoglide.urdf --center 0.08 0.08 0.08 --radius 0.2 --height 0.3" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.vector("center", center_, "X Y Z", LENGTH, "center of the region, in the frame of the root link");
    options.box(
        "centers", centers_,
        "in place of --center, centers that a box of --sides may have: tells whether all, none or some carry it");
    body_.declare(options);
    declareCriterion(options, criterion_, machine_);
    budget_.max_boxes = DEFAULT_CHECK_BOXES;
    options.count("max-boxes", budget_.max_boxes, MOST_BOXES, "boxes looked at before it ends undecided");
    declareTimeLimit(options, budget_.time_limit);
    certificate_.declare(options);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.flag("multi-precision", multi_precision_, MULTI_PRECISION_HELP);
    options.check({ "size", "sides", "radius", "height" }, [this, &options](Problems& problems) {
      if (!body_.given() && !options.given("shape"))
        problems.push_back("give the region: --sides A B C, --radius R, --radius R --height H, or --shape and --size");
    });
    options.check({ "centers", "size", "sides", "radius", "height" }, [this](Problems& problems) {
      if (centers_ && body_.given() && !body_.sides())
        problems.push_back("only a box of --sides can have --centers; for another region give its --center");
    });
    options.check({ "certificate", "centers" }, [this](Problems& problems) {
      if (centers_ && certificate_.given())
        problems.push_back("a certificate is about one region: give its --center");
    });
    options.check({ "center", "centers" }, [this](Problems& problems) {
      if (center_.has_value() == centers_.has_value())
        problems.push_back("give either --center or --centers");
    });
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    certificate_.validate(machine, criterion_, centers_ ? nullptr : body_.solid().shape.get());
    const Progress progress = caller().progress(progress_);
    const BoxTest test(machine, criterion_, multi_precision_ ? Precision::MULTIPLE : Precision::DOUBLE);
    if (centers_)
      return answerForAll(test);
    budget_.stop = caller().stop();
    const Solid& solid = body_.solid();
    result_ = checkContainment(test, *solid.shape, *center_, solid.size, budget_);
    const ContainmentResult& result = result_;
    Json json = contextOf(machine, criterion_);
    json["verdict"] = name(result.verdict);
    json["center"] = toJson(*center_);
    json["shape"] = solid.shape->name();
    json["dimensions"] = solid.shape->dimensions(solid.size);
    addVertices(*solid.shape, solid.size, json);
    if (body_.sides())
      json["sides"] = toJson(*body_.sides());
    json["bad_point"] = result.bad_point ? toJson(*result.bad_point) : Json();
    const std::optional<Machine> bad = badMachine(result);
    if (machine.hasTolerances())
      json["bad_machine"] = bad ? differencesJson(*bad, machine) : Json();
    json["bad_within"] = result.bad_within;
    json["boxes"] = result.boxes;
    if (result.verdict == Containment::INSIDE && !criterion_.joint_limits)
      addLimits(machine, criterion_, reachOver(machine, *solid.shape, *center_, solid.size), json);
    json["message"] = message(result);
    return { json, Text([this, bad] { return print(result_) + (bad ? aboutMachine(*bad) : ""); }) };
  }

  void save() override
  {
    if (certificate_.given())
      certificate_.save(caller(), machine_.machine(), criterion_, result_.verdict, body_.solid(), *center_);
  }

private:
  /// Of all machines within tolerances, the one that is bad at the bad point.
  std::optional<Machine> badMachine(const ContainmentResult& result) const
  {
    return machine_.machine().hasTolerances() && result.bad_point
               ? badMachineAt(machine_.machine(), criterion_, *result.bad_point).machine
               : std::nullopt;
  }

  std::string aboutMachine(const Machine& bad) const
  {
    return wrapped("One of the machines that are bad there:") +
           joined(differencesInWords(bad, machine_.machine()), "\n") + "\n";
  }

  /// The paper's G(B, w).
  Answer answerForAll(const BoxTest& test) const
  {
    BisectionLimits limits;
    limits.stop = caller().stopAfter(budget_.time_limit);
    limits.center_width *= machine_.machine().scale();
    limits.part_width *= machine_.machine().scale();
    std::vector<Box> carriers;
    limits.carried = [&carriers](const Box& part) {
      if (carriers.size() < MOST_CARRIERS)
        carriers.push_back(part);
    };
    const Machine& machine = machine_.machine();
    const Eigen::Vector3d& sides = *body_.sides();
    const Share share = checkCenters(test, *centers_, sides, limits);
    std::optional<JointReaches> reaches;
    if (!criterion_.joint_limits && (share == Share::ALL || share == Share::SOME))
      reaches = reachOverCenters(machine, criterion_, *centers_, sides, share, carriers);
    Json json = contextOf(machine, criterion_);
    json["share"] = nameOf(share);
    json["centers"] = toJson(*centers_);
    json["sides"] = toJson(sides);
    addLimits(machine, criterion_, reaches, json);
    const bool is_stopped = share == Share::UNDECIDED && *limits.stop;
    const std::string reason = is_stopped ? "; " + caller().stoppedBy(budget_.time_limit) + " ended the proof" : "";
    const std::string text = "Of the centers from " + describe(centers_->lower) + " to " + describe(centers_->upper) +
                             ", " + sentence(share) + " carry a box with sides " + describe(sides) + reason + ".";
    const std::string remark = remarkOnLimits(machine, criterion_, reaches);
    json["message"] = withRemark(text, remark);
    return { json, wrapped(text) + wrapped(definition(machine, criterion_)) + wrapped(remark) };
  }

  /// "sides (1, 2, 3) m", "radius 1 m", "height 1 m, radius 2 m"
  std::string measures() const
  {
    const Solid& solid = body_.solid();
    const std::vector<double> lengths = solid.shape->dimensions(solid.size);
    if (lengths.size() == 3)
      return "sides " + describe(Eigen::Vector3d(lengths[0], lengths[1], lengths[2]));
    if (lengths.empty())
      return "size " + exact(solid.size);
    const std::string radius = "radius " + exact(lengths.back()) + " m";
    return lengths.size() == 1 ? radius : "height " + exact(lengths[0]) + " m, " + radius;
  }

  std::string message(const ContainmentResult& result) const
  {
    const PointEvaluator evaluator(machine_.machine(), criterion_);
    return describe(result, evaluator, *body_.solid().shape, *center_, body_.solid().size, budget_);
  }

  std::string print(const ContainmentResult& result) const
  {
    std::vector<Words> rows = { { "verdict", name(result.verdict) } };
    if (result.bad_point)
      rows.push_back({ "bad point", describe(*result.bad_point) });
    rows.push_back({ "effort", std::to_string(result.boxes) + " boxes" });
    return "Machine '" + machine_.machine().name() + "', " + body_.solid().shape->name() + " with center " +
           describe(*center_) + ", " + measures() + "\n\n" + aligned(rows, Align::LEFT) + "\n" +
           wrapped(message(result)) + wrapped(definition(machine_.machine(), criterion_));
  }

  MachineOptions machine_;
  Criterion criterion_;
  BodyOption body_;
  std::optional<Eigen::Vector3d> center_;
  std::optional<Box> centers_;
  bool multi_precision_ = false;
  Budget budget_;
  CertificateOption certificate_;
  ContainmentResult result_;
  bool progress_ = false;
};
}  // namespace

std::unique_ptr<Command> makeCheck()
{
  return std::make_unique<Check>();
}
}  // namespace cli
}  // namespace pkm_workspace
