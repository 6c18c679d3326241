// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/tasks/connection.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/paving/components.h"
#include "pkm_workspace/region/path_check.h"
#include "pkm_workspace/report/connection_sentence.h"
#include "pkm_workspace/report/point_sentence.h"
#include "pkm_workspace/report/set_reach.h"
#include "pkm_workspace/tasks/paving.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

/// Boxes next to a point at the border that it is tried to get to on a straight line.
constexpr std::size_t MOST_TRIED = 12;
/// Pieces of a line looked at before a longer path is taken instead.
constexpr std::int64_t MOST_LOOKS = 2000;

/// What a box of the tree takes, with that of its components, over what it takes by itself.
constexpr std::size_t MEMORY_SHARES = 1 + Components::BYTES_A_BOX;

/// One end of the question.
struct End
{
  Points way;  ///< from the point to the box of a component: lines that are proved; the point alone at first
  std::optional<std::size_t> component;

  const Vector3d& inner() const { return way.back(); }
};

class Connector
{
public:
  Connector(const Machine& machine, const ConnectionTask& task)
    : machine_(machine), task_(task), evaluator_(machine, task.query.criterion), budget_(task.query.budget)
  {
    lines_.max_looks = MOST_LOOKS;
    lines_.stop = task.query.budget.stop;
  }

  ConnectionReport run()
  {
    for (const Vector3d& point : { task_.from, task_.to })
    {
      const PointEvaluation there = evaluator_(point);
      if (there.verdict == BoxVerdict::OUTSIDE)
      {
        report_.verdict = Verdict::OUTSIDE;
        report_.bad_point = point;
        report_.message = describe(there, evaluator_);
        return std::move(report_);
      }
      are_good_ = are_good_ && there.verdict == BoxVerdict::INSIDE;
    }
    refine();
    report_.message = message();
    report_.seconds = budget_.seconds();
    return std::move(report_);
  }

private:
  using Verdict = ConnectionReport::Verdict;

  void refine()
  {
    PavingQuery query = task_.query;
    const double first = defaultResolution(machine_, query);
    const double least = task_.resolution.value_or(std::ldexp(first, -ConnectionTask::MOST_HALVINGS));
    query.resolution = std::max(least, first);
    for (bool goes_on = true; goes_on; query.resolution = std::max(least, 0.5 * query.resolution))
    {
      query.budget = budget_.rest(report_.paving.boxes).sharedBy(MEMORY_SHARES);
      Paving& paving = report_.paving;
      paving = paving.tree.levels() > 0 ? resume(machine_, query, paving) : pave(machine_, query);
      settle();
      goes_on = report_.verdict == Verdict::OPEN && query.resolution > least && paving.complete &&
                !budget_.isOver(paving.boxes);
    }
  }

  std::string message() const
  {
    const Criterion& criterion = task_.query.criterion;
    const Paving& paving = report_.paving;
    switch (report_.verdict)
    {
      case Verdict::CONNECTED:
        return connectedSentence(report_.path.size() - 1, machine_, criterion);
      case Verdict::APART:
        return apartSentence(is_whole_, machine_, criterion);
      default:
        return openSentence(paving.resolution, budget_.endedBy(paving.boxes, !paving.complete));
    }
  }

  void settle()
  {
    is_section_ = isSectionOfAll(machine_, report_.paving);
    is_whole_ = is_section_ || !task_.query.box;
    const Components components(report_.paving.tree, [this] { return budget_.isOver(); });
    if (!components.complete())
      return;
    End from = endAt(task_.from, components);
    End to = endAt(task_.to, components);
    if (from.component && from.component == to.component)
      join(from, to, components);
    else if (are_good_ && isInSection(from) && isInSection(to) && components.areApart(anchor(from), anchor(to)))
      report_.verdict = Verdict::APART;
  }

  /// The point of the paved box that stands for an end: what moved it there along the rails is proved.
  const Vector3d& anchor(const End& end) const { return is_section_ ? end.way[1] : end.way[0]; }
  bool isInSection(const End& end) const { return !is_section_ || end.way.size() > 1; }

  End endAt(const Vector3d& point, const Components& components) const
  {
    End end{ { point }, std::nullopt };
    if (is_section_)
    {
      const Vector3d moved = movedToSection(point);
      if (!isLineGood(point, moved))
        return end;
      end.way.push_back(moved);
    }
    end.component = components.at(end.inner());
    for (const Box& box : end.component ? std::vector<Box>() : components.nearest(end.inner(), MOST_TRIED))
    {
      const Vector3d inner = box.center();
      if (!isLineGood(end.inner(), inner))
        continue;
      end.way.push_back(inner);
      end.component = components.at(inner);
      break;
    }
    return end;
  }

  /// Along the rails, or nearly so: the line to it is proved by itself.
  Vector3d movedToSection(const Vector3d& point) const
  {
    const int axis = mainAxisOfRails(machine_);
    const Vector3d along = mid(directionOfRails(machine_));
    Vector3d moved = point + (report_.paving.box.lower[axis] - point[axis]) / along[axis] * along;
    moved[axis] = report_.paving.box.lower[axis];
    return moved;
  }

  bool isLineGood(const Vector3d& a, const Vector3d& b) const
  {
    return checkPath(evaluator_, { PathSegment::line(a, b) }, lines_).verdict == Containment::INSIDE;
  }

  void join(const End& from, const End& to, const Components& components)
  {
    Points path = from.way;
    const Points between = components.path(from.inner(), to.inner());
    path.insert(path.end(), between.begin() + 1, between.end());
    path.insert(path.end(), to.way.rbegin() + (between.size() > 1 ? 1 : 0), to.way.rend());
    report_.path = shortened(path);
    report_.verdict = Verdict::CONNECTED;
  }

  /// Leaves out corners where the straight line past them is proved as well.
  Points shortened(const Points& path) const
  {
    Points result = { path.front() };
    for (std::size_t at = 0; at + 1 < path.size();)
    {
      std::size_t next = path.size() - 1;
      while (next > at + 1 && !isLineGood(path[at], path[next]))
        next = at + std::max<std::size_t>(1, (next - at) / 2);
      if (path[next] != result.back() || next + 1 == path.size())
        result.push_back(path[next]);
      at = next;
    }
    return result;
  }

  const Machine& machine_;
  const ConnectionTask& task_;
  PointEvaluator evaluator_;
  RunningBudget budget_;
  PathQuery lines_;
  bool are_good_ = true;     ///< both points, proved
  bool is_section_ = false;  ///< whether the paved box is one, along which nothing changes
  bool is_whole_ = false;    ///< whether all of the set is meant
  ConnectionReport report_;
};
}  // namespace

void ConnectionTask::validate(Problems& problems) const
{
  PavingQuery finest = query;
  finest.resolution = resolution.value_or(1.0);
  finest.validate(problems);
  for (const Vector3d& point : { from, to })
    if (query.box && !query.box->contains(point))
      complain(problems, "the point (", point.transpose(), ") m is not in the box; give a box with both points");
}

ConnectionReport connect(const Machine& machine, const ConnectionTask& task)
{
  Problems problems;
  task.validate(problems);
  throwProblems(problems);
  return Connector(machine, task).run();
}
}  // namespace pkm_workspace
