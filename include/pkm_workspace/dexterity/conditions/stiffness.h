// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// The tool gives way by no more than f / S under any force f: a drive of stiffness k_i and a strut of stiffness
/// kappa_i give way by A^-1 (B^2 K^-1 + N^2 Kappa^-1) A^-T f, so G - S diag(b_i^2 / k_i + n_i^2 / kappa_i) is
/// semidefinite.
template <class Real>
class Stiffness
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// The least eigenvalue of the pencil of G and the compliances.
  template <class At>
  static void tellLimits(At& at)
  {
    const double asked = at.criterion().stiffness_min;
    if (!(asked > 0.0) || !at.hasValues())
      return;
    Criterion unit = at.criterion();
    unit.stiffness_min = 1.0;
    const Stiffness one(at.machine(), unit);
    const LegModels<Real> legs(at.machine(), std::nullopt);
    const MachineForms<Real> forms = legs.evaluate(CenteredBox<Real>(Box{ at.place(), at.place() }));
    std::array<AffineForm<Real>, 3> compliances;
    std::array<Real, 3> inverse;
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      compliances[leg] = -one.lessOf(leg, legs, forms);
      inverse[leg] = Real(1) / std::sqrt(compliances[leg].center);
    }
    const Span<Real> least = pencilEigenvalues(gramMatrix(legs, forms), compliances, inverse)[0];
    at.atLeast(ConditionKind::STIFFNESS_MIN, -1, intersection(Interval(least.lower, least.upper), Interval(0.0, INF)),
               asked);
  }

  Stiffness(const Machine& machine, const Criterion& criterion) : is_asked_(criterion.stiffness_min > 0.0)
  {
    const double least = criterion.stiffness_min;
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
    {
      minus_drive_[leg] =
          -scaled(quotient<Real>(least, criterion.joint_stiffness[leg]), sqr(driveScale(machine.legs()[leg])));
      const double strut = criterion.strut_stiffness[leg];
      minus_strut_[leg] = strut > 0.0 ? -quotient<Real>(least, strut) : Enclosed<Real>();
    }
  }
  template <class Other>
  explicit Stiffness(const Stiffness<Other>& other) : is_asked_(other.is_asked_)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      minus_drive_[leg] = Enclosed<Real>(other.minus_drive_[leg]);
      minus_strut_[leg] = Enclosed<Real>(other.minus_strut_[leg]);
    }
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (!is_asked_)
      return;
    SymmetricForms<Real> matrix = gramMatrix(place.legs, place.forms);
    for (std::size_t leg = 0; leg < 3; ++leg)
      matrix[leg] = matrix[leg] + lessOf(leg, place.legs, place.forms);
    visitor.matrix({ ConditionKind::STIFFNESS_MIN }, matrix);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    if (!is_asked_)
      return Real(NO_MARGIN);
    eigen::Symmetric<Real> matrix = pencilNear(place.legs, place.at, Real(0), Real(1));
    for (std::size_t leg = 0; leg < 3; ++leg)
      matrix[leg] = matrix[leg] + minus_drive_[leg].value * place.at.legs[leg].squared_drive +
                    minus_strut_[leg].value * place.legs.squaredRowNear(leg, place.at.legs[leg].squared_drive);
    return eigen::leastEigenpair(matrix).value * place.per_square;
  }

private:
  template <class>
  friend class Stiffness;

  /// -S (b^2 / k + n^2 / kappa) [m^2].
  AffineForm<Real> lessOf(std::size_t leg, const LegModels<Real>& legs, const MachineForms<Real>& forms) const
  {
    return legs.weighed(leg, forms, minus_drive_[leg], minus_strut_[leg]);
  }

  bool is_asked_;
  std::array<Enclosed<Real>, 3> minus_drive_;  ///< -S / k_i
  std::array<Enclosed<Real>, 3> minus_strut_;  ///< -S / kappa_i, 0 where the strut is rigid
};
}  // namespace pkm_workspace
