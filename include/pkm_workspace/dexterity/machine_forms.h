// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/eigen_witness.h"
#include "pkm_workspace/dexterity/meeting_rails.h"
#include "pkm_workspace/interval/affine_vector.h"
#include "pkm_workspace/interval/definiteness.h"
#include "pkm_workspace/machine/leg_kinds.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// Everything the verdicts need to know about a machine over one box, as affine forms (docs/theory.md).
/// Valid at every point of the box where no b_i^2 is below its floor; b_i^2 itself is valid on the whole box.
template <class Real>
struct MachineForms
{
  std::array<LegState<AffineForm<Real>, AffineVector<Real>>, 3> legs;
  std::array<AffineForm<Real>, 3> gram;  ///< n_2 . n_3, n_1 . n_3, n_1 . n_2 [m^2]

  /// B^2, the squares of b_i [m^2].
  std::array<AffineForm<Real>, 3> squaredDrives() const
  {
    return { legs[0].squared_drive, legs[1].squared_drive, legs[2].squared_drive };
  }
};

/// The legs at one point, in floating point; b_i is 0 where b_i^2 is negative.
template <class Real>
using MachineNumbers = std::array<LegState<Real, PlainVector<Real>>, 3>;

/// The eigenvalues psi_1^2 and psi_3^2 of (J J^T)^-1 at one point, in floating point, and vectors u with
/// A A^T u = psi^2 B^2 u and u^T B^2 u = 1 [1/m].
template <class Real>
struct ExtremeFactors
{
  Eigenpair<Real> least;
  std::array<Real, 3> middle;
  Eigenpair<Real> largest;
};

/// What bounds the condition number psi_3 / psi_1 <= kappa on a box. With one affine level t for psi_1^2 the condition
/// holds wherever A A^T - t B^2 and kappa^2 t B^2 - A A^T are both definite; and for any two vectors u and v it makes
/// kappa^2 (u^T A A^T u)(v^T B^2 v) - (v^T A A^T v)(u^T B^2 u) >= 0, by the quotients of Rayleigh.
template <class Real>
struct ConditionForms
{
  SymmetricForms<Real> lower;                 ///< A A^T - t B^2 [m^2]
  SymmetricForms<Real> upper;                 ///< kappa^2 t B^2 - A A^T [m^2]
  std::array<AffineForm<Real>, 3> necessary;  ///< for three pairs of eigenvectors, the extreme ones first; without unit
};

/// A machine and a criterion, prepared for the evaluation of boxes. Real is double or a multi-precision type.
/// Thread-safe: constant after construction.
template <class Real>
class MachineModel
{
public:
  /// @throws std::invalid_argument when the criterion is not valid
  MachineModel(const Machine& machine, const Criterion& criterion);

  /// The same for another type of number.
  template <class Other>
  explicit MachineModel(const MachineModel<Other>& model);

  const Criterion& criterion() const { return criterion_; }
  /// Whether the criterion asks for one sign of det A.
  bool oriented() const { return criterion_.aspect != Criterion::Aspect::BOTH; }
  /// The square of the longest strut [m^2]: makes margins comparable between machines.
  Real squaredScale() const { return squared_scale_; }

  /// Forms over the box, a CenteredBox or a SkewBox.
  template <class Domain>
  MachineForms<Real> evaluate(const Domain& box) const;
  /// Numbers at the point p [m]: for finding points, not for proving anything.
  MachineNumbers<Real> evaluate(const std::array<Real, 3>& p) const;
  /// n_i^2 [m^2].
  const Enclosed<Real>& squaredRow(std::size_t leg) const;
  /// Where b_i^2 is below this [m^2] the criterion does not hold: n_i^2 / psi_max^2, rounded down, or 0.
  const Real& floor(std::size_t leg) const { return legs_[leg].floor; }

  /// A A^T - mu B^2 [m^2], for a factor - mu.
  SymmetricForms<Real> pencil(const MachineForms<Real>& forms, const Enclosed<Real>& minus_mu) const;
  /// S_min = A A^T - psi_min^2 B^2 [m^2].
  SymmetricForms<Real> lowerMatrix(const MachineForms<Real>& forms) const;
  /// S_max = psi_max^2 B^2 - A A^T [m^2].
  SymmetricForms<Real> upperMatrix(const MachineForms<Real>& forms) const;
  /// A A^T [m^2].
  SymmetricForms<Real> gramMatrix(const MachineForms<Real>& forms) const;
  /// The extreme transmission factors at delta = 0. @pre no b_i^2 is much smaller there than n_i^2
  ExtremeFactors<Real> extremeFactors(const MachineForms<Real>& forms) const;
  /// What the bound on the condition number says over the box.
  void conditionForms(const MachineForms<Real>& forms, ConditionForms<Real>& condition) const;
  /// det A [m^3] times the sign that the criterion's aspect asks for: positive where the aspect is right.
  AffineForm<Real> orientation(const MachineForms<Real>& forms) const;
  /// Whether the three rails meet in one point, so that det A has a double zero on a sphere.
  bool railsMeet() const { return meeting_.exist; }
  /// Forms of which all are positive only where the aspect is right, also next to that sphere. @pre railsMeet()
  template <class Domain>
  std::array<AffineForm<Real>, 5> orientationFactors(const MachineForms<Real>& forms, const Domain& box) const;
  /// orientation() at delta = 0 only.
  Enclosed<Real> orientationAtCenter(const MachineForms<Real>& forms) const;
  /// rho_i [m] over the box.
  template <class Domain>
  AffineForm<Real> joint(std::size_t leg, const MachineForms<Real>& forms, const Domain& box) const;
  /// The least of all that the criterion wants not to be negative at the point p [m], without unit; floating point.
  Real margin(const std::array<Real, 3>& p) const;
  /// The axis along which all rails are known to run, or -1: nothing but joint values changes along it.
  int axisOfRails() const { return axis_of_rails_; }
  /// Whether leg i has a lower (side = 0) or upper (side = 1) limit that the criterion asks for and that the rest of it
  /// does not imply.
  bool limited(std::size_t leg, int side) const { return legs_[leg].limited[static_cast<std::size_t>(side)]; }
  /// rho_i - lower (side = 0) or upper - rho_i (side = 1) [m].
  template <class Domain>
  AffineForm<Real> limitMargin(std::size_t leg, int side, const MachineForms<Real>& forms, const Domain& box) const;

private:
  Real limitMargin(std::size_t leg, const MachineNumbers<Real>& at, const std::array<Real, 3>& p) const;
  Real factorMargin(const MachineNumbers<Real>& at) const;
  ExtremeFactors<Real> extremeFactors(const std::array<Real, 3>& squared_drive, const std::array<Real, 3>& gram) const;
  AffineForm<Real> level(const MachineForms<Real>& forms, const ExtremeFactors<Real>& factors) const;

  template <class>
  friend class MachineModel;

  struct LegModel
  {
    LegOfForms<Real> forms;
    PlainLeg<Real> numbers;
    Real floor = Real(0);
    std::array<bool, 2> limited = { false, false };
    std::array<Enclosed<Real>, 2> limit;  ///< -lower and upper [m]
  };

  Criterion criterion_;
  std::array<LegModel, 3> legs_;
  MeetingRails<Real> meeting_;
  Enclosed<Real> psi_max_squared_;
  Enclosed<Real> minus_psi_min_squared_;
  Enclosed<Real> kappa_squared_;
  Real per_kappa_squared_ = Real(0);  ///< nearly its inverse: only scales
  int axis_of_rails_ = -1;
  Enclosed<Real> aspect_sign_;
  Real squared_scale_ = Real(1);
};

extern template class MachineModel<double>;
}  // namespace pkm_workspace

#include "pkm_workspace/dexterity/condition_forms_impl.h"
#include "pkm_workspace/dexterity/machine_forms_impl.h"
