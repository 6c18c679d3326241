// SPDX-License-Identifier: BSD-3-Clause
// Why the search for the largest region closes a box of centers: what it tells must prove it to somebody who has
// nothing but the machine, the criterion and the body.
#include "pkm_workspace/region/reason.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <map>

#include "pkm_workspace/interval/centered_box.h"
#include "pkm_workspace/region/largest_region.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Number = long double;
using Vector = Eigen::Matrix<Number, 3, 1>;

struct ClosedBox
{
  Box centers;
  Reason reason;
};

std::vector<ClosedBox> closedBoxes(const Machine& machine, const Criterion& criterion, const ShapePtr& shape,
                                   double accuracy)
{
  std::vector<ClosedBox> closed;
  RegionQuery query;
  query.shape = shape;
  query.criterion = criterion;
  query.accuracy = accuracy;
  query.search_box = Box{ Eigen::Vector3d::Constant(-0.5), Eigen::Vector3d::Constant(0.5) };
  query.budget.threads = 1;
  query.budget.max_boxes = 20000;
  query.closed = [&](const Box& box, const Reason& reason) { closed.push_back({ box, reason }); };
  findLargestRegion(machine, query);
  return closed;
}

/// One strut, from the slider to the platform point: rho is the root of |p - c - rho e|^2 = L^2 that the working mode
/// asks for.
Vector strutAt(const Machine& machine, int i, const Vector& p)
{
  const SlidingStrut& leg = slidingStrut(machine.leg(i));
  const Vector e = mid(leg.axis).cast<Number>().normalized();
  const Vector x = p - mid(machine.center(i)).cast<Number>();
  const Number length = leg.length.mid();
  const Number along = x.dot(e);
  const Number root = std::sqrt(along * along - x.dot(x) + length * length);
  return x - (along - leg.working_mode * root) * e;
}

/// b^2 less what psi_max leaves it: by Pythagoras, for the distance of p - c from the rail's direction.
Number reachOf(const Machine& machine, const Criterion& criterion, int i, const Vector& p)
{
  const SlidingStrut& leg = slidingStrut(machine.leg(i));
  const Vector e = mid(leg.axis).cast<Number>().normalized();
  const Vector x = p - mid(machine.center(i)).cast<Number>();
  const Number squared_length = std::pow(Number(leg.length.mid()), 2);
  const Number least = criterion.boundsAbove() ? squared_length / std::pow(Number(criterion.psi_max), 2) : 0;
  return squared_length - x.cross(e).squaredNorm() - least;
}

/// What a form of the criterion is about, without unit: machines of the tests have struts of about 1 m. No number where
/// a leg is beyond what psi_max leaves it: there the point is bad, and forms say nothing.
Number valueOf(const Machine& machine, const Criterion& criterion, const FormOrigin& origin, const Vector& p)
{
  Eigen::Matrix<Number, 3, 3> a;
  Vector b;
  for (int i = 0; i < 3; ++i)
  {
    a.row(i) = strutAt(machine, i, p);
    b[i] = a.row(i).dot(mid(slidingStrut(machine.leg(i)).axis).cast<Number>().normalized());
    if (criterion.boundsAbove() && !(std::abs(b[i]) * criterion.psi_max >= a.row(i).norm()))
      return std::numeric_limits<Number>::quiet_NaN();
  }
  const Vector v(origin.v[0], origin.v[1], origin.v[2]);
  const Vector u(origin.u[0], origin.u[1], origin.u[2]);
  const auto gram = [&](const Vector& w) { return (a.transpose() * w).squaredNorm(); };
  const auto drives = [&](const Vector& w) { return b.cwiseProduct(w).squaredNorm(); };
  const Number kappa = criterion.kappa_max;
  switch (origin.subject.kind)
  {
    case ConditionKind::PSI_MAX:
      return criterion.psi_max * criterion.psi_max * drives(v) - gram(v);
    case ConditionKind::PSI_MIN:
      return gram(v) - criterion.psi_min * criterion.psi_min * drives(v);
    case ConditionKind::KAPPA_MAX:
      return gram(u) * drives(v) - gram(v) * drives(u) / (kappa * kappa);
    case ConditionKind::ASPECT:
      return machine.aspect() * a.determinant();
    default:
      throw std::logic_error("the test does not know this condition");
  }
}

/// The upper end of the terms' sum over the box, in interval arithmetic.
double upperEnd(const Reason& reason)
{
  Interval sum;
  for (const ReasonTerm& term : reason.terms)
  {
    EXPECT_GE(term.weight, 0.0);
    Interval form = Interval(term.form.center) + Interval(term.form.radius);
    sum += Interval(term.weight) * form;
  }
  for (std::size_t j = 0; j < 3; ++j)
  {
    Interval slope;
    for (const ReasonTerm& term : reason.terms)
      slope += Interval(term.weight) * Interval(term.form.gradient[j]);
    sum += abs(slope);
  }
  return sum.upper();
}

/// Looks at the terms of a reason at one center of the box.
class TermsAt
{
public:
  TermsAt(const Machine& machine, const Criterion& criterion, const Shape& shape, const ClosedBox& closed,
          const Eigen::Vector3d& delta)
    : machine_(machine), criterion_(criterion), shape_(shape), size_(closed.reason.size), delta_(delta)
  {
    const CenteredBox<double> box(closed.reason.centers);
    for (int k = 0; k < 3; ++k)
      center_[k] =
          box.center[static_cast<std::size_t>(k)] + Number(delta[k]) * box.half_widths[static_cast<std::size_t>(k)];
  }

  void expectTrue(const ReasonTerm& term) const
  {
    Number affine = term.form.center;
    for (std::size_t j = 0; j < 3; ++j)
      affine += Number(term.form.gradient[j]) * delta_[static_cast<int>(j)];
    const Number radius = term.form.radius * (1 + 1e-9L) + 1e-15L;
    if (term.kind == ReasonTerm::Kind::CONDITION)
      expectCondition(term, affine, radius);
    else if (term.kind == ReasonTerm::Kind::BAD_POINT && affine + radius < 0)
    {
      expectHeld(term.point.cast<Number>() - center_);
    }
  }

private:
  void expectHeld(const Vector& k) const
  {
    const bool is_cube = shape_.name() == "cube";
    EXPECT_LE(is_cube ? 2 * k.cwiseAbs().maxCoeff() : k.norm(), size_ * (1 + 1e-12L));
  }
  void expectCondition(const ReasonTerm& term, Number affine, Number radius) const
  {
    const Vector p = center_ + term.place.fixed.cast<Number>() + Number(size_) * term.place.per_size.cast<Number>();
    const Number value = term.origin.subject.kind == ConditionKind::REACH
                             ? reachOf(machine_, criterion_, static_cast<int>(term.origin.subject.leg), p)
                             : valueOf(machine_, criterion_, term.origin, p);
    // beyond reach the root is no number, and nothing is said of the point
    if (std::isnan(value))
      return;
    EXPECT_LE(std::abs(value - affine), radius) << "kind " << static_cast<int>(term.origin.subject.kind);
  }

  const Machine& machine_;
  const Criterion& criterion_;
  const Shape& shape_;
  Number size_;
  Eigen::Vector3d delta_;
  Vector center_;
};

/// @return how many reasons of each kind there were
std::map<Closing, int> expectProofs(const Machine& machine, const Criterion& criterion, const ShapePtr& shape,
                                    double accuracy = 1e-2)
{
  ::testing::Test::RecordProperty("seed", static_cast<int>(SEED));
  Random random(SEED);
  std::map<Closing, int> counts;
  for (const ClosedBox& closed : closedBoxes(machine, criterion, shape, accuracy))
  {
    ++counts[closed.reason.closing];
    EXPECT_NE(closed.reason.closing == Closing::UNSETTLED, !closed.reason.terms.empty());
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(closed.reason.centers.lower[k] <= closed.centers.lower[k] &&
                  closed.centers.upper[k] <= closed.reason.centers.upper[k]);
    if (closed.reason.terms.empty())
      continue;
    EXPECT_LT(upperEnd(closed.reason), 0.0);
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d delta(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const TermsAt there(machine, criterion, *shape, closed, delta);
      for (const ReasonTerm& term : closed.reason.terms)
        there.expectTrue(term);
    }
  }
  return counts;
}
}  // namespace

TEST(Reason, provesThatNoCenterOfTheBoxCarriesARegion)
{
  const std::map<Closing, int> cubes = expectProofs(orthoglide(), Criterion(), makeCube());
  EXPECT_GT(cubes.at(Closing::FORM), 20);
  EXPECT_GT(cubes.at(Closing::COMBINATION), 20);
  const std::map<Closing, int> spheres = expectProofs(orthoglide(), Criterion(), makeSphere());
  EXPECT_GT(spheres.at(Closing::BAD_POINT), 0);
}

TEST(Reason, provesItOfCrookedMachines)
{
  for (const unsigned seed : { 1, 3, 4 })
  {
    const std::map<Closing, int> counts =
        expectProofs(crooked(seed), Criterion(), seed == 1 ? makeSphere() : makeCube());
    EXPECT_GT(counts.at(Closing::FORM), 20) << "seed " << seed;
    EXPECT_GT(counts.at(Closing::COMBINATION), 20) << "seed " << seed;
  }
}

TEST(Reason, provesItForTheConditionNumber)
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.kappa_max = 3.0;
  const std::map<Closing, int> counts = expectProofs(orthoglide(), criterion, makeCube());
  EXPECT_GT(counts.at(Closing::COMBINATION), 10);
}

TEST(Reason, pointsThatAreSaidToBeBadAre)
{
  const Machine machine = orthoglide();
  const Oracle oracle(machine, Criterion());
  int points = 0;
  for (const ClosedBox& closed : closedBoxes(machine, Criterion(), makeSphere(), 1e-2))
    for (const ReasonTerm& term : closed.reason.terms)
      if (term.kind == ReasonTerm::Kind::BAD_POINT && ++points < 1000)
      {
        EXPECT_FALSE(oracle.isGood(term.point)) << term.point.transpose();
      }
  EXPECT_GT(points, 10);
}

/// A bound that was lowered on the way is told with what proved it.
TEST(Reason, boundsAreToldWithTheirProof)
{
  const std::map<Closing, int> cubes = expectProofs(crooked(4), Criterion(), makeCube(), 1e-5);
  EXPECT_GT(cubes.at(Closing::BOUND), 10);
}
}  // namespace test
}  // namespace pkm_workspace
