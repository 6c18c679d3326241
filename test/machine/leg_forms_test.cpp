// SPDX-License-Identifier: BSD-3-Clause
// Forms of struts of variable length and cranks over boxes, against loops that are closed by triangles in 100 digits.
#include "pkm_workspace/machine/leg_forms.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/closed_leg.h"
#include "support/machines.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Number = ClosedLeg::Number;
using FormState = LegState<AffineForm<double>, AffineVector<double>>;

/// One leg over one box, and points of the box.
class LegOverBox
{
public:
  LegOverBox(const Leg& leg, const CenteredBox<double>& box, double scale)
    : leg_(leg)
    , forms_(visitLeg([](const auto& kind) -> LegOfForms<double> { return ofForms<double>(enclosed(kind)); }, leg.kind))
    , box_(box)
    , slack_(1e-14 * scale)
  {
    const auto root = [](const AffineForm<double>& x) { return sqrtAbove(x, 0.0); };
    evaluate(forms_, box_, root, state_, row_);
    limit_.is_upper = leg.joint.back() == '2';
    const double angle = referenceOf(leg) + 0.4;
    limit_.value = Enclosed<double>(limit_.is_upper ? angle : -angle, 0.0);
    limit_.cosine = Enclosed<double>(cos(0.4));
    limit_.sine = Enclosed<double>(sin(0.4));
  }

  const FormState& state() const { return state_; }
  const QuadraticVector<double>& row() const { return row_; }

  /// @return whether the leg reaches the point
  bool check(const std::array<double, 3>& delta) const
  {
    ClosedLeg::Vector p;
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = Number(box_.center[k]) + Number(box_.half_widths[k]) * delta[k];
    const ClosedLeg there = legAt(leg_, p);
    if (!there.reaches)
      return false;
    EXPECT_TRUE(holds(state_.squared_drive, delta, there.drive * there.drive)) << "b^2";
    EXPECT_TRUE(holds(state_.drive, delta, there.drive)) << "b";
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(holds(component(state_.row, k), delta, there.row[k])) << "row " << k;
      EXPECT_TRUE(holds(component(row_.linear, k), delta, there.row[k] - secondOrder(row_.second[k], delta)))
          << "row to second order " << k;
    }
    checkJoint(delta, there);
    return true;
  }

private:
  void checkJoint(const std::array<double, 3>& delta, const ClosedLeg& there) const
  {
    EXPECT_TRUE(holds(jointOf(forms_, box_, state_), delta, there.joint)) << "joint";
    Number beyond = limit_.is_upper ? Number(limit_.value.value - there.joint) : there.joint + limit_.value.value;
    if (const auto* const crank = std::get_if<Crank>(&leg_.kind))
      beyond = crank->radius.mid() * sin(there.joint - crank->reference - Number(0.4)) * (limit_.is_upper ? -1 : 1);
    EXPECT_TRUE(holds(limitForm(forms_, box_, state_, limit_), delta, beyond)) << "limit";
  }

  static Number secondOrder(const std::array<double, 6>& s, const std::array<double, 3>& delta)
  {
    Number sum = 0;
    for (std::size_t j = 0; j < 3; ++j)
      sum += s[j] * Number(delta[j]) * delta[j] + s[3 + j] * Number(delta[(j + 1) % 3]) * delta[(j + 2) % 3];
    return sum;
  }

  bool holds(const AffineForm<double>& form, const std::array<double, 3>& delta, const Number& value) const
  {
    Number linear = form.center;
    for (std::size_t j = 0; j < 3; ++j)
      linear += Number(form.gradient[j]) * delta[j];
    return abs(value - linear) <= Number(form.radius) + slack_;
  }

  const Leg& leg_;
  LegOfForms<double> forms_;
  CenteredBox<double> box_;
  double slack_;  ///< directions are enclosures of unit vectors, of which the oracle takes one [m]
  FormState state_;
  QuadraticVector<double> row_;
  JointLimit<double> limit_;
};

/// The machine's legs, and its cranks in the other working mode.
std::vector<Leg> legsInBothModes(const Machine& machine)
{
  std::vector<Leg> legs(machine.legs().begin(), machine.legs().end());
  for (Leg leg : machine.legs())
    if (auto* const crank = std::get_if<Crank>(&leg.kind))
    {
      crank->working_mode = -crank->working_mode;
      legs.push_back(leg);
    }
  return legs;
}

CenteredBox<double> boxAbout(const Machine& machine, double half_width, Random& random)
{
  CenteredBox<double> box;
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.center[k] = machine.zero()[static_cast<Eigen::Index>(k)] + random.uniform(-1.0, 1.0) * machine.scale();
    box.half_widths[k] = half_width * (random.once(4) ? 0.0 : random.uniform(0.2, 1.0));
  }
  return box;
}
}  // namespace

TEST(LegForms, holdTheLegsThatAreClosedByTriangles)
{
  for (const Machine& machine : otherLegs())
  {
    int reached = 0;
    for (int seed = 0; seed < cases(300) && !testing::Test::HasFailure(); ++seed)
    {
      Random random(static_cast<std::uint64_t>(seed));
      const double half_width = machine.scale() * std::ldexp(1.0, -random.integer(1, 24));
      const CenteredBox<double> box = boxAbout(machine, half_width, random);
      for (const Leg& leg : legsInBothModes(machine))
      {
        SCOPED_TRACE(machine.name() + ", " + leg.joint + ", seed " + std::to_string(seed));
        const LegOverBox forms(leg, box, machine.scale());
        if (hasAngle(leg))
        {
          EXPECT_LE(affine::radiusOf(forms.state().row, 0), 3.0 * machine.scale()) << "a row ends on a circle";
        }
        for (int sample = 0; sample < 4; ++sample)
        {
          std::array<double, 3> delta;
          for (double& d : delta)
            d = random.once(2) ? random.uniform(-1.0, 1.0) : random.sign();
          reached += forms.check(delta);
        }
      }
    }
    EXPECT_GT(reached, cases(300)) << machine.name() << ": too few points are reached";
  }
}

// sin and cos of phi for each t = tan(phi / 2) of a form.
TEST(LegForms, ofTipsHoldTheSineAndCosineOfEveryTurn)
{
  for (int seed = 0; seed < cases(2000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const double swing = std::ldexp(1.0, -random.integer(0, 20));
    AffineForm<double> t;
    t.center = random.once(2) ? random.uniform(-swing, swing) : 0.0;
    t.gradient[0] = swing;
    const crank::TipForms<double> tip{ QuadraticForm<double>(t) };
    for (const double delta : { -1.0, 1.0, -0.5, 0.5, random.uniform(-1.0, 1.0) })
    {
      const Number tangent = Number(t.center) + Number(swing) * delta;
      const Number square = tangent * tangent;
      const auto errorOf = [&](const QuadraticForm<double>& form, const Number& value) {
        return Number(abs(value - form.linear.center - Number(form.linear.gradient[0]) * delta -
                          Number(form.second[0]) * delta * delta));
      };
      ASSERT_LE(errorOf(tip.sine, 2 * tangent / (1 + square)), Number(tip.sine.linear.radius)) << "seed " << seed;
      ASSERT_LE(errorOf(tip.minus_cosine, (square - 1) / (1 + square)), Number(tip.minus_cosine.linear.radius))
          << "seed " << seed;
    }
  }
}

// What a form of a crank overestimates is of second order, and what it keeps of it of third.
TEST(LegForms, ofCranksAreCloseToSecondOrder)
{
  const Machine machine = delta();
  for (const double half_width : { 0.01, 1e-3, 1e-4 })
    for (int seed = 0; seed < cases(100); ++seed)
    {
      Random random(static_cast<std::uint64_t>(seed));
      CenteredBox<double> box;
      for (std::size_t k = 0; k < 3; ++k)
        box.center[k] = machine.zero()[static_cast<Eigen::Index>(k)] + random.uniform(-0.2, 0.2);
      box.half_widths.fill(half_width);
      Leg either = machine.legs()[0];
      std::get<Crank>(either.kind).working_mode = random.sign() > 0.0 ? 1 : -1;
      const LegOverBox leg(either, box, machine.scale());
      const double square = half_width * half_width, cube = half_width * square;
      EXPECT_LE(leg.state().squared_drive.radius, 20.0 * square + 1e-14) << half_width;
      EXPECT_LE(affine::radiusOf(leg.state().row, 0), 8.0 * square + 1e-14) << half_width;
      EXPECT_LE(leg.row().linear.radius + leg.row().linear.along, 60.0 * cube + 1e-14) << half_width;
      EXPECT_LE(flat(product(leg.row(), leg.row())).radius, 20.0 * square + 1e-13) << "n^2 = L^2";
    }
}
}  // namespace test
}  // namespace pkm_workspace
