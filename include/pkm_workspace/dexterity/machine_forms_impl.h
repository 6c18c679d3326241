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
  for (int axis = 0; machine.hasParallelRails() && axis < 3; ++axis)
    if (abs(machine.leg(0).axis[static_cast<std::size_t>(axis)]) == Interval(1.0))
      axis_of_rails_ = axis;
  const std::array<Interval, 3> limits = limitsThatBind(machine, criterion);
  for (int i = 0; i < 3; ++i)
  {
    const EnclosedLeg leg = enclosedLeg(machine, i);
    LegModel& model = legs_[static_cast<std::size_t>(i)];
    model.forms = ofForms<Real>(leg);
    model.numbers = plain<Real>(model.forms);
    if (criterion.boundsAbove())
      model.floor = Real((pkm_workspace::squaredRow(leg) / sqr(criterion.largestFactor())).lower());
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
  , axis_of_rails_(model.axis_of_rails_)
  , aspect_sign_(model.aspect_sign_)
  , squared_scale_(model.squared_scale_)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& from = model.legs_[i];
    LegModel& to = legs_[i];
    to.forms = ofForms<Real>(from.forms);
    to.numbers = plain<Real>(to.forms);
    to.floor = Real(from.floor);
    to.limited = from.limited;
    to.limit = { Enclosed<Real>(from.limit[0]), Enclosed<Real>(from.limit[1]) };
  }
}

template <class Real>
const Enclosed<Real>& MachineModel<Real>::squaredRow(std::size_t leg) const
{
  return pkm_workspace::squaredRow(legs_[leg].forms);
}

template <class Real>
template <class Domain>
MachineForms<Real> MachineModel<Real>::evaluate(const Domain& box) const
{
  MachineForms<Real> forms;
  auto& legs = forms.legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto root = [&floor = legs_[i].floor](const AffineForm<Real>& x) { return sqrtAbove(x, floor); };
    pkm_workspace::evaluate(legs_[i].forms, box, root, legs[i]);
  }
  forms.gram[0] = dot(legs[1].row, legs[2].row);
  forms.gram[1] = dot(legs[0].row, legs[2].row);
  forms.gram[2] = dot(legs[0].row, legs[1].row);
  return forms;
}

template <class Real>
MachineNumbers<Real> MachineModel<Real>::evaluate(const std::array<Real, 3>& p) const
{
  using std::max;
  using std::sqrt;
  MachineNumbers<Real> legs;
  for (std::size_t i = 0; i < 3; ++i)
    pkm_workspace::evaluate(
        legs_[i].numbers, p, [](const Real& x) { return sqrt(max(x, Real(0))); }, legs[i]);
  return legs;
}

template <class Real>
Real MachineModel<Real>::margin(const std::array<Real, 3>& p) const
{
  using std::min;
  using std::sqrt;
  const MachineNumbers<Real> at = evaluate(p);
  const Real per_square = Real(1) / squared_scale_;
  const Real per_length = sqrt(per_square);
  Real reach = at[0].squared_drive - legs_[0].floor;
  for (std::size_t i = 1; i < 3; ++i)
    reach = min(reach, at[i].squared_drive - legs_[i].floor);
  reach = reach * per_square;
  Real least = reach;
  for (std::size_t i = 0; i < 3; ++i)
    if (legs_[i].limited[0] || legs_[i].limited[1])
      least = min(least, limitMargin(i, at, p) * per_length);
  if (oriented())
    least = min(least, aspect_sign_.value * dot(at[0].row, cross(at[1].row, at[2].row)) * (per_square * per_length));
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
  const Real rho = jointOf(model.numbers, p, at[leg]);
  const Real above = rho + model.limit[0].value;
  const Real below = model.limit[1].value - rho;
  return !model.limited[1] ? above : !model.limited[0] ? below : min(above, below);
}

/// The least eigenvalue of S_min and S_max in squared struts, and psi_1^2 - psi_3^2 / kappa_max^2.
template <class Real>
Real MachineModel<Real>::factorMargin(const MachineNumbers<Real>& at) const
{
  using std::min;
  const std::array<Real, 3> gram = { dot(at[1].row, at[2].row), dot(at[0].row, at[2].row), dot(at[0].row, at[1].row) };
  eigen::Symmetric<Real> upper;
  eigen::Symmetric<Real> lower;
  for (std::size_t i = 0; i < 3; ++i)
  {
    upper[i] = psi_max_squared_.value * at[i].squared_drive - squaredRow(i).value;
    lower[i] = minus_psi_min_squared_.value * at[i].squared_drive + squaredRow(i).value;
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
    const ExtremeFactors<Real> factors =
        extremeFactors({ at[0].squared_drive, at[1].squared_drive, at[2].squared_drive }, gram);
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
    matrix[i] = minus_mu * forms.legs[i].squared_drive + squaredRow(i);
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
    matrix[i] = psi_max_squared_ * forms.legs[i].squared_drive + -squaredRow(i);
    matrix[3 + i] = -forms.gram[i];
  }
  return matrix;
}

template <class Real>
AffineForm<Real> MachineModel<Real>::orientation(const MachineForms<Real>& forms) const
{
  return aspect_sign_ * determinant(forms.legs[0].row, forms.legs[1].row, forms.legs[2].row);
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
  mapOffset(meeting_.identity, meeting_.center, box, from_center);
  mapOffset(meeting_.along, meeting_.center, box, along);
  mapOffset(meeting_.across, meeting_.center, box, across);
  std::array<AffineForm<Real>, 5> factors;
  const AffineForm<Real> gap = -squaredNorm(from_center) + meeting_.squared_length;
  AffineForm<Real> rest = meeting_.volume * gap;
  for (std::size_t i = 0; i < 3; ++i)
  {
    factors[i] = meeting_.sign[i] * forms.legs[i].drive + component(along, i);
    rest = rest + factors[i] * component(across, i);
  }
  factors[3] = Enclosed<Real>(select(gap.center < Real(0), Real(-1), Real(1)), Real(0)) * gap;
  factors[4] = aspect_sign_ * rest;
  return factors;
}

template <class Real>
Enclosed<Real> MachineModel<Real>::orientationAtCenter(const MachineForms<Real>& forms) const
{
  return aspect_sign_ * determinantAtCenter(forms.legs[0].row, forms.legs[1].row, forms.legs[2].row);
}

template <class Real>
template <class Domain>
AffineForm<Real> MachineModel<Real>::joint(std::size_t leg, const MachineForms<Real>& forms, const Domain& box) const
{
  return jointOf(legs_[leg].forms, box, forms.legs[leg]);
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
