// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/characteristic_polynomial.h"

#include <algorithm>
#include <optional>

#include "mean_value_form.h"

namespace pkm_workspace
{
namespace
{
using mean_value::Chart;
using mean_value::Form;
using mean_value::FormVector;

/// The polynomial knows sliding struts. @throws std::invalid_argument for others
const EnclosedStrut& strutOf(const Machine& machine, int leg)
{
  slidingStrut(machine.leg(leg));
  return std::get<EnclosedStrut>(machine.enclosed(leg));
}

/// One leg over the box.
struct LegForms
{
  FormVector across;  ///< q = (I - e e^T)(p - c) [m]
  Form radicand;      ///< eta^2 = L^2 - |q|^2 [m^2]

  LegForms(const EnclosedStrut& strut, const Chart& chart)
  {
    const IntervalMatrix& projector = strut.projector;
    const IntervalVector center = projector * (chart.center - strut.center);
    const IntervalVector range = projector * (chart.range - strut.center);
    for (std::size_t k = 0; k < 3; ++k)
      across[k] = { center[k], range[k], projector[k] };
    const Form squared_norm = sqr(across[0]) + sqr(across[1]) + sqr(across[2]);
    radicand = chart.tightened(sqr(strut.length) - squared_norm);
  }

  /// d = q + eta e [m]. @pre the radicand is positive on the box
  FormVector strut(const EnclosedStrut& leg, const Chart& chart) const
  {
    const Form eta = leg.sign * chart.tightened(sqrt(radicand));
    return { across[0] + leg.axis[0] * eta, across[1] + leg.axis[1] * eta, across[2] + leg.axis[2] * eta };
  }
};

/// The entries of a symmetric matrix: its diagonal, and 12, 20, 01.
template <class Entry>
struct Symmetric
{
  std::array<Entry, 3> diagonal;
  std::array<Entry, 3> off;
};

/// Encloses the determinant.
template <class Entry>
Entry determinant(const Symmetric<Entry>& m)
{
  const Entry mixed = m.off[0] * m.off[1] * m.off[2];
  return m.diagonal[0] * (m.diagonal[1] * m.diagonal[2] - sqr(m.off[0])) + (mixed + mixed) -
         (m.diagonal[1] * sqr(m.off[1]) + m.diagonal[2] * sqr(m.off[2]));
}

/// @return true: positive definite; false: not even semidefinite, a principal minor is negative; nothing: not proved
std::optional<bool> isPositive(const Symmetric<Interval>& m)
{
  const auto minor = [&m](std::size_t i) { return m.diagonal[(i + 1) % 3] * m.diagonal[(i + 2) % 3] - sqr(m.off[i]); };
  const Interval minors[] = {
    m.diagonal[0], minor(2), determinant(m), m.diagonal[1], m.diagonal[2], minor(0), minor(1)
  };
  if (std::any_of(std::begin(minors), std::end(minors), [](const Interval& x) { return x.certainlyNegative(); }))
    return false;
  if (std::all_of(minors, minors + 3, [](const Interval& x) { return x.certainlyPositive(); }))
    return true;  // Sylvester: the leading minors
  return std::nullopt;
}

/// The machine at one point of its workspace.
struct Point
{
  IntervalVector eta;                   ///< [m]
  std::array<IntervalVector, 3> strut;  ///< [m]

  /// sign S(sigma) [m^2]. @param sign +1 or -1
  Symmetric<Interval> pencil(const Machine& machine, const Interval& sigma, double sign) const
  {
    Symmetric<Interval> s;
    for (std::size_t i = 0; i < 3; ++i)
    {
      s.diagonal[i] = sign * (sqr(strutOf(machine, static_cast<int>(i)).length) - sigma * sqr(eta[i]));
      s.off[i] = sign * dot(strut[(i + 1) % 3], strut[(i + 2) % 3]);
    }
    return s;
  }
};

/// @return nothing when a leg is not proved to reach p
std::optional<Point> pointAt(const Machine& machine, const IntervalVector& p)
{
  Point point;
  for (int i = 0; i < 3; ++i)
  {
    const EnclosedStrut& leg = strutOf(machine, i);
    const IntervalVector across = leg.projector * (p - leg.center);
    const Interval radicand = sqr(leg.length) - squaredNorm(across);
    if (radicand.lower() < 0.0)
      return std::nullopt;
    const auto k = static_cast<std::size_t>(i);
    point.eta[k] = leg.sign * sqrt(radicand);
    point.strut[k] = across + point.eta[k] * leg.axis;
  }
  return point;
}

/// The legs over one box.
struct Legs
{
  Chart chart;
  std::array<LegForms, 3> forms;

  Legs(const Machine& machine, const Box& box)
    : chart(box)
    , forms{ LegForms(strutOf(machine, 0), chart), LegForms(strutOf(machine, 1), chart),
             LegForms(strutOf(machine, 2), chart) }
  {}
  /// Whether B is proved regular on the whole box (the paper's cylinders, section 4.2).
  bool areWithinCylinders() const
  {
    return std::all_of(forms.begin(), forms.end(),
                       [](const LegForms& leg) { return leg.radicand.range.certainlyPositive(); });
  }
};

/// S(sigma) = A A^T - sigma B^2 over one box.
class Pencil
{
public:
  /// @pre legs are within their cylinders
  Pencil(const Machine& machine, const Legs& legs) : chart_(legs.chart)
  {
    std::array<FormVector, 3> strut;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const EnclosedStrut& leg = strutOf(machine, static_cast<int>(i));
      squared_length_[i] = sqr(leg.length);
      radicand_[i] = legs.forms[i].radicand;
      strut[i] = legs.forms[i].strut(leg, chart_);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const FormVector& u = strut[(i + 1) % 3];
      const FormVector& v = strut[(i + 2) % 3];
      product_[i] = chart_.tightened(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
    }
  }

  /// P(sigma; .) = det S(sigma) [m^6].
  Form polynomial(const Interval& sigma) const
  {
    Symmetric<Form> s;
    for (std::size_t i = 0; i < 3; ++i)
      s.diagonal[i] = squared_length_[i] - sigma * radicand_[i];
    s.off = product_;
    return chart_.tightened(determinant(s));
  }

private:
  Chart chart_;
  std::array<Interval, 3> squared_length_;  ///< diagonal of A A^T: |d_i|^2 = L_i^2 [m^2]
  FormVector radicand_;                     ///< diagonal of B^2 [m^2]
  FormVector product_;                      ///< d_2 . d_3, d_3 . d_1, d_1 . d_2 [m^2]
};

/// The part of the box where a function is least, as far as the signs of its derivatives tell.
Box faceOfLeast(Box box, const IntervalVector& gradient)
{
  for (int k = 0; k < 3; ++k)
    if (gradient[static_cast<std::size_t>(k)].lower() >= 0.0)
      box.upper[k] = box.lower[k];
    else if (gradient[static_cast<std::size_t>(k)].upper() <= 0.0)
      box.lower[k] = box.upper[k];
  return box;
}

/// Whether sigma is proved to be an eigenvalue nowhere on the box (paper, section 2.2.1: bounds from derivatives).
/// @param pencil over the box
bool isNoEigenvalue(const Machine& machine, Box box, const Pencil& pencil, const Interval& sigma)
{
  Form p = pencil.polynomial(sigma);
  const Interval sign = p.center.certainlyNegative() ? -1.0 : 1.0;
  while (!(sign * p.range).certainlyPositive())
  {
    const Box face = faceOfLeast(box, (sign * p).gradient);
    if (face.lower == box.lower && face.upper == box.upper)
      return false;
    box = face;
    const Legs legs(machine, box);
    if (!legs.areWithinCylinders())
      return false;
    p = Pencil(machine, legs).polynomial(sigma);
  }
  return true;
}

/// @throws std::invalid_argument for what the polynomial does not know
const Criterion& accepted(const Criterion& criterion)
{
  Problems problems;
  criterion.validate(problems);
  if (!criterion.boundsBelow() || !criterion.boundsAbove() || criterion.boundsCondition() || criterion.joint_limits ||
      criterion.boundsMore() || !criterion.zones.empty())
    problems.push_back(
        "the characteristic polynomial needs factors that are bounded from both sides, and knows neither "
        "joint limits nor condition numbers, nor conditions of motors, tolerances, angles and zones");
  throwProblems(problems);
  return criterion;
}
}  // namespace

CharacteristicTest::CharacteristicTest(const Machine& machine, const Criterion& criterion)
  : machine_(machine)
  , aspect_(accepted(criterion).wantedSign(machine.aspect()))
  , sigma_min_(sqr(criterion.leastFactor()))
  , sigma_max_(sqr(criterion.largestFactor()))
{}

BoxVerdict CharacteristicTest::classify(const Box& box) const
{
  const Legs legs(machine_, box);
  for (std::size_t i = 0; i < 3; ++i)
    if ((sigma_max_ * legs.forms[i].radicand.range - sqr(strutOf(machine_, static_cast<int>(i)).length))
            .certainlyNegative())
      return BoxVerdict::OUTSIDE;  // leg i does not reach, or an entry of S(sigma_max)'s diagonal is positive
  const auto center = pointAt(machine_, enclose(box.center()));
  if (!center || !legs.areWithinCylinders())
    return BoxVerdict::UNDECIDED;
  const bool is_point = box.lower == box.upper;  // then the center is all there is
  const std::optional<Pencil> pencil = is_point ? std::nullopt : std::make_optional<Pencil>(machine_, legs);
  const auto holdsOnBox = [&](const Interval& sigma) {
    return is_point || isNoEigenvalue(machine_, box, *pencil, sigma);
  };

  const Interval orientation =
      static_cast<double>(aspect_) * determinant(center->strut[0], center->strut[1], center->strut[2]);
  if (orientation.certainlyNegative() && holdsOnBox(0.0))
    return BoxVerdict::OUTSIDE;  // det A is 0 nowhere: the other aspect
  const auto above_min = isPositive(center->pencil(machine_, sigma_min_, 1.0));
  const auto below_max = isPositive(center->pencil(machine_, sigma_max_, -1.0));
  const auto isFalse = [](const std::optional<bool>& known) { return known && !*known; };
  if ((isFalse(above_min) && holdsOnBox(sigma_min_)) || (isFalse(below_max) && holdsOnBox(sigma_max_)))
    return BoxVerdict::OUTSIDE;  // section 2.2.2
  const bool is_valid = above_min.value_or(false) && below_max.value_or(false);
  if (is_valid && (aspect_ == 0 || orientation.certainlyPositive()) && holdsOnBox(sigma_min_) && holdsOnBox(sigma_max_))
    return BoxVerdict::INSIDE;  // section 2.2.1
  return BoxVerdict::UNDECIDED;
}
}  // namespace pkm_workspace
