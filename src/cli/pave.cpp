// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "certificate_option.h"
#include "command.h"
#include "common_options.h"
#include "mesh_options.h"
#include "output.h"
#include "pave_answer.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/paving/paving_file.h"
#include "pkm_workspace/report/paving_sentence.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr std::int64_t MOST_LISTED = 10000000;
/// What the width of a bracket may be, relative.
const Quantity SHARE{ "", 1e-15, true, 1.0 };

class Pave : public Command
{
public:
  std::string description() const override
  {
    return "Approximates the dextrous or the reachable set by boxes: boxes inside are proved to belong to it, "
           "boxes at the border are undecided at the resolution, and all else is proved not to belong to it. "
           "The volume of the set is proved to lie between two numbers, by the parts of boxes that its conditions cut "
           "off: "
           "four times as closely at half the resolution, or to a relative width by --volume-to. It is told for the "
           "aspect "
           "(sign of det A) that is asked for, and for each aspect, in runs of their own that share the limits of time "
           "and memory. Where nothing changes along the rails, without a box, it is the area of the section across "
           "them that is told. Ctrl-C ends it with what is proved. "
           "With --json: volume_lower and volume_upper [m^3] (area_lower and area_upper [m^2] where dimension is 2) of "
           "the set in the aspect that is asked for, and of each aspect in "
           "own_aspect and other_aspect; volume_inside and volume_boundary [m^3], of the boxes inside, rounded down, "
           "and of "
           "those undecided, rounded up (V_a and V_e; area_inside and area_boundary where dimension is 2); "
           "volume_boxes, "
           "boxes looked at for the volume; of the first resolution [m], box [m], and boxes, boxes_here (looked at "
           "in this run), boxes_inside, boxes_boundary, boxes_pending; seconds; complete, whether none is pending and "
           "the "
           "volume is known as closely as asked. "
           "With --components, components: the largest first, each with its volume_lower, boxes, box, a point in it "
           "[m] "
           "and the cluster it is in, no path joins two clusters; clusters, how many; zero_component, the index of the "
           "zero configuration's or null; components_message. "
           "With --octomap, octomap: its resolution [m], free_voxels, occupied_voxels and free_volume [m^3]. "
           "With --mesh or --outer-mesh, surfaces: inner and outer, each with its triangles, vertices and volume "
           "[m^3], and "
           "distance [m], of no point within the outer one more from the inner one's solid. "
           "With --list-boxes, listed: inside and undecided, each a list of boxes x0, x1, y0, y1, z0, z1 [m].";
  }

  Words examples() const override
  {
    return { "pkm pave --urdf orthoglide.urdf --set dextrous --resolution 0.05 --save paving.pkm",
             "pkm pave --urdf orthoglide.urdf --set dextrous --resolution 0.02 --resume paving.pkm",
             "pkm pave --urdf orthoglide.urdf --volume-to 1e-4",
             "pkm pave --urdf orthoglide.urdf --resolution 0.03 --mesh set.stl --outer-mesh around.stl",
             "pkm pave --urdf orthoglide.urdf --resolution 0.05 --octomap set.bt",
             "pkm pave --urdf uranesx.urdf --joint-limits off --resolution 0.01",
             "pkm pave --urdf uranesx.urdf --set reachable --resolution 0.1" };
  }

  void declare(Options& options) override
  {
    machine_.declare(options);
    options.number("resolution", resolution_, LENGTH_POSITIVE,
                   "boxes no wider than this are not divided further; without it, a twentieth of the longest strut, "
                   "for a flat box a fortieth");
    options.number(
        "volume-to", volume_to_, SHARE,
        "wanted width of the volume's bracket, relative to its upper end: boxes at the border are divided "
        "further until it is that narrow, where most is uncertain first; 1: as close as the resolution gives");
    options.box("box", query_.box,
                "what to look at; without it, the whole workspace, or its section through the zero configuration "
                "where nothing changes along the rails");
    declareCriterion(options, query_.criterion, machine_);
    declareBudget(options, query_.budget);
    declareOutput(options, "save", save_, "file to write the boxes to, with those left open; a file there is replaced");
    paved_.mesh.declare(options, save_);
    certificate_.declare(options);
    options.text(
        "resume", resume_, "FILE",
        "file of an earlier run for the same machine, set, criterion and box to go on from, at any resolution: "
        "the answer is what a new run gives");
    options.count(
        "list-boxes", list_boxes_, MOST_LISTED,
        "with --json, lists the boxes of the aspect that is asked for, at most so many: where there are more, "
        "larger ones, of which more are undecided");
    options.flag("components", components_,
                 "tells how the set hangs together in the aspect that is asked for: its connected components, which of "
                 "them no path joins, and which one holds the zero configuration");
    options.flag("progress", progress_, PROGRESS_HELP);
    declareConditions(options);
  }

  Words warnings() const override { return machine_.warnings(); }
  Words notes() const override { return machine_.notes(); }

  Remedy remedy() const override { return { "--joint-limits on", "a --box" }; }

  Answer answer() override
  {
    certificate_.validate(machine_.machine(), query_.criterion);
    query_.budget.stop = caller().stop();
    query_.resolution = resolution_ ? *resolution_ : defaultResolution(machine_.machine(), query_);
    const std::vector<PavingQuery> queries = this->queries();
    std::vector<Paving> earlier;
    if (!resume_.empty())
      earlier = loadPavings(resume_, machine_.machine(), queries);
    paved_.asked = query_.criterion.aspect == Criterion::Aspect::OTHER ? 1 : 0;
    paved_.reports.resize(queries.size());
    VolumeQuery wanted;
    wanted.accuracy = volume_to_;
    for (std::size_t k = 0; k < queries.size(); ++k)
    {
      const std::size_t next = k == 0 ? paved_.asked : k == paved_.asked ? 0 : k;
      paved_.reports[next] = run(queries[next], earlier.empty() ? nullptr : &earlier[next], wanted);
      if (k == 0)  // the others as closely, in m^3
        wanted.width = volume_to_ * paved_.reports[next].size.volume.upper();
    }
    paved_.reports[paved_.asked].ended_by = endedBy(paved_.reports);
    paved_.most_listed = list_boxes_;
    PavingReport& asked = paved_.reports[paved_.asked];
    if (components_)
      asked.components = reportComponents(machine_.machine(), asked.paving, !query_.box, queries[paved_.asked].budget);
    paved_.mesh.compute(machine_.machine(), queries[paved_.asked], [this] { return caller().progress(progress_); });
    return answerOf(machine_.machine(), paved_);
  }

  void save() override
  {
    if (!save_.empty())
    {
      std::vector<Paving> pavings;
      for (PavingReport& report : paved_.reports)
        pavings.push_back(std::move(report.paving));
      savePavings(save_, pavings);
      paved_.reports[paved_.asked].paving = std::move(pavings[paved_.asked]);
    }
    certificate_.save(caller(), machine_.machine(), query_.criterion, paved_.reports[paved_.asked].paving,
                      query_.budget.max_memory);
    paved_.mesh.save(machine_.machine());
  }

private:
  void declareConditions(Options& options)
  {
    options.check({ "max-memory" }, [this](Problems& problems) {
      const std::int64_t most = query_.budget.max_memory;
      const auto runs = static_cast<std::int64_t>(aspects().size());
      if (most >= Budget::LEAST_MEMORY && most / runs < Budget::LEAST_MEMORY)
        problems.push_back("too little for " + std::to_string(runs) + " runs of at least " +
                           std::to_string(Budget::LEAST_MEMORY) + " bytes each");
    });
  }

  /// What is told of: each aspect at the end, both of them before where that is asked for.
  std::vector<Criterion::Aspect> aspects() const
  {
    using Aspect = Criterion::Aspect;
    if (query_.criterion.aspect == Aspect::BOTH)
      return { Aspect::BOTH, Aspect::OWN, Aspect::OTHER };
    return { Aspect::OWN, Aspect::OTHER };
  }

  std::vector<PavingQuery> queries() const
  {
    std::vector<PavingQuery> queries;
    for (const Criterion::Aspect aspect : aspects())
    {
      PavingQuery query = query_;
      query.criterion.aspect = aspect;
      const std::size_t shares = aspects().size() + (components_ ? Components::BYTES_A_BOX : 0);
      const auto turns = static_cast<double>(aspects().size()) + paved_.mesh.count();
      query.budget = query_.budget.inTurns(turns).sharedBy(shares);
      queries.push_back(query);
    }
    return queries;
  }

  PavingReport run(PavingQuery query, const Paving* earlier, const VolumeQuery& wanted) const
  {
    Progress progress = caller().progress(progress_);
    const Machine& machine = machine_.machine();
    const Measure measure(query.box ? *query.box : defaultBox(machine, query.criterion));
    query.progress = [&progress, &measure](const PavingProgress& state) {
      progress.tell(measure.name + " inside " + nearly(state.volume_inside) + measure.unit + ", undecided " +
                    nearly(state.volume_boundary) + measure.unit + ", " + std::to_string(state.boxes) + " boxes, " +
                    nearly(state.boxesPerSecond(), 3) + " boxes/s");
    };
    return reportPaving(machine, query, earlier, wanted);
  }

  /// The first that was.
  static std::string endedBy(const std::vector<PavingReport>& reports)
  {
    for (const PavingReport& report : reports)
      if (!report.ended_by.empty())
        return report.ended_by;
    return "";
  }

  MachineOptions machine_;
  PavingQuery query_;
  std::optional<double> resolution_;
  double volume_to_ = 1.0;
  bool components_ = false;
  bool progress_ = false;
  std::string save_;
  CertificateOption certificate_;
  std::string resume_;
  std::int64_t list_boxes_ = 0;
  Paved paved_;
};
}  // namespace

std::unique_ptr<Command> makePave()
{
  return std::make_unique<Pave>();
}
}  // namespace cli
}  // namespace pkm_workspace
