// SPDX-License-Identifier: BSD-3-Clause
#include "command.h"
#include "common_options.h"
#include "output.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/paving/paving.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
Json volumesOf(const Paving& paving)
{
  return { { "volume_lower", paving.volumeLower() }, { "volume_upper", paving.volumeUpper() } };
}

std::string volumes(const Json& json)
{
  return bracket(json["volume_lower"], json["volume_upper"]) + " m^3";
}

class Pave : public Command
{
public:
  std::string description() const override
  {
    return "Approximates the dextrous or the reachable set by boxes: boxes inside are proved to belong to it, "
           "boxes at the border are undecided at the resolution, and all else is proved not to belong to it. "
           "The volume of the set is proved to lie between two numbers. The reachable set is told for the "
           "machine's own aspect (sign of det A) and for the other one, too, in runs of their own that share "
           "the time limit. Ctrl-C ends it with what is proved.";
  }

  Words examples() const override
  {
    return { "pkm pave --urdf orthoglide.urdf --set dextrous --resolution 0.05",
             "pkm pave --urdf uranesx.urdf --set reachable --resolution 0.1 --joint-limits on" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.choice("set", set_, { "dextrous", "reachable" }, "what to approximate");
    options.number("resolution", query_.resolution, LENGTH_POSITIVE,
                   "boxes no wider than this are not divided further");
    options.box("box", query_.box, "what to look at; without it, the whole workspace");
    declareCriterion(options, query_.criterion);
    declareBudget(options, query_.budget);
    options.flag("progress", progress_, PROGRESS_HELP);
    options.check({ "set", "psi-min", "psi-max" }, [this, &options](Problems& problems) {
      if (set_ == "reachable" && (options.given("psi-min") || options.given("psi-max")))
        problems.push_back("a reachable set has no transmission factors: leave them out");
    });
  }

  Words warnings() const override { return machine_.warnings(); }

  Answer answer() override
  {
    query_.budget.stop = stopOnSignal();
    const bool reachable = set_ == "reachable";
    if (reachable)
    {
      query_.criterion.set = Criterion::Set::REACHABLE;
      query_.budget.time_limit /= 3.0;
    }
    const Paving paving = run(reachable ? Criterion::Aspect::BOTH : Criterion::Aspect::OWN);
    Json json = toJson(paving);
    if (reachable)
    {
      const Paving own = run(Criterion::Aspect::OWN);
      const Paving other = run(Criterion::Aspect::OTHER);
      json["own_aspect"] = volumesOf(own);
      json["other_aspect"] = volumesOf(other);
      json["seconds"] = paving.seconds + own.seconds + other.seconds;
      json["complete"] = paving.complete && own.complete && other.complete;
    }
    return { json, print(paving, json) };
  }

private:
  Paving run(Criterion::Aspect aspect)
  {
    Progress progress(progress_);
    PavingQuery query = query_;
    query.criterion.aspect = aspect;
    query.progress = [&progress](const PavingProgress& state) {
      progress.tell(state.seconds, "volume inside " + nearly(state.volume_inside) + " m^3, undecided " +
                                       nearly(state.volume_boundary) + " m^3, " + std::to_string(state.boxes) +
                                       " boxes");
    };
    return pave(machine_.machine(), query);
  }

  Json toJson(const Paving& paving) const
  {
    Json json = contextOf(machine_.machine(), query_.criterion);
    json.update(volumesOf(paving));
    json["set"] = set_;
    json["resolution"] = query_.resolution;
    json["box"] = cli::toJson(paving.box);
    json["boxes"] = paving.boxes;
    json["boxes_inside"] = paving.tree.count(CellState::INSIDE);
    json["boxes_boundary"] = paving.tree.count(CellState::BOUNDARY);
    json["boxes_pending"] = paving.tree.count(CellState::PENDING);
    json["seconds"] = paving.seconds;
    json["complete"] = paving.complete;
    return json;
  }

  std::string print(const Paving& paving, const Json& json) const
  {
    std::vector<Words> rows = { { "volume", volumes(json) } };
    if (json.contains("own_aspect"))
    {
      rows.push_back({ "own aspect", volumes(json["own_aspect"]) });
      rows.push_back({ "other aspect", volumes(json["other_aspect"]) });
    }
    rows.push_back({ "inside", std::to_string(paving.tree.count(CellState::INSIDE)) + " boxes" });
    rows.push_back(
        { "boundary", std::to_string(paving.tree.count(CellState::BOUNDARY)) + " boxes, undecided at the resolution" });
    rows.push_back({ "pending", std::to_string(paving.tree.count(CellState::PENDING)) + " boxes, not looked at" });
    rows.push_back({ "box", "from " + describe(paving.box.lower) + " to " + describe(paving.box.upper) });
    rows.push_back({ "resolution", exact(query_.resolution) + " m" });
    rows.push_back({ "effort", std::to_string(paving.boxes) + " boxes, " + seconds(json["seconds"]) });
    return "Paving of the " + set_ + " set of machine '" + machine_.machine().name() + "'\n\n" +
           aligned(rows, Align::LEFT) + "\n" + wrapped(proof(json)) + wrapped(definition(query_.criterion));
  }

  std::string proof(const Json& json) const
  {
    return "Proved: the " + set_ + " points of the box have a volume of " + volumes(json) + "." +
           (json["complete"].get<bool>() ? "" : " A budget or a signal ended it early: more time gives closer bounds.");
  }

  MachineOptions machine_;
  PavingQuery query_;
  bool progress_ = false;
  std::string set_ = "dextrous";
};
}  // namespace

std::unique_ptr<Command> makePave()
{
  return std::make_unique<Pave>();
}
}  // namespace cli
}  // namespace pkm_workspace
