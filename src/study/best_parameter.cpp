// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/study/best_parameter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/region/center_search.h"
#include "pkm_workspace/region/region_height.h"

namespace pkm_workspace
{
namespace
{
/// Boxes of centers for one look at a part before it is rather divided: so many more with each division. A machine that
/// takes many by itself, as one with cranks does, has parts that take as many: then this share of them.
constexpr std::int64_t LOOK = 64;
constexpr std::int64_t LOOK_SHARE = 4;
constexpr std::int64_t MOST_LOOK = 1 << 15;
/// Boxes that proofs of regions of one machine may take, and those of regions that all machines of a part have in
/// common: so many more with each division.
constexpr std::int64_t VERIFICATION = 64000;
constexpr std::int64_t COMMON_VERIFICATION = 512;
/// Bad points of earlier looks that are tried in the next ones: the latest.
constexpr std::size_t SUSPECTS = 16;
/// Regions are looked for to this share of the accuracy; the other part is for the parameters in between.
constexpr double SHARE = 0.5;
/// Machines at equal distances that are tried first, and how often the distance from the best is then halved.
constexpr int STARTS = 16;
constexpr int HALVINGS = 24;
/// Parts narrower than this, relative to the largest parameter, are not divided further: the last look takes so many
/// times the boxes of the first.
constexpr double LEAST_WIDTH = 1e-14;
constexpr std::int64_t LAST_LOOK = 512;

/// Branch and bound over the parameters.
class ParameterSearch : public BranchingDefaults
{
public:
  explicit ParameterSearch(const StudyQuery& query) : query_(query), budget_(query.region.budget)
  {
    best_.region.shape = query.region.shape;
  }

  BestParameter run()
  {
    climb();
    measureLook();
    open_.put({ query_.range, INF });
    in_hand_ = 0.0;
    branchAndBound(open_, *this, budget_);
    return result();
  }

  struct Part
  {
    Interval parameters;
    double bound;       ///< certified: no machine of the part has a larger region
    int divisions = 0;  ///< of the range
    bool operator<(const Part& other) const
    {
      return bound < other.bound || (bound == other.bound && parameters.width() < other.parameters.width());
    }
  };

  std::int64_t looks() const { return best_.region.boxes; }
  bool isSettled() const { return open_.first().bound <= target(); }
  /// Parts of the range may take their half of the memory; the search that is going on has the other one. Open nodes
  /// copy themselves into twice the room where they grow.
  std::size_t bytes(std::size_t open) const { return 2 * 3 * sizeof(Part) * (open + closed_.size() + 2); }

  bool expand(const std::vector<Part>& wave)
  {
    for (const Part& part : wave)
      settle(part);
    return true;
  }

  void tellProgress()
  {
    const double now = query_.progress ? budget_.seconds() : 0.0;
    if (!query_.progress || !pace_.isDue(now))
      return;
    bracket_.narrow(best_.region.size, upperBound());
    query_.progress({ bracket_.lower(), best_.parameter, bracket_.upper(), open_.size(), now });
  }

private:
  struct Effort
  {
    std::int64_t boxes;               ///< of centers
    std::int64_t verification_boxes;  ///< for proofs of regions
  };

  double target() const { return rounding::add(best_.region.size, query_.region.accuracy).lower; }
  bool isOver() const { return budget_.isOver(best_.region.boxes) || isFull(); }

  bool isFull() const { return budget_.isFull(bytes(open_.size())); }
  /// Looks for regions larger than a size with what is left of the budget; one that is the largest so far is kept,
  /// with the parameter given. @return the certified upper bound
  double search(const Machine& machine, double parameter, double known, Effort effort)
  {
    RegionQuery query = query_.region;
    query.accuracy *= SHARE;
    query.progress = nullptr;
    query.closed = nullptr;
    query.budget = budget_.rest(best_.region.boxes).sharedBy(2);
    query.budget.threads = 1;  // threads would be started anew for each of these short searches
    query.budget.max_boxes = query.budget.max_boxes > 0 ? std::min(effort.boxes, query.budget.max_boxes) : effort.boxes;
    CenterSearch search(machine, query, std::max(0.0, known), effort.verification_boxes);
    search.suspect(suspects_);
    const LargestRegion found = search.run();
    remember(search.badPoints());
    best_.region.boxes += found.boxes;
    best_.region.verification_boxes += found.verification_boxes;
    if (found.size > best_.region.size)
    {
      best_.parameter = parameter;
      best_.region.size = found.size;
      best_.region.center = found.center;
    }
    return found.size_upper_bound;
  }

  /// What is bad for a machine is often bad for its neighbours.
  void remember(const std::vector<Eigen::Vector3d>& bad_points)
  {
    for (const Eigen::Vector3d& point : bad_points)
      if (std::find(suspects_.begin(), suspects_.end(), point) == suspects_.end())
        suspects_.push_back(point);
    if (suspects_.size() > SUSPECTS)
      suspects_.erase(suspects_.begin(), suspects_.end() - SUSPECTS);
  }

  void lookAtMachine(double parameter, int divisions = 0)
  {
    search(query_.family.at(Interval(parameter)), parameter, best_.region.size,
           { LOOK, VERIFICATION * (1 + divisions) });
    tellProgress();
  }

  /// A good machine first makes all proofs short (docs/theory.md, the largest region). Both ends are among those tried,
  /// so that a range beyond the family is refused.
  void climb()
  {
    const double lower = query_.range.lower();
    const double upper = query_.range.upper();
    best_.parameter = lower;
    query_.family.at(query_.range.lower());
    query_.family.at(query_.range.upper());
    for (int k = 0; k <= STARTS && !isOver(); ++k)
      lookAtMachine(k == STARTS ? upper : lower + k * ((upper - lower) / STARTS));
    double distance = (upper - lower) / STARTS;
    for (int k = 0; k < HALVINGS && !isOver(); ++k)
    {
      distance *= 0.5;
      const double center = best_.parameter;
      for (const double parameter : { center - distance, center + distance })
        if (query_.range.contains(parameter))
          lookAtMachine(parameter);
    }
  }

  /// By what the best machine takes to be settled.
  void measureLook()
  {
    const std::int64_t before = best_.region.boxes;
    if (!isOver())
      search(query_.family.at(Interval(best_.parameter)), best_.parameter,
             best_.region.size - SHARE * query_.region.accuracy, { MOST_LOOK, VERIFICATION });
    look_ = std::max(LOOK, (best_.region.boxes - before) / LOOK_SHARE);
  }

  /// Nothing where the machines of the part have too little in common to be told as one.
  std::optional<Machine> machineOf(const Interval& parameters) const
  {
    try
    {
      return query_.family.at(parameters);
    }
    catch (const std::invalid_argument&)
    {
      return std::nullopt;
    }
  }

  bool isNarrow(const Interval& parameters) const
  {
    return parameters.width() <= LEAST_WIDTH * query_.range.magnitude();
  }

  /// Lowers the bound to the best size if it can, otherwise to the middle between the two if it can.
  double boundOf(const Part& part)
  {
    const auto machine = machineOf(part.parameters);
    if (!machine)
      return part.bound;
    const double middle = part.parameters.mid();
    const double below = SHARE * query_.region.accuracy;
    const double size = best_.region.size;
    const std::int64_t times = isNarrow(part.parameters) ? LAST_LOOK : 1 + part.divisions;
    const Effort effort{ look_ * times, COMMON_VERIFICATION * times };
    double bound = part.bound;
    try
    {
      bound = std::min(bound, search(*machine, middle, size - below, effort));
      if (bound > size && !isOver())
        bound = std::min(bound, search(*machine, middle, 0.5 * (size + bound) - below, effort));
    }
    catch (const std::invalid_argument&)
    {
      // together they have no bounds; parts of them may
    }
    catch (const std::domain_error&)
    {
      // nor axes across a plane
    }
    return bound;
  }

  void settle(const Part& part)
  {
    in_hand_ = part.bound;
    const double bound = boundOf(part);
    if (bound <= target() || isNarrow(part.parameters))
    {
      closed_.push_back({ part.parameters, bound });
      in_hand_ = 0.0;
      return;
    }
    const double middle = part.parameters.mid();
    if (!isOver())
      lookAtMachine(middle, part.divisions);
    open_.put({ { part.parameters.lower(), middle }, bound, part.divisions + 1 });
    open_.put({ { middle, part.parameters.upper() }, bound, part.divisions + 1 });
    in_hand_ = 0.0;
  }

  double upperBound() const
  {
    double bound = open_.isEmpty() ? 0.0 : open_.first().bound;
    for (const Part& part : closed_)
      bound = std::max(bound, part.bound);
    return std::max({ bound, in_hand_, best_.region.size });
  }

  BestParameter result()
  {
    bracket_.narrow(best_.region.size, upperBound());
    best_.region.size_upper_bound = bracket_.upper();
    best_.region.seconds = budget_.seconds();
    best_.region.out_of_memory = isFull();
    conclude(best_.region, query_.region.accuracy, budget_.endedBy(best_.region.boxes, best_.region.out_of_memory),
             false);
    while (!open_.isEmpty())
      closed_.push_back(open_.take());
    std::sort(closed_.begin(), closed_.end(),
              [](const Part& a, const Part& b) { return a.parameters.lower() < b.parameters.lower(); });
    for (const Part& part : closed_)
      addCandidate({ part.parameters, part.bound });
    best_.range = query_.range;
    if (best_.region.size > 0.0)
      settleHeight(query_.family.at(Interval(best_.parameter)), query_.region, budget_, best_.region);
    return best_;
  }

  void addCandidate(const StudyPart& part)
  {
    if (part.size_upper_bound <= best_.region.size)
      return;
    std::vector<StudyPart>& candidates = best_.candidates;
    if (candidates.empty() || candidates.back().parameters.upper() < part.parameters.lower())
      candidates.push_back(part);
    StudyPart& last = candidates.back();
    last.parameters = hull(last.parameters, part.parameters);
    last.size_upper_bound = std::max(last.size_upper_bound, part.size_upper_bound);
  }

  const StudyQuery& query_;
  const RunningBudget budget_;
  RunningBracket bracket_;  ///< of the size
  BestFirst<Part> open_;
  std::vector<Part> closed_;
  std::int64_t look_ = LOOK;
  double in_hand_ = INF;  ///< bound of the parameters that are in work
  std::vector<Eigen::Vector3d> suspects_;
  BestParameter best_;
  Pace pace_{ query_.progress_period };
};
}  // namespace

BestParameter findBestParameter(const StudyQuery& query)
{
  return ParameterSearch(validated(query)).run();
}
}  // namespace pkm_workspace
