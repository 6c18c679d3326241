// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/set_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/common/parallel.h"

namespace pkm_workspace
{
namespace
{
/// Boxes that a thread takes at a time.
constexpr std::size_t LOOKED_TOGETHER = 64;
/// Boxes that are divided side by side: a share of those that are open, at least and at most so many.
constexpr std::size_t LEAST_WAVE = 64;
constexpr std::size_t LARGEST_WAVE = 4096;
constexpr std::size_t SHARE_OF_OPEN = 8;
/// Boxes are divided along all sides that are at least this share of the widest one.
constexpr double WIDE = 0.75;
/// More than sums in floating point may differ from what they stand for, relative.
constexpr double SUMMED_UP = 0x1p-20;
/// A box of which less than this share of its part is uncertain is not divided.
constexpr double NEGLIGIBLE = 1e-12;

/// A box of which the set takes a part between two volumes.
struct UncertainBox
{
  Box box;
  double lower;
  double upper;

  double uncertainty() const { return upper - lower; }
};

/// Open boxes, those first of which most is uncertain, up to a factor of 2; of those the latest first.
class UncertainFirst
{
public:
  using Node = UncertainBox;

  bool isEmpty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Node& first() const { return classes_.rbegin()->second.back(); }
  void put(const Node& node)
  {
    classes_[std::ilogb(node.uncertainty())].push_back(node);
    ++size_;
  }
  Node take()
  {
    const auto most = std::prev(classes_.end());
    const Node node = most->second.back();
    most->second.pop_back();
    if (most->second.empty())
      classes_.erase(most);
    --size_;
    return node;
  }
  template <class Take>
  void each(const Take& take) const
  {
    for (const auto& nodes : classes_)
      for (const Node& node : nodes.second)
        take(node);
  }

private:
  std::map<int, std::vector<Node>> classes_;
  std::size_t size_ = 0;
};

/// Divides the boxes that leave most of a volume open.
class VolumeSearch : public BranchingDefaults
{
public:
  VolumeSearch(const Machine& machine, const Paving& paving, const VolumeQuery& query)
    : test_(machine, paving.premises.criterion)
    , paving_(paving)
    , query_(query)
    , pool_(query.budget.threads)
    , budget_(query.budget)
    , pace_(query.progress_period)
    , settled_(paving.volume_inside)
  {}

  SetVolume run()
  {
    paving_.tree.each(CellState::PENDING, LARGEST_WAVE, [this](std::size_t /*level*/, const std::vector<Box>& boxes) {
      for (const Box& box : boxes)
        add(box, partOf(box.measure(), Interval(0.0, 1.0)));
    });
    paving_.tree.each(CellState::BOUNDARY, LARGEST_WAVE,
                      [this](std::size_t /*level*/, const std::vector<Box>& boxes) { addAll(boxes); });
    branchAndBound(open_, *this, budget_);
    SetVolume result;
    result.volume = sum();
    result.boxes = looks_;
    result.complete = result.volume.width() <= wantedWidth(result.volume.upper());
    result.seconds = budget_.seconds();
    return result;
  }

  std::int64_t looks() const { return looks_; }
  static std::size_t bytes(std::size_t open) { return 2 * sizeof(UncertainBox) * (open + 8 * LARGEST_WAVE); }
  static bool isDivisible(const UncertainBox& node) { return node.box.canBisect(node.box.widestAxis()); }

  std::size_t waveSize() const
  {
    if (width_ <= 0.999 * wantedWidth(settled_.lower() + lower_ + width_))
      return 0;
    return std::min(LARGEST_WAVE, std::max(LEAST_WAVE, open_.size() / SHARE_OF_OPEN));
  }

  void tellProgress()
  {
    if (!query_.progress || !pace_.isDue(budget_.seconds()))
      return;
    PavingProgress progress;
    progress.volume_inside = (1.0 - SUMMED_UP) * std::max(0.0, settled_.lower() + lower_);
    progress.volume_boundary = (1.0 + SUMMED_UP) * (settled_.width() + width_);
    progress.boxes = looks_;
    progress.seconds = budget_.seconds();
    query_.progress(progress);
  }

  bool expand(const std::vector<UncertainBox>& wave)
  {
    std::vector<Box> parts;
    parts.reserve(8 * wave.size());
    for (const UncertainBox& node : wave)
    {
      divide(node.box, parts);
      count(node, -1.0);
    }
    addAll(parts);
    return true;
  }

private:
  double wantedWidth(double upper) const { return std::max(query_.accuracy * upper, query_.width); }

  static void divide(const Box& box, std::vector<Box>& parts)
  {
    const std::size_t first = parts.size();
    const double widest = box.maxWidth();
    parts.push_back(box);
    for (int axis = 0; axis < 3; ++axis)
      if (box.width(axis) >= WIDE * widest && box.canBisect(axis))
        for (std::size_t k = parts.size(); k-- > first;)
        {
          const auto halves = parts[k].bisect(axis);
          parts[k] = halves.first;
          parts.push_back(halves.second);
        }
  }

  void addAll(const std::vector<Box>& boxes)
  {
    std::vector<Interval> shares(boxes.size());
    const std::size_t chunks = (boxes.size() + LOOKED_TOGETHER - 1) / LOOKED_TOGETHER;
    pool_.forEach(chunks, [&](std::size_t chunk) {
      const std::size_t first = chunk * LOOKED_TOGETHER;
      lookAt(&boxes[first], std::min(LOOKED_TOGETHER, boxes.size() - first), &shares[first]);
    });
    looks_ += static_cast<std::int64_t>(boxes.size());
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (shares[k].upper() > 0.0)
        add(boxes[k], partOf(boxes[k].measure(), shares[k]));
  }

  /// Nothing is known of boxes after the end of the time.
  void lookAt(const Box* boxes, std::size_t count, Interval* shares) const
  {
    if (budget_.isOver())
    {
      std::fill_n(shares, count, Interval(0.0, 1.0));
      return;
    }
    std::array<BoxCuts, LOOKED_TOGETHER> cuts;
    test_.kernel().cuts(boxes, count, cuts.data());
    for (std::size_t k = 0; k < count; ++k)
      shares[k] = cuts[k].violated ? Interval(0.0) : shareWithin(cuts[k].cut.data(), cuts[k].count);
  }

  void add(const Box& box, const Interval& part)
  {
    const UncertainBox node{ box, part.lower(), part.upper() };
    const bool is_divided = query_.accuracy < 1.0 && node.uncertainty() > NEGLIGIBLE * node.upper;
    if (!is_divided || budget_.isFull(bytes(open_.size())))
    {
      settled_ += part;
      return;
    }
    count(node, 1.0);
    open_.put(node);
  }

  /// In floating point.
  void count(const UncertainBox& node, double sign)
  {
    width_ += sign * node.uncertainty();
    lower_ += sign * node.lower;
  }

  Interval sum() const
  {
    Interval sum = settled_;
    open_.each([&sum](const UncertainBox& node) { sum += Interval(node.lower, node.upper); });
    const double most = paving_.volumeUpper();
    return { std::min(sum.lower(), most), std::min(sum.upper(), most) };
  }

  const BoxTest test_;
  const Paving& paving_;
  const VolumeQuery& query_;
  ThreadPool pool_;
  const RunningBudget budget_;
  Pace pace_;
  UncertainFirst open_;
  Interval settled_;    ///< the volume of what is known to be in the set
  double width_ = 0.0;  ///< of the rest, about
  double lower_ = 0.0;
  std::int64_t looks_ = 0;
};
}  // namespace

void VolumeQuery::validate(Problems& problems) const
{
  validateShare("accuracy", accuracy, "(relative)", problems);
  budget.validate(problems);
}

SetVolume setVolume(const Machine& machine, const Paving& paving, const VolumeQuery& query)
{
  return VolumeSearch(machine, paving, validated(query)).run();
}
}  // namespace pkm_workspace
