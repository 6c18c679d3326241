// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "certificate_option.h"
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/region/solid.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "progress.h"
#include "shape_options.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json answerJson(const Machine& machine, const RegionQuery& query, const LargestRegion& region)
{
  const Shape& shape = *region.shape;
  const bool found = region.size > 0.0;
  Json json = contextOf(machine, query.criterion);
  json["status"] = name(region.status);
  const CenteredSolid solid = centeredSolid(shape, region.center, region.size);
  json["shape"] = shape.kind();
  json["accuracy"] = query.accuracy;
  json["center"] = found ? toJson(solid.center) : Json();
  json["dimensions"] = found ? Json(solid.dimensions) : Json();
  json["angle"] = found && region.angle ? Json(*region.angle) : Json();
  addVertices(shape, region.size, json);
  json["base_z"] = query.base_z ? Json(*query.base_z) : Json();
  json["size"] = region.size;
  json["size_upper_bound"] = region.size_upper_bound;
  json["joint_ranges"] = found ? toJson(machine, region.joint_ranges) : Json::array();
  if (found)
    addLimits(machine, query.criterion, reachOver(region), json);
  json["boxes"] = region.boxes;
  json["verification_boxes"] = region.verification_boxes;
  json["seconds"] = region.seconds;
  json["message"] = endingOf(region, machine, query.criterion);
  json["ratio"] = region.ratio ? Json{ region.ratio->lower, region.ratio->upper } : Json();
  if (isSolid(shape))
  {
    json["volume"] = region.volume;
    json["volume_upper_bound"] = region.volume_upper_bound;
  }
  return json;
}

/// A bound, or both ends of its enclosure where the digits that are printed tell them apart.
std::string cell(const Interval& value, const std::string& bound, int decimals)
{
  const bool known = value.width() <= std::pow(10.0, -decimals);
  return known ? bound : roundedDown(value.lower(), decimals) + " to " + roundedUp(value.upper(), decimals);
}

std::string table(const Machine& machine, const std::array<JointRange, 3>& ranges, int decimals)
{
  const auto least = [decimals](const Interval& x) { return cell(x, roundedDown(x.lower(), decimals), decimals); };
  const auto most = [decimals](const Interval& x) { return cell(x, roundedUp(x.upper(), decimals), decimals); };
  const bool has_angles =
      std::any_of(machine.legs().begin(), machine.legs().end(), [](const Leg& leg) { return hasAngle(leg); });
  std::vector<Words> rows =
      has_angles ? std::vector<Words>{ { "joint", "lower", "upper", "stroke", "across" } }
                 : std::vector<Words>{ { "joint", "lower [m]", "upper [m]", "stroke [m]", "across [m]" } };
  for (std::size_t i = 0; i < 3; ++i)
    rows.push_back({ machine.legs()[i].joint + (has_angles ? std::string(" [") + unitOf(machine.legs()[i]) + "]" : ""),
                     least(ranges[i].lower), most(ranges[i].upper), most(ranges[i].stroke), most(ranges[i].across) });
  return aligned(rows, Align::RIGHT);
}

class Largest : public Command
{
public:
  std::string description() const override
  {
    return "Finds the largest region of a shape whose every point is dextrous: a center and a size for which "
           "that is proved, and an upper bound above which no such region exists, wherever its center. Along "
           "parallel rails the center has the height of the zero configuration, or of the middle of --search-box; as "
           "near to it as the joint limits let the region. With --base-z the region stands on that height. "
           "With --turned it may have any angle about the vertical. Ctrl-C ends "
           "the search with the best proved so far.";
  }

  Words examples() const override
  {
    return { "pkm largest --urdf orthoglide.urdf --shape cube --accuracy 1e-4",
             "pkm largest --urdf uranesx.urdf --shape square --turned",
             "pkm largest --urdf orthoglide.urdf --shape box --proportions 2 1 1 --joint-limits off --json",
             "pkm largest --urdf orthoglide.urdf --shape cylinder --radius 0.2 --base-z 0" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    shape_.declare(options, query_);
    declareCriterion(options, query_.criterion, machine_);
    accuracy_.declare(options,
                      "largest difference between the proved size and its upper bound (of a box: in factors; of a "
                      "cylinder of free ratio: by how much its height would grow with its volume)");
    place_.declare(options, query_);
    options.flag("multi-precision", multi_precision_, MULTI_PRECISION_HELP);
    declareBudget(options, query_.budget);
    certificate_.declare(options);
    options.flag("progress", progress_, PROGRESS_HELP);
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Remedy remedy() const override { return { "--joint-limits on", "a --search-box within 1000 struts" }; }

  Answer answer() override
  {
    const Machine& machine = machine_.machine();
    Progress progress = caller().progress(progress_);
    query_.accuracy = accuracy_.valueFor(machine, *query_.shape);
    query_.precision = multi_precision_ ? Precision::MULTIPLE : Precision::DOUBLE;
    query_.budget.stop = caller().stop();
    query_.progress = [&progress, this](const RegionProgress& state) {
      progress.tell((query_.ratio ? "volume " + bracket(state.volume, state.volume_upper_bound) + " m^3"
                                  : "size " + bracket(state.size, state.size_upper_bound)) +
                    ", " + std::to_string(state.boxes_done) + " boxes done, " + std::to_string(state.boxes_open) +
                    " open");
    };
    certificate_.follow(machine, query_);
    region_ = findLargestRegion(machine, query_);
    return { answerJson(machine, query_, region_), Text([this] { return print(region_); }) };
  }

  void save() override { certificate_.save(caller(), machine_.machine(), query_, region_); }

private:
  std::string print(const LargestRegion& region) const
  {
    const Shape& shape = *region.shape;
    const int decimals = decimalsOf(region, query_.accuracy);
    std::vector<Words> rows = { { "status", std::string(name(region.status)) + " (" + region.message + ")" },
                                { shape.sizeMeaning(), roundedDown(region.size, decimals) } };
    if (!region.ratio)
      rows.push_back({ "upper bound", roundedUp(region.size_upper_bound, decimals) });
    if (region.size > 0.0)
    {
      const CenteredSolid solid = centeredSolid(shape, region.center, region.size);
      rows.push_back({ "center", describe(solid.center) });
      if (region.angle)
        rows.push_back({ "turned by", exact(*region.angle) + " rad from x to y, " +
                                          nearly(*region.angle * 180.0 / M_PI, 6) + " degrees" });
      if (!shape.isPolytope())
        rows.push_back({ "dimensions", dimensions(shape, solid.dimensions, decimals) });
    }
    if (region.ratio || (region.size > 0.0 && isSolid(shape)))
      rows.push_back({ "volume", bracket(region.volume, region.volume_upper_bound) + " m^3" });
    rows.push_back({ "effort", std::to_string(region.boxes) + " boxes of centers, " + seconds(region.seconds) });
    std::string text = "Largest " + shape.name() + " of machine '" + machine_.machine().name() + "'\n\n";
    text += aligned(rows, Align::LEFT) + "\n";
    if (region.size > 0.0)
      text += table(machine_.machine(), region.joint_ranges, decimals) + "\n";
    return text + wrapped(describe(region, machine_.machine(), query_)) +
           wrapped(definition(machine_.machine(), query_.criterion)) +
           wrapped(remarkOnLimits(machine_.machine(), query_.criterion, reachOver(region)));
  }

  static std::string dimensions(const Shape& shape, const std::vector<double>& of, int decimals)
  {
    Words sides;
    for (const double side : of)
      sides.push_back(roundedDown(side, decimals));
    const char* const of_round = sides.size() == 1 ? ", the radius" : ", height x radius";
    return joined(sides, " x ") + " m" + (shape.isBox() ? "" : of_round);
  }

  MachineOptions machine_;
  RegionQuery query_;
  AccuracyOption accuracy_;
  CertificateOption certificate_;
  LargestRegion region_;
  bool progress_ = false;
  bool multi_precision_ = false;
  ShapeOptions shape_;
  PlaceOptions place_;
};
}  // namespace

std::unique_ptr<Command> makeLargest()
{
  return std::make_unique<Largest>();
}
}  // namespace cli
}  // namespace pkm_workspace
