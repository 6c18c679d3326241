// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definitions of the templates declared in machine_forms.h.

#include "pkm_workspace/dexterity/machine_forms.h"
#include "pkm_workspace/dexterity/workspace_bounds.h"

namespace pkm_workspace
{
template <class Real>
MachineModel<Real>::MachineModel(const Machine& machine, const Criterion& criterion)
  : criterion_(validated(criterion))
  , meeting_(machine)
  , psi_max_squared_(criterion.boundsAbove() ? squared<Real>(criterion.largestFactor()) : Enclosed<Real>())
  , minus_psi_min_squared_(criterion.boundsBelow() ? -squared<Real>(criterion.leastFactor()) : Enclosed<Real>())
  , kappa_squared_(squared<Real>(criterion.kappa_max))
  , per_kappa_squared_(criterion.boundsCondition() ? Real(1) / (Real(criterion.kappa_max) * Real(criterion.kappa_max))
                                                   : Real(0))
  , aspect_sign_(Interval(criterion.aspect == Criterion::Aspect::OTHER ? -machine.aspect() : machine.aspect()))
  , squared_scale_(machine.scale() * machine.scale())
{
  const std::array<Interval, 3> limits = limitsThatBind(machine, criterion);
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = machine.leg(i);
    LegModel& model = legs_[static_cast<std::size_t>(i)];
    const Interval squared_length = sqr(leg.length);
    model.projector = EnclosedMatrix<Real>(machine.projector(i));
    model.along = EnclosedMatrix<Real>(IntervalMatrix{ leg.axis, IntervalVector{}, IntervalVector{} });
    model.center = EnclosedVector<Real>(machine.center(i));
    model.axis = EnclosedVector<Real>(leg.axis);
    model.squared_length = Enclosed<Real>(squared_length);
    model.minus_squared_length = Enclosed<Real>(-squared_length);
    model.sign = Enclosed<Real>(Interval(leg.working_mode));
    if (criterion.boundsAbove())
      model.floor = Real((squared_length / sqr(criterion.largestFactor())).lower());
    const std::array<double, 2> limit = { -limits[static_cast<std::size_t>(i)].lower(),
                                          limits[static_cast<std::size_t>(i)].upper() };
    for (const std::size_t side : { 0U, 1U })
    {
      model.limited[side] = std::isfinite(limit[side]);
      model.limit[side] = model.limited[side] ? Enclosed<Real>(Interval(limit[side])) : Enclosed<Real>();
    }
  }
}

template <class Real>
template <class Other>
MachineModel<Real>::MachineModel(const MachineModel<Other>& model)
  : criterion_(model.criterion_)
  , meeting_(model.meeting_)
  , psi_max_squared_(model.psi_max_squared_)
  , minus_psi_min_squared_(model.minus_psi_min_squared_)
  , kappa_squared_(model.kappa_squared_)
  , per_kappa_squared_(model.per_kappa_squared_)
  , aspect_sign_(model.aspect_sign_)
  , squared_scale_(model.squared_scale_)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& from = model.legs_[i];
    LegModel& to = legs_[i];
    to.projector = EnclosedMatrix<Real>(from.projector);
    to.along = EnclosedMatrix<Real>(from.along);
    to.center = EnclosedVector<Real>(from.center);
    to.axis = EnclosedVector<Real>(from.axis);
    to.squared_length = Enclosed<Real>(from.squared_length);
    to.minus_squared_length = Enclosed<Real>(from.minus_squared_length);
    to.sign = Enclosed<Real>(from.sign);
    to.floor = Real(from.floor);
    to.limited = from.limited;
    to.limit = { Enclosed<Real>(from.limit[0]), Enclosed<Real>(from.limit[1]) };
  }
}

template <class Real>
AffineForm<Real> MachineModel<Real>::radicand(std::size_t leg, const AffineVector<Real>& across) const
{
  return -squaredNorm(across) + legs_[leg].squared_length;
}

template <class Real>
template <class Domain>
MachineForms<Real> MachineModel<Real>::evaluate(const Domain& box) const
{
  MachineForms<Real> forms;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegModel& leg = legs_[i];
    AffineVector<Real>& strut = forms.strut[i];
    mapBox(leg.projector, leg.center, box, strut);
    forms.radicand[i] = radicand(i, strut);
    forms.eta[i] = leg.sign * sqrtAbove(forms.radicand[i], leg.floor);
    addAlong(strut, forms.eta[i], leg.axis);
  }
  forms.gram[0] = dot(forms.strut[1], forms.strut[2]);
  forms.gram[1] = dot(forms.strut[0], forms.strut[2]);
  forms.gram[2] = dot(forms.strut[0], forms.strut[1]);
  return forms;
}

template <class Real>
MachineNumbers<Real> MachineModel<Real>::evaluate(const std::array<Real, 3>& p) const
{
  using std::max;
  using std::sqrt;
  MachineNumbers<Real> numbers;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegModel& leg = legs_[i];
    const std::array<Real, 3> x = { p[0] - leg.center.value[0], p[1] - leg.center.value[1],
                                    p[2] - leg.center.value[2] };
    std::array<Real, 3>& d = numbers.strut[i];
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = leg.projector.value[k][0] * x[0] + leg.projector.value[k][1] * x[1] + leg.projector.value[k][2] * x[2];
    numbers.radicand[i] = leg.squared_length.value - eigen::dot(d, d);
    numbers.eta[i] = leg.sign.value * sqrt(max(numbers.radicand[i], Real(0)));
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = d[k] + numbers.eta[i] * leg.axis.value[k];
  }
  return numbers;
}

template <class Real>
Real MachineModel<Real>::margin(const std::array<Real, 3>& p) const
{
  using std::min;
  using std::sqrt;
  const MachineNumbers<Real> at = evaluate(p);
  const Real per_square = Real(1) / squared_scale_;
  const Real per_length = sqrt(per_square);
  Real reach = at.radicand[0] - legs_[0].floor;
  for (std::size_t i = 1; i < 3; ++i)
    reach = min(reach, at.radicand[i] - legs_[i].floor);
  reach = reach * per_square;
  Real least = reach;
  for (std::size_t i = 0; i < 3; ++i)
    if (legs_[i].limited[0] || legs_[i].limited[1])
      least = min(least, limitMargin(i, at, p) * per_length);
  if (oriented())
    least = min(least, aspect_sign_.value * eigen::dot(at.strut[0], eigen::cross(at.strut[1], at.strut[2])) *
                           (per_square * per_length));
  if (criterion_.boundsFactors())
    least = min(least, factorMargin(at));
  return select(reach < Real(0), reach, least);  // beyond reach nothing else has a meaning
}

/// The distance of rho_i to the nearer of its limits [m].
template <class Real>
Real MachineModel<Real>::limitMargin(std::size_t leg, const MachineNumbers<Real>& at,
                                     const std::array<Real, 3>& p) const
{
  using std::min;
  const LegModel& model = legs_[leg];
  const auto& c = model.center.value;
  const Real rho = eigen::dot(model.along.value[0], { p[0] - c[0], p[1] - c[1], p[2] - c[2] }) - at.eta[leg];
  const Real above = rho + model.limit[0].value;
  const Real below = model.limit[1].value - rho;
  return !model.limited[1] ? above : !model.limited[0] ? below : min(above, below);
}

/// The least eigenvalue of S_min and S_max in squared struts, and psi_1^2 - psi_3^2 / kappa_max^2.
template <class Real>
Real MachineModel<Real>::factorMargin(const MachineNumbers<Real>& at) const
{
  using std::min;
  const auto& d = at.strut;
  const std::array<Real, 3> gram = { eigen::dot(d[1], d[2]), eigen::dot(d[0], d[2]), eigen::dot(d[0], d[1]) };
  eigen::Symmetric<Real> upper;
  eigen::Symmetric<Real> lower;
  for (std::size_t i = 0; i < 3; ++i)
  {
    upper[i] = psi_max_squared_.value * at.radicand[i] - legs_[i].squared_length.value;
    lower[i] = minus_psi_min_squared_.value * at.radicand[i] + legs_[i].squared_length.value;
    upper[3 + i] = -gram[i];
    lower[3 + i] = gram[i];
  }
  const Real per_square = Real(1) / squared_scale_;
  Real margin(1e300);
  if (criterion_.boundsAbove())
    margin = eigen::leastEigenpair(upper).value * per_square;
  if (criterion_.boundsBelow())
    margin = min(margin, eigen::leastEigenpair(lower).value * per_square);
  if (criterion_.boundsCondition())
  {
    const ExtremeFactors<Real> factors = extremeFactors(at.radicand, gram);
    margin = min(margin, factors.least.value - per_kappa_squared_ * factors.largest.value);
  }
  return margin;
}

template <class Real>
SymmetricForms<Real> MachineModel<Real>::pencil(const MachineForms<Real>& forms, const Enclosed<Real>& minus_mu) const
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = minus_mu * forms.radicand[i] + legs_[i].squared_length;  // |d_i|^2 = L_i^2
    matrix[3 + i] = forms.gram[i];
  }
  return matrix;
}

template <class Real>
SymmetricForms<Real> MachineModel<Real>::lowerMatrix(const MachineForms<Real>& forms) const
{
  return pencil(forms, minus_psi_min_squared_);
}

template <class Real>
SymmetricForms<Real> MachineModel<Real>::upperMatrix(const MachineForms<Real>& forms) const
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = psi_max_squared_ * forms.radicand[i] + legs_[i].minus_squared_length;
    matrix[3 + i] = -forms.gram[i];
  }
  return matrix;
}

template <class Real>
AffineForm<Real> MachineModel<Real>::orientation(const MachineForms<Real>& forms) const
{
  return aspect_sign_ * determinant(forms.strut[0], forms.strut[1], forms.strut[2]);
}

/// With w_i = s_i e_i, p counted from o and h_i = |eta_i| + w_i . p, each strut is p + g / h_i w_i, g = L^2 - |p|^2,
/// and
///   det A h_1 h_2 h_3 = g^2 (h_1 (w_2 x w_3) . p + h_2 (w_3 x w_1) . p + h_3 (w_1 x w_2) . p + g det(w_1, w_2, w_3)).
template <class Real>
template <class Domain>
std::array<AffineForm<Real>, 5> MachineModel<Real>::orientationFactors(const MachineForms<Real>& forms,
                                                                       const Domain& box) const
{
  AffineVector<Real> from_center;
  AffineVector<Real> along;
  AffineVector<Real> across;
  mapBox(meeting_.identity, meeting_.center, box, from_center);
  mapBox(meeting_.along, meeting_.center, box, along);
  mapBox(meeting_.across, meeting_.center, box, across);
  std::array<AffineForm<Real>, 5> factors;
  const AffineForm<Real> gap = -squaredNorm(from_center) + meeting_.squared_length;
  AffineForm<Real> rest = meeting_.volume * gap;
  for (std::size_t i = 0; i < 3; ++i)
  {
    factors[i] = legs_[i].sign * forms.eta[i] + component(along, i);
    rest = rest + factors[i] * component(across, i);
  }
  factors[3] = Enclosed<Real>(select(gap.center < Real(0), Real(-1), Real(1)), Real(0)) * gap;
  factors[4] = aspect_sign_ * rest;
  return factors;
}

template <class Real>
Enclosed<Real> MachineModel<Real>::orientationAtCenter(const MachineForms<Real>& forms) const
{
  return aspect_sign_ * determinantAtCenter(forms.strut[0], forms.strut[1], forms.strut[2]);
}

template <class Real>
template <class Domain>
AffineForm<Real> MachineModel<Real>::joint(std::size_t leg, const MachineForms<Real>& forms, const Domain& box) const
{
  const LegModel& model = legs_[leg];
  AffineVector<Real> along;
  mapBox(model.along, model.center, box, along);
  return component(along, 0) - forms.eta[leg];
}

template <class Real>
template <class Domain>
AffineForm<Real> MachineModel<Real>::limitMargin(std::size_t leg, int side, const MachineForms<Real>& forms,
                                                 const Domain& box) const
{
  const AffineForm<Real> rho = joint(leg, forms, box);
  return (side == 0 ? rho : -rho) + legs_[leg].limit[static_cast<std::size_t>(side)];
}
}  // namespace pkm_workspace
