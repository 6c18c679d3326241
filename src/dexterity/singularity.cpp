// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/singularity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pkm_workspace/common/branch_and_bound.h"
#include "pkm_workspace/common/parallel.h"
#include "pkm_workspace/dexterity/sphere_crossing.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"
#include "pkm_workspace/dexterity/zero_between.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;
using Form = AffineForm<double>;
using Spheres = std::vector<StrutSphere>;

/// The measures: eta_i^2 for i = 0, 1, 2, then det A.
constexpr std::size_t PARALLEL = 3;
constexpr double FINE = 1e-6;  ///< size of the box around a singularity that is looked for, in struts
/// How much larger, on each side, a box is made to find a zero on its faces: share of its widths.
constexpr double MARGIN = 0.125;

Criterion criterionOf(const SingularityQuery& query)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = query.aspect;
  criterion.joint_limits = query.joint_limits;
  return criterion;
}

/// The model whose limits hold where a point counts for certain; nothing where none does.
std::optional<MachineModel<double>> sureModel(const Machine& machine, const Criterion& criterion,
                                              const SingularityQuery& query)
{
  Machine::Legs legs = machine.legs();
  for (std::size_t i = 0; query.surely_within && i < 3; ++i)
  {
    legs[i].limits = (*query.surely_within)[i];
    if (legs[i].limits.isEmpty())
      return std::nullopt;
  }
  return MachineModel<double>(Machine(machine.name(), legs, machine.zero()), criterion);
}

bool isJointLimit(ConditionKind kind)
{
  return kind == ConditionKind::JOINT_LOWER || kind == ConditionKind::JOINT_UPPER;
}

/// One look at a box as a whole: visits what points that may count satisfy, but for the sign of the measure.
struct Look
{
  bool empty;    ///< no point of it counts
  bool inside;   ///< every point counts, up to the sign of the measure
  Form measure;  ///< [m^2] or [m^3]; valid where all struts reach
  std::size_t which;

  bool isMeasure(const Subject& subject) const
  {
    return which == PARALLEL ? subject.kind == ConditionKind::ASPECT
                             : subject.kind == ConditionKind::REACH && subject.leg == which;
  }
  void require(const Form& form) { inside = inside && form.lower() >= 0.0; }
  void scalar(const Subject& subject, const Form& form, int /*power*/)
  {
    empty = empty || form.upper() < 0.0;
    if (!isMeasure(subject) && !isJointLimit(subject.kind))
      require(form);
  }
};

/// The same look at the limits within which points count for certain.
struct SureLook
{
  Look& look;

  void scalar(const Subject& /*subject*/, const Form& form, int /*power*/) { look.require(form); }
};

/// The least value of one measure, by branch and bound.
class LeastMeasure : public BranchingDefaults
{
public:
  /// @param sure see sureModel() @param spheres where det A is zero, too, maybe without changing its sign
  LeastMeasure(const MachineModel<double>& model, const std::optional<MachineModel<double>>& sure,
               const SingularityQuery& query, std::size_t measure, const Spheres& spheres)
    : model_(model)
    , sure_(sure)
    , query_(query)
    , measure_(measure)
    , spheres_(spheres)
    , two_sided_(measure == PARALLEL && !model.condition<AspectSign>().isAsked())
    , budget_(query.budget)
  {}

  SingularityAnswer run(const Box& root)
  {
    root_ = root;
    if (root.isValid())
      visit({ root, 0.0, 0 });
    answer_.out_of_memory = branchAndBound(open_, *this, budget_) == Ending::MEMORY;
    conclude();
    return answer_;
  }

  struct Node
  {
    Box box;
    double bound;        ///< of the measure from below
    std::int64_t order;  ///< of those with the same bound the oldest first, which is the largest

    bool operator<(const Node& other) const { return bound != other.bound ? bound > other.bound : order > other.order; }
  };

  bool isSettled() const { return answer_.box || open_.first().bound >= least_seen_ * (1.0 - query_.accuracy); }
  bool isDivisible(const Node& node) const { return node.box.canBisect(node.box.widestAxis()); }
  std::int64_t looks() const { return answer_.boxes; }
  /// Of all measures at a time. The open nodes copy themselves into twice the room where they grow.
  std::size_t bytes(std::size_t open) const { return (PARALLEL + 1) * 3 * sizeof(Node) * (open + 1); }

  bool expand(const std::vector<Node>& wave)
  {
    for (const Node& node : wave)
    {
      const auto halves = node.box.bisect(node.box.widestAxis());
      visit({ halves.first, node.bound, 0 });
      visit({ halves.second, node.bound, 0 });
    }
    return true;
  }

private:
  Look look(const Box& box) const
  {
    const CenteredBox<double> centered(box);
    const MachineForms<double> forms = model_.legs().evaluate(centered);
    const BoxVerdict part = query_.part ? query_.part(box) : BoxVerdict::INSIDE;
    Look look{ part == BoxVerdict::OUTSIDE, sure_ && part == BoxVerdict::INSIDE,
               measure_ == PARALLEL ? model_.condition<AspectSign>().form(forms) : forms.legs[measure_].squared_drive,
               measure_ };
    model_.visitScalars(forms, centered, look);
    SureLook sure_look{ look };
    if (sure_)
      sure_->condition<JointLimits>().visit(Place<double, CenteredBox<double>>{ sure_->legs(), forms, centered },
                                            sure_look);
    return look;
  }

  void visit(Node node)
  {
    const Look seen = look(node.box);
    node.order = ++answer_.boxes;
    if (seen.empty)
      return;
    node.bound =
        std::max(node.bound, two_sided_ ? std::max(seen.measure.lower(), -seen.measure.upper()) : seen.measure.lower());
    if (node.bound > least_seen_)
      return;
    const auto corners = endsAlong(node.box, seen.measure);
    tryPoint(node.box.center());
    tryPoint(two_sided_ && seen.measure.center < 0.0 ? corners.second : corners.first);
    if (seen.inside && node.bound <= 0.0)
      answer_.box = zeroIn(node.box, corners);
    open_.put(node);
  }

  /// A small box around a zero of the measure in a box that is inside. Bisection may have cut along the zeros, so that
  /// each box has one sign only: a box that is a little larger shows both.
  std::optional<Box> zeroIn(const Box& box, const std::pair<Vector3d, Vector3d>& corners) const
  {
    if (const auto zero = crossing(corners))
      return zero;
    if (const auto zero = sphereIn(box))
      return zero;
    const Vector3d margin = MARGIN * (box.upper - box.lower);
    const Box larger = intersection({ box.lower - margin, box.upper + margin }, root_);
    const Look seen = look(larger);
    return seen.inside ? crossing(endsAlong(larger, seen.measure)) : std::nullopt;
  }

  /// The same on a sphere where two struts are one.
  std::optional<Box> sphereIn(const Box& box) const
  {
    SphereCrossing crossing(spheres_);
    for (const StrutSphere& sphere : spheres_)
    {
      const auto ends = endsAlong(box, sphere.excess(CenteredBox<double>(box)));
      crossing.add(ends.first);
      if (const auto zero = crossing.add(ends.second))
        return intersection(zero->box(), box);
    }
    return std::nullopt;
  }

  /// The corners of the box at which the linear part of the form is least and largest.
  static std::pair<Vector3d, Vector3d> endsAlong(const Box& box, const Form& form)
  {
    std::pair<Vector3d, Vector3d> ends(box.lower, box.upper);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (form.gradient[axis] < 0.0)
        std::swap(ends.first[static_cast<int>(axis)], ends.second[static_cast<int>(axis)]);
    return ends;
  }

  /// Bounds the least value from above by a point that is proved to count.
  void tryPoint(const Vector3d& point)
  {
    const Look seen = look({ point, point });
    if (!seen.inside || seen.empty)
      return;
    const double upper = two_sided_ ? std::max(seen.measure.upper(), -seen.measure.lower()) : seen.measure.upper();
    if (two_sided_ || seen.measure.lower() >= 0.0)
      least_seen_ = std::min(least_seen_, upper);
  }

  /// A small box around a zero of the measure between the two points, where its signs there prove one.
  /// @pre a box around both is inside
  std::optional<Box> crossing(const std::pair<Vector3d, Vector3d>& ends) const
  {
    Vector3d low = ends.first;
    Vector3d high = ends.second;
    const auto at = [this](const Vector3d& point) { return look({ point, point }).measure; };
    if (!(at(low).upper() <= 0.0 && at(high).lower() >= 0.0))
      return std::nullopt;
    narrowZero(low, high, FINE * std::sqrt(model_.legs().squaredScale()), [&at](const Vector3d& point) {
      const Form value = at(point);
      return value.upper() <= 0.0 ? -1 : value.lower() >= 0.0 ? 1 : 0;
    });
    return Box{ low.cwiseMin(high), low.cwiseMax(high) };
  }

  void conclude()
  {
    using Status = SingularityAnswer::Status;
    const double bound = open_.isEmpty() ? least_seen_ : std::min(open_.first().bound, least_seen_);
    answer_.status = answer_.box ? Status::PROVED : bound > 0.0 ? Status::NONE : Status::UNDECIDED;
    answer_.least = answer_.box ? Interval(0.0) : bound < INF ? Interval(bound, least_seen_) : Interval::empty();
    if (measure_ != PARALLEL && !answer_.least.isEmpty())
      answer_.least =
          least_seen_ < INF || answer_.box ? sqrt(answer_.least) : Interval(sqrt(Interval(bound)).lower(), INF);
  }

  const MachineModel<double>& model_;
  const std::optional<MachineModel<double>>& sure_;
  const SingularityQuery& query_;
  const std::size_t measure_;
  const std::vector<StrutSphere> spheres_;
  const bool two_sided_;
  const RunningBudget budget_;
  Box root_;
  BestFirst<Node> open_;
  double least_seen_ = INF;
  SingularityAnswer answer_;
};
}  // namespace

void SingularityQuery::validate(Problems& problems) const
{
  validateShare("accuracy", accuracy, "(relative)", problems);
  budget.validate(problems);
  if (box)
    validateBox("box", *box, problems);
  if (surely_within && !joint_limits)
    problems.push_back("surely_within needs joint_limits");
}

Singularities findSingularities(const Machine& machine, const SingularityQuery& query)
{
  validated(query);
  const RunningBudget budget(query.budget);
  const Criterion criterion = criterionOf(query);
  const MachineModel<double> model(machine, criterion);
  const std::optional<MachineModel<double>> sure = sureModel(machine, criterion, query);
  const Box root = query.box ? *query.box : workspaceBounds(machine, criterion);
  Singularities result;
  const Spheres spheres = strutSpheres(machine);
  ThreadPool pool(query.budget.threads, 0.0);
  pool.forEach(PARALLEL + 1, [&](std::size_t measure) {
    SingularityAnswer& answer = measure == PARALLEL ? result.parallel : result.serial[measure];
    answer = LeastMeasure(model, sure, query, measure, measure == PARALLEL ? spheres : Spheres()).run(root);
  });
  result.seconds = budget.seconds();
  return result;
}
}  // namespace pkm_workspace
