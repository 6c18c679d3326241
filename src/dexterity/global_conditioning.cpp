// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/global_conditioning.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/common/parallel.h"
#include "pkm_workspace/dexterity/partial_mean.h"
#include "pkm_workspace/interval/running_bracket.h"

namespace pkm_workspace
{
namespace
{
/// Boxes that are divided side by side.
constexpr std::size_t WAVE = 64;
/// How many more boxes there are each time the width is looked at.
constexpr double GROWTH = 1.2;

/// A box that belongs to the set as a whole, or of which an unknown part does.
struct Part
{
  Box box;
  Interval measure;
  Interval index;  ///< the mean over the box; of a part of it, the range
  bool whole;
  double uncertainty;  ///< what it adds to the width of the result, about
  bool operator<(const Part& other) const { return uncertainty < other.uncertainty; }
};

/// What a part may take: the vector of parts copies itself into twice the room where it grows, and one at the border is
/// told to the mean as well.
constexpr std::size_t PART_BYTES = 3 * sizeof(Part) + 3 * PartialMean::BORDER_BYTES;

/// The mean of the index, by dividing the parts that leave most of it open.
class Average : public BranchingDefaults
{
public:
  Average(const Machine& machine, const BoxClassifier& set, const ConditioningQuery& query)
    : model_(machine, everywhere()), set_(set), query_(query), pool_(query.budget.threads), budget_(query.budget)
  {}

  GlobalConditioning run(const Box& box)
  {
    result_.dimension = static_cast<int>((box.lower.array() < box.upper.array()).count());
    addAll({ box });
    sumUp();
    const Ending ending = branchAndBound(parts_, *this, budget_);
    if (ending == Ending::EXHAUSTED || ending == Ending::INDIVISIBLE)
      sumUp();
    result_.out_of_memory = ending == Ending::MEMORY;
    conclude();
    return result_;
  }

  std::int64_t looks() const { return result_.boxes; }
  static std::size_t bytes(std::size_t open) { return PART_BYTES * (open + std::min(WAVE, open)); }
  static bool isDivisible(const Part& part) { return part.box.canBisect(part.box.widestAxis()); }

  std::size_t waveSize()
  {
    if (parts_.size() >= next_look_)
    {
      sumUp();
      if (widthNearly() <= query_.accuracy)
        return 0;
      next_look_ = static_cast<std::size_t>(GROWTH * static_cast<double>(parts_.size()));
    }
    return WAVE;
  }

  bool expand(const std::vector<Part>& wave)
  {
    std::vector<Box> halves;
    for (const Part& part : wave)
    {
      const auto pair = part.box.bisect(part.box.widestAxis());
      halves.push_back(pair.first);
      halves.push_back(pair.second);
    }
    addAll(halves);
    return true;
  }

private:
  static Criterion everywhere()
  {
    Criterion criterion;
    criterion.set = Criterion::Set::REACHABLE;
    criterion.aspect = Criterion::Aspect::BOTH;
    return criterion;
  }

  void addAll(const std::vector<Box>& boxes)
  {
    std::vector<std::optional<Part>> found(boxes.size());
    pool_.forEach(boxes.size(), [&](std::size_t k) { found[k] = lookAt(boxes[k]); });
    result_.boxes += static_cast<std::int64_t>(boxes.size());
    for (const std::optional<Part>& part : found)
      if (part)
        parts_.put(*part);
  }

  /// Nothing for a box that does not belong to the set.
  std::optional<Part> lookAt(const Box& box) const
  {
    const BoxVerdict verdict = set_(box);
    if (verdict == BoxVerdict::OUTSIDE)
      return std::nullopt;
    const ConditioningBounds bounds = conditioningOver(model_, box);
    Part part{ box, box.measure(), bounds.mean, verdict == BoxVerdict::INSIDE, 0.0 };
    if (!part.whole)
      part.index = bounds.range;
    // a part at the border counts with how far its index may be from the mean
    part.uncertainty = part.measure.upper() * (part.whole ? part.index.width() : farFromMean(part.index));
    return part;
  }

  double farFromMean(const Interval& index) const
  {
    return std::max({ index.width(), std::abs(index.lower() - estimate_), std::abs(index.upper() - estimate_) });
  }

  /// The width of the result in floating point, as far as the parts' uncertainties tell it.
  double widthNearly()
  {
    double measure = 0.0;
    double sum = 0.0;
    double uncertainty = 0.0;
    for (const Part& part : parts_.all())
    {
      uncertainty += part.uncertainty;
      measure += part.whole ? part.measure.mid() : 0.0;
      sum += part.whole ? part.measure.mid() * part.index.mid() : 0.0;
    }
    estimate_ = measure > 0.0 ? sum / measure : 0.5;
    return measure > 0.0 ? uncertainty / measure : 1.0;
  }

  /// Takes what the parts tell into the brackets. Whatever ends the computation between two looks, the answer is that
  /// of the last one, which every longer computation has had too: brackets only get narrower.
  void sumUp()
  {
    PartialMean mean;
    for (const Part& part : parts_.all())
      part.whole ? mean.addWhole(part.measure, part.index) : mean.addBorder(part.measure, part.index);
    const Interval measure = mean.measure();
    const Interval index = mean.mean();
    measure_.narrow(measure.lower(), measure.upper());
    index_.narrow(index.lower(), index.upper());
  }

  void conclude()
  {
    result_.measure = { measure_.lower(), measure_.upper() };
    result_.index = { index_.lower(), index_.upper() };
    result_.complete = result_.index.width() <= query_.accuracy;
    result_.seconds = budget_.seconds();
  }

  MachineModel<double> model_;
  const BoxClassifier& set_;
  const ConditioningQuery& query_;
  ThreadPool pool_;
  const RunningBudget budget_;
  BestFirst<Part> parts_;      ///< the most uncertain first
  std::size_t next_look_ = 0;  ///< at the width: with so many parts
  double estimate_ = 0.5;
  RunningBracket measure_;
  RunningBracket index_{ 0.0, 1.0 };
  GlobalConditioning result_;
};
}  // namespace

void ConditioningQuery::validate(Problems& problems) const
{
  validateShare("accuracy", accuracy, "(a conditioning index, without unit)", problems);
  budget.validate(problems);
}

GlobalConditioning globalConditioning(const Machine& machine, const BoxClassifier& set, const Box& box,
                                      const ConditioningQuery& query)
{
  Problems problems;
  query.validate(problems);
  validateBox("box", box, problems);
  throwProblems(problems);
  return Average(machine, set, query).run(box);
}
}  // namespace pkm_workspace
