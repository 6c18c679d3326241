// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/paper_search.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "pkm_workspace/interval/text_stream.h"

namespace pkm_workspace
{
namespace
{
/// The list L of section 2.4: the open boxes, the one in front being B_i; processed boxes are gone.
///
/// A repair: a box that is narrow waits until the others are done. Near the border of the good centers the second
/// storage mode would else follow one box down to the precision of doubles.
class BoxList
{
public:
  BoxList(const Box& first, std::int64_t capacity, double narrow)
    : boxes_{ first }, capacity_(capacity), narrow_(narrow)
  {}

  bool isEmpty() const { return boxes_.empty() && waiting_.empty(); }
  std::int64_t size() const { return static_cast<std::int64_t>(boxes_.size() + waiting_.size()); }

  /// @param w where it has not grown since the last time, waiting boxes can only be decided by bisecting them
  Box takeFront(double w)
  {
    if (boxes_.empty())
    {
      narrow_ = w > last_w_ ? narrow_ : narrow_ / 4;
      last_w_ = w;
      boxes_.swap(waiting_);
    }
    const Box box = boxes_.front();
    boxes_.pop_front();
    return box;
  }

  /// Keeps the box that was in front as it is.
  void keep(const Box& box) { waiting_.push_back(box); }

  /// Step 6: stores the halves of the box that was in front at the end while the list is short, else in its place.
  void storeHalves(const Box& box)
  {
    const int axis = box.widestAxis();
    if (box.width(axis) < narrow_)
      return keep(box);
    const auto halves = box.bisect(axis);
    boxes_.insert(2 * size() < capacity_ ? boxes_.end() : boxes_.begin(), { halves.first, halves.second });
  }

private:
  std::deque<Box> boxes_;
  std::deque<Box> waiting_;
  std::int64_t capacity_;
  double narrow_;
  double last_w_ = 0.0;
};

/// One run of the algorithm; the numbers of the steps are the paper's.
class PaperSearch
{
public:
  PaperSearch(const BoxClassifier& classify, const PaperQuery& query)
    : query_(query), classify_([this, &classify](const Box& box) {
      ++result_.looks;
      return classify(box);
    })
  {
    limits_.center_width = query.accuracy / 64;
    limits_.max_centers = 1;  // the list bisects the centers, G need not
    limits_.part_width = query.accuracy / 4096;
  }

  PaperResult run()
  {
    const bool is_incremental = query_.start_size > 0.0 && fits(query_.start, query_.start_size);
    improve(query_.start, is_incremental ? query_.start_size : 0.0, 0);  // 1
    BoxList list(query_.centers, query_.list_size, query_.accuracy / 4);
    while (!list.isEmpty())  // 2
    {
      if (result_.boxes == query_.max_boxes)
        return endedBy(PaperResult::Ending::BUDGET);
      ++result_.boxes;
      const Box box = list.takeFront(result_.size);
      const Share good = checkCenters(classify_, box, edges(stepped(result_.size, 1)), limits_);
      if (good == Share::NONE)  // 3
        continue;
      if (good == Share::ALL)  // 4
        improve(box.center(), result_.size, 1);
      if (box.canBisect(box.widestAxis()))
        list.storeHalves(box);  // 5, 6
      else if (good == Share::ALL)
        list.keep(box);  // a single center: w has grown
      else
        return endedBy(PaperResult::Ending::PRECISION);
      result_.longest_list = std::max(result_.longest_list, list.size());
    }
    result_.size_upper_bound = stepped(result_.size, 1);
    return endedBy(PaperResult::Ending::EXHAUSTED);
  }

private:
  /// size + k alpha, rounded down: it grows with size, so boxes that w + alpha has discarded stay discarded.
  double stepped(double size, std::int64_t k) const
  {
    return (Interval(size) + Interval(static_cast<double>(k)) * Interval(query_.accuracy)).lower();
  }

  Eigen::Vector3d edges(double size) const
  {
    return { size, size, query_.shape == PaperQuery::Shape::CUBE ? size : 0.0 };
  }

  PaperResult endedBy(PaperResult::Ending ending)
  {
    result_.ending = ending;
    return result_;
  }

  /// Containment (a repair: C needs this, not M = -1).
  bool fits(const Eigen::Vector3d& center, double size) const
  {
    return checkCenters(classify_, { center, center }, edges(size), limits_) == Share::ALL;
  }

  /// w = max(w, C(x, y, z)): doubles and then bisects k while the region of edge base + k alpha fits.
  /// @param good a k for which it is known to fit
  void improve(const Eigen::Vector3d& center, double base, std::int64_t good)
  {
    std::int64_t fail = std::max<std::int64_t>(1, 2 * good);
    while (fail < MAX_MULTIPLE && fits(center, stepped(base, fail)))
    {
      good = fail;
      fail *= 2;
    }
    while (fail > good + 1)
    {
      const std::int64_t middle = (good + fail) / 2;
      (fits(center, stepped(base, middle)) ? good : fail) = middle;
    }
    const double size = stepped(base, good);
    if (size > result_.size)
    {
      result_.size = size;
      result_.center = center;
    }
  }

  static constexpr std::int64_t MAX_MULTIPLE = std::int64_t(1) << 50;

  const PaperQuery& query_;
  const BoxClassifier classify_;
  BisectionLimits limits_;
  PaperResult result_;
};

void refuseUnless(bool holds, const char* name, double value, const char* allowed, Problems& problems)
{
  TextStream text;
  text << name << " = " << value << ' ' << allowed;
  if (!holds)
    problems.push_back(text.str());
}
}  // namespace

void PaperQuery::validate(Problems& problems) const
{
  validatePositive("accuracy", accuracy, "m", problems);
  validateBox("box of centers", centers, problems);
  for (int axis = 0; axis < 3; ++axis)
    refuseUnless(centers.lower[axis] <= start[axis] && start[axis] <= centers.upper[axis], "start", start[axis],
                 "m must lie in the box of centers", problems);
  refuseUnless(start_size >= 0.0 && std::isfinite(start_size), "start size", start_size,
               "m must be 0 or positive, and finite", problems);
  validatePositive("list size", static_cast<double>(list_size), "boxes", problems);
  validatePositive("max_boxes", static_cast<double>(max_boxes), "boxes", problems);
}

PaperResult findLargestByPaper(const BoxClassifier& classify, const PaperQuery& query)
{
  return PaperSearch(classify, validated(query)).run();
}
}  // namespace pkm_workspace
