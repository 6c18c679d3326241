// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_test.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
/// Forms are scaled to the order of 1; no optimum of the programme lies above this.
constexpr double ROOM = 64.0;
/// Rounds of cutting planes a box, and the least relative violation that is worth a cut.
constexpr int ROUNDS = 2;
constexpr double WORTH_A_CUT = 1e-3;

Enclosed<double> exactly(double value)
{
  return Enclosed<double>(Interval(value));
}

/// Makes lengths numbers of the order of 1.
Enclosed<double> perLength(const BoxTest& test)
{
  return exactly(1.0 / std::sqrt(test.model().legs().squaredScale()));
}

ReasonTerm withForm(ReasonTerm term, const AffineForm<double>& form)
{
  term.form = form;
  return term;
}
}  // namespace

CenterTest::CenterTest(const BoxTest& test, const Shape& shape, const WitnessPoints& witnesses,
                       const RailTravel* travel, bool keeps_reasons)
  : test_(test)
  , shape_(shape)
  , witnesses_(witnesses)
  , travel_(travel)
  , own_(shape.ownProof())
  , spheres_(own_ ? std::vector<StrutSphere>() : test.spheres())
  , half_extents_(shape.halfExtents())
  , keeps_reasons_(keeps_reasons)
{
  if (spheres_.empty())
    return;
  const std::vector<GrowingVector> extremes = shape.extremePoints();
  for (std::size_t k = 0; k < extremes.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (const auto middle = shape.placeOf((0.5 * (extremes[k] + extremes[l])).at(1.0), 1.0))
        between_.push_back(*middle);
}

/// @param term makes what the form says, where reasons are kept
/// @return true when the form is negative on the whole box: that alone excludes it
template <class Term>
bool CenterTest::add(const TurningForm& form, const Term& term)
{
  if (form.upper() < 0.0)
  {
    if (keeps_reasons_)
      reason_.terms = { withForm(term(), form.form) };
    return true;
  }
  if (form.lower() > 0.0)
    return false;  // it cannot help
  forms_.push_back(form);
  if (keeps_reasons_)
    terms_.push_back(withForm(term(), form.form));
  const auto& [center, g, radius] = form.form;
  programme_.add({ center + radius + form.turn.radius, { g[0], g[1], g[2], form.turn.value, -ROOM } });
  return false;
}

/// @return true when that alone excludes the box
bool CenterTest::addTravel(const Box& places, double size)
{
  const auto addAll = [&](const GrowingVector& place, const auto& over_node) {
    return std::any_of(travel_forms_.begin(), travel_forms_.end(), [&](const TravelForm& travel) {
      return add(perLength(test_) * over_node(travel.form), [&] {
        ReasonTerm result{ ReasonTerm::Kind::TRAVEL, place };
        result.limit = travel.limit;
        return result;
      });
    });
  };
  travel_forms_.clear();
  travel_->addSearchBox(places, travel_forms_);
  bool excluded =
      addAll(scaling(Eigen::Vector3d::Zero()), [](const AffineForm<double>& form) { return TurningForm{ form }; });
  for (std::size_t k = 0; k < witnesses_.ofShape().size() && !excluded; ++k)
  {
    travel_forms_.clear();
    travel_->addForms(box_.moved(size, places_[k]), travel_forms_);
    excluded = addAll(witnesses_.ofShape()[k], [&](const AffineForm<double>& form) { return overNode(k, form); });
  }
  return excluded;
}

/// What the criterion makes necessary at a witness point. @return true when that alone excludes the box
bool CenterTest::addNecessary(std::size_t k)
{
  const NecessaryForms& necessary = necessary_[k];
  const auto term = [&](std::size_t form) {
    ReasonTerm result{ ReasonTerm::Kind::CONDITION };
    result.place = witnesses_.ofShape()[k];
    result.origin = origins_[k * NecessaryForms::MOST + form];
    return result;
  };
  if (necessary.violated && keeps_reasons_)
    reason_.terms = { withForm(term(0), necessary.form[0]) };
  if (necessary.violated)
    return true;
  for (std::size_t form = 0; form < necessary.forms; ++form)
    if (add(overNode(k, necessary.form[form]), [&] { return term(form); }))
      return true;
  return false;
}

/// Whether for every center of the box a point between two extreme points lies within the sphere and in its cone.
bool CenterTest::reachesInto(const StrutSphere& sphere, double size) const
{
  const auto first = places_.end() - static_cast<std::ptrdiff_t>(between_.size());
  return std::any_of(first, places_.end(), [&](const GrowingVector& place) {
    const CenteredBox<double> there = box_.moved(size, place);
    return sphere.hasInCone(there) && sphere.excess(there).upper() < 0.0;
  });
}

/// What a region shares with the cone of a sphere is on one side of it; a point tells which one, if it is there for all
/// centers of the box. @return true when all regions have points on both sides
bool CenterTest::addSphere(const StrutSphere& sphere, const Box& centers, double size)
{
  excesses_.clear();
  bool within = !turning_ && shape_.contains(sphere.center(), centers, size);
  bool beyond = false;
  for (std::size_t k = 0; k < witnesses_.ofShape().size(); ++k)
  {
    const CenteredBox<double> there = box_.moved(size, places_[k]);
    if (!sphere.hasInCone(there))
      continue;
    excesses_.push_back({ witnesses_.ofShape()[k], overNode(k, sphere.excess(there)) });
    within = within || excesses_.back().form.upper() < 0.0;
    beyond = beyond || excesses_.back().form.lower() > 0.0;
  }
  within = within || (!excesses_.empty() && reachesInto(sphere, size));
  return std::any_of(excesses_.begin(), excesses_.end(), [&](const Excess& excess) {
    const auto term = [&] {
      ReasonTerm result{ ReasonTerm::Kind::SPHERE };
      result.place = excess.place;
      result.point = sphere.center();
      return result;
    };
    return (within && add(exactly(-1.0) * excess.form, term)) || (beyond && add(excess.form, term));
  });
}

/// Checks the programme's certificate: a non-negative combination of the forms that is negative on the whole box.
bool CenterTest::combinationExcludes()
{
  TurningForm sum;
  reason_.terms.clear();
  for (const auto& term : programme_.certificate())
    if (!std::isfinite(term.weight))
      return false;
    else if (term.row >= 0)
    {
      const auto row = static_cast<std::size_t>(term.row);
      sum = sum + exactly(term.weight) * forms_[row];
      if (!keeps_reasons_)
        continue;
      reason_.terms.push_back(terms_[row]);
      reason_.terms.back().weight = term.weight;
    }
  return sum.upper() < 0.0;
}

/// Adds a row for each matrix that is not semidefinite at the programme's optimum. @return whether there was one
bool CenterTest::addCuts()
{
  const auto& point = programme_.point();
  bool added = false;
  for (std::size_t k = 0; k < necessary_.size(); ++k)
  {
    std::array<double, 3> delta = { point[0], point[1], point[2] };
    if (turning_)
      delta = turning_->deltaOf(k, delta, point[3]);
    for (std::size_t m = 0; m < necessary_[k].matrices; ++m)
    {
      const NecessaryForms& necessary = necessary_[k];
      if (isAbove(necessary.matrix[m], delta, -WORTH_A_CUT))
        continue;
      const auto pair = leastEigenvector(necessary.matrix[m], delta);
      const AffineForm<double> form = quadraticForm(necessary.matrix[m], pair.vector);
      const double value = form.center + form.radius + form.gradient[0] * delta[0] + form.gradient[1] * delta[1] +
                           form.gradient[2] * delta[2];
      if (value > room_ - WORTH_A_CUT * std::abs(room_))
        continue;
      add(overNode(k, form), [&] {
        const FormOrigin origin{ { necessary.kind[m] }, {}, pair.vector };
        return ReasonTerm{ ReasonTerm::Kind::CONDITION, witnesses_.ofShape()[k], origin };
      });
      added = true;
    }
  }
  return added;
}

/// A region that is thinner than the box of centers meets a point only near its own height: a bad point stands for
/// those beside it where all of them are bad, up to the ends of the centers; in reasons for itself only.
CenterTest::BadPoint CenterTest::alongThinAxes(const Eigen::Vector3d& known, const Box& centers, double size) const
{
  const Eigen::Vector3d half = half_extents_.at(size);
  BadPoint beside{ known, centers };
  Box all{ known, known };
  for (int axis = 0; axis < 3; ++axis)
    if (2.0 * half[axis] < centers.width(axis) || half[axis] == 0.0)
    {
      all.lower[axis] = centers.lower[axis];
      all.upper[axis] = centers.upper[axis];
      beside.point[axis] = beside.centers.lower[axis] = beside.centers.upper[axis] = centers.center()[axis];
    }
  const bool is_more = all.lower != known || all.upper != known;
  const auto isBad = [&] { return !travel_ && !keeps_reasons_ && test_.classify(all) == BoxVerdict::OUTSIDE; };
  return is_more && !isBad() ? BadPoint{ known, centers } : beside;
}

/// @return true when a point that is known to be bad lies within every region: that alone excludes the box
bool CenterTest::addKnown(const Box& centers, double size)
{
  for (const Eigen::Vector3d& known : witnesses_.badNear(centers.center(), angles_.mid(), bad_))
  {
    const BadPoint bad = alongThinAxes(known, centers, size);
    const auto beyond = avoidance(bad, size);
    const auto term = [&bad] {
      ReasonTerm result{ ReasonTerm::Kind::BAD_POINT };
      result.point = bad.point;
      return result;
    };
    if (beyond && add(perLength(test_) * *beyond, term))
      return true;
  }
  return false;
}

std::optional<Closing> CenterTest::excludes(const Box& centers, double size, const Interval& angles)
{
  place(centers, size, angles);
  std::optional<Closing> excluded = excludes(centers, size, test_.kernel());
  const BoxKernel* finer = excluded ? nullptr : test_.finerKernel(centers);
  if (finer)
    excluded = excludes(centers, size, *finer);
  reason_.closing = excluded.value_or(Closing::UNSETTLED);
  reason_.centers = centers;
  reason_.size = size;
  return excluded;
}

/// By one form, as far as they are known before there are cuts: those that do not are kept.
std::optional<Closing> CenterTest::excludesAlone(const Box& centers, double size, const BoxKernel& kernel)
{
  if (own_ && own_->refutes(test_, centers, size))
    return Closing::FORM;
  if (addKnown(centers, size))
    return Closing::BAD_POINT;
  necessary_.resize(witnesses_.ofShape().size());
  origins_.resize(keeps_reasons_ ? necessary_.size() * NecessaryForms::MOST : 0);
  kernel.necessaryForms(box_, size, places_.data(), necessary_.size(), necessary_.data(),
                        keeps_reasons_ ? origins_.data() : nullptr);
  bool excluded = false;
  for (std::size_t k = 0; k < necessary_.size() && !excluded; ++k)
    excluded = addNecessary(k);
  excluded = excluded || (travel_ && addTravel(centers, size)) ||
             std::any_of(spheres_.begin(), spheres_.end(),
                         [&](const StrutSphere& sphere) { return addSphere(sphere, centers, size); });
  return excluded ? std::make_optional(Closing::FORM) : std::nullopt;
}

std::optional<Closing> CenterTest::excludes(const Box& centers, double size, const BoxKernel& kernel)
{
  forms_.clear();
  terms_.clear();
  programme_.reset({ 0.0, 0.0, 0.0, 0.0, 1.0 });
  room_ = ROOM;
  if (const auto alone = excludesAlone(centers, size, kernel))
    return alone;
  for (int round = 0; round < ROUNDS && !forms_.empty(); ++round)
  {
    const bool feasible = programme_.solve();
    room_ = programme_.point()[4] * ROOM;
    if (!feasible || room_ < 0.0)
      return combinationExcludes() ? std::make_optional(Closing::COMBINATION) : std::nullopt;
    if (!addCuts())
      return std::nullopt;
  }
  return std::nullopt;
}
}  // namespace pkm_workspace
