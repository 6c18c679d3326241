// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/meeting_rails.h"
#include "pkm_workspace/interval/determinant.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
/// det A has the sign of the aspect that is asked for.
template <class Real>
class AspectSign
{
public:
  static constexpr bool BOUNDS_FACTORS = false;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// det A over the lengths of its rows.
  template <class At>
  static void tellLimits(At& at)
  {
    const int sign = at.criterion().wantedSign(at.machine().aspect());
    if (sign == 0 || !at.hasValues())
      return;
    Interval volume = 1.0;
    for (int leg = 0; leg < 3; ++leg)
    {
      const Interval squared_drive = sqr(at.configuration().eta[static_cast<std::size_t>(leg)]);
      volume *= sqrtAboveZero(squaredRow(at.machine().enclosed(leg), squared_drive));
    }
    at.atLeast(ConditionKind::ASPECT, -1, Interval(sign) * at.values().det_a / volume, 0.0);
  }

  AspectSign(const Machine& machine, const Criterion& criterion)
    : is_asked_(criterion.aspect != Criterion::Aspect::BOTH)
    , is_settled_(criterion.settlesAspect(machine.hasTolerances()))
    , sign_(Interval(is_asked_ ? criterion.wantedSign(machine.aspect()) : machine.aspect()))
    , meeting_(machine)
  {}
  template <class Other>
  explicit AspectSign(const AspectSign<Other>& other)
    : is_asked_(other.is_asked_), is_settled_(other.is_settled_), sign_(other.sign_), meeting_(other.meeting_)
  {}

  bool isAsked() const { return is_asked_; }

  /// det A [m^3] times the sign that is asked for, or the machine's own: positive where the aspect is right.
  AffineForm<Real> form(const MachineForms<Real>& forms) const
  {
    return sign_ * determinant(forms.legs[0].row, forms.legs[1].row, forms.legs[2].row);
  }

  /// Whether the three rails meet in one point, so that det A has a double zero on a sphere.
  bool railsMeet() const { return meeting_.exist; }

  /// Forms of which all are positive only where the aspect is right, also next to that sphere: with w_i = s_i e_i, p
  /// counted from o and h_i = |eta_i| + w_i . p, each strut is p + g / h_i w_i, g = L^2 - |p|^2, and
  ///   det A h_1 h_2 h_3 = g^2 (h_1 (w_2 x w_3) . p + h_2 (w_3 x w_1) . p + h_3 (w_1 x w_2) . p + g det(w_1, w_2,
  ///   w_3)).
  /// @pre railsMeet()
  template <class Domain>
  std::array<AffineForm<Real>, 5> factors(const MachineForms<Real>& forms, const Domain& box) const
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
    factors[4] = sign_ * rest;
    return factors;
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (is_asked_ && is_settled_)
      visitor.oneSigned(
          { ConditionKind::ASPECT }, formAtCenter(place.forms), [&] { return form(place.forms); }, 3);
    else if (is_asked_)
      visitor.scalarOr({ ConditionKind::ASPECT }, form(place.forms), 3, railsMeet(),
                       [&] { return factors(place.forms, place.box); });
  }

  /// As visit(), where no other condition settles the sign.
  template <class Place, class Visitor>
  void visitScalar(const Place& place, Visitor& visitor) const
  {
    if (is_asked_)
      visitor.scalar({ ConditionKind::ASPECT }, form(place.forms), 3);
  }

  Real margin(const NearPlace<Real>& place) const
  {
    if (!is_asked_)
      return Real(NO_MARGIN);
    const auto& legs = place.at.legs;
    return sign_.value * dot(legs[0].row, cross(legs[1].row, legs[2].row)) * (place.per_square * place.per_length);
  }

private:
  template <class>
  friend class AspectSign;

  Enclosed<Real> formAtCenter(const MachineForms<Real>& forms) const
  {
    return sign_ * determinantAtCenter(forms.legs[0].row, forms.legs[1].row, forms.legs[2].row);
  }

  bool is_asked_;
  bool is_settled_;  ///< another condition keeps det A from 0, so that one point of a connected region settles its sign
  Enclosed<Real> sign_;
  MeetingRails<Real> meeting_;
};
}  // namespace pkm_workspace
