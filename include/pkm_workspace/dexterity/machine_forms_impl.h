// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definitions of the templates declared in machine_forms.h.

#include "pkm_workspace/dexterity/machine_forms.h"

namespace pkm_workspace
{
template <class Real>
MachineModel<Real>::MachineModel(const Machine& machine, const Criterion& criterion)
  : criterion_(validated(criterion))
  , psi_max_squared_(sqr(Interval(criterion.psi_max)))
  , minus_psi_min_squared_(-sqr(Interval(criterion.psi_min)))
  , aspect_sign_(Interval(criterion.aspect == Criterion::Aspect::OTHER ? -machine.aspect() : machine.aspect()))
  , squared_scale_(machine.scale() * machine.scale())
{
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
    if (criterion.set == Criterion::Set::DEXTROUS)
      model.floor = Real((squared_length / sqr(Interval(criterion.psi_max))).lower());
    if (!criterion.joint_limits)
      continue;
    model.limited = { leg.limits.lower() > -std::numeric_limits<double>::infinity(),
                      leg.limits.upper() < std::numeric_limits<double>::infinity() };
    model.limit[0] = model.limited[0] ? Enclosed<Real>(Interval(-leg.limits.lower())) : Enclosed<Real>();
    model.limit[1] = model.limited[1] ? Enclosed<Real>(Interval(leg.limits.upper())) : Enclosed<Real>();
  }
}

template <class Real>
AffineForm<Real> MachineModel<Real>::radicand(std::size_t leg, const AffineVector<Real>& across) const
{
  return -dot(across, across) + legs_[leg].squared_length;
}

template <class Real>
MachineForms<Real> MachineModel<Real>::evaluate(const CenteredBox<Real>& box) const
{
  MachineForms<Real> forms;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegModel& leg = legs_[i];
    const AffineVector<Real> across = mapBox(leg.projector, leg.center, box);
    forms.radicand[i] = radicand(i, across);
    forms.eta[i] = leg.sign * sqrtAbove(forms.radicand[i], leg.floor);
    forms.strut[i] = addAlong(across, forms.eta[i], leg.axis);
  }
  forms.gram[0] = dot(forms.strut[1], forms.strut[2]);
  forms.gram[1] = dot(forms.strut[0], forms.strut[2]);
  forms.gram[2] = dot(forms.strut[0], forms.strut[1]);
  return forms;
}

template <class Real>
SymmetricForms<Real> MachineModel<Real>::lowerMatrix(const MachineForms<Real>& forms) const
{
  SymmetricForms<Real> matrix;
  for (std::size_t i = 0; i < 3; ++i)
  {
    matrix[i] = minus_psi_min_squared_ * forms.radicand[i] + legs_[i].squared_length;  // |d_i|^2 = L_i^2
    matrix[3 + i] = forms.gram[i];
  }
  return matrix;
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

template <class Real>
AffineForm<Real> MachineModel<Real>::orientationAtCenter(const MachineForms<Real>& forms) const
{
  return aspect_sign_ * determinant(atCenter(forms.strut[0]), atCenter(forms.strut[1]), atCenter(forms.strut[2]));
}

template <class Real>
AffineForm<Real> MachineModel<Real>::joint(std::size_t leg, const MachineForms<Real>& forms,
                                           const CenteredBox<Real>& box) const
{
  const LegModel& model = legs_[leg];
  return component(mapBox(model.along, model.center, box), 0) - forms.eta[leg];
}

template <class Real>
AffineForm<Real> MachineModel<Real>::limitMargin(std::size_t leg, int side, const MachineForms<Real>& forms,
                                                 const CenteredBox<Real>& box) const
{
  const AffineForm<Real> rho = joint(leg, forms, box);
  return (side == 0 ? rho : -rho) + legs_[leg].limit[static_cast<std::size_t>(side)];
}
}  // namespace pkm_workspace
