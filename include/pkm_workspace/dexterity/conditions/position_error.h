// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/condition.h"
#include "pkm_workspace/dexterity/conditions/built_error.h"
#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/dexterity/pencil_forms.h"
#include "pkm_workspace/interval/enclosed_constants.h"

namespace pkm_workspace
{
/// The tool is nowhere farther than E from where it should be, to first order, while each joint is off by no more than
/// its eps_i: the error A^-1 y with y_i = +-b_i eps_i is longest at a corner of that box, so G - y y^T / E^2 is
/// semidefinite for four patterns of signs.
///
/// Of a machine with tolerances: the tool stands nowhere farther than E from the point at which a controller that takes
/// the machine for the nominal one believes it to be, on any machine within them, with errors of the joints besides;
/// not to first order, but with all that follows (docs/theory.md). The points are then those of the controller.
template <class Real>
class PositionError
{
public:
  static constexpr bool BOUNDS_FACTORS = true;
  static std::optional<Interval> steepest(const Machine& /*machine*/, const Criterion& /*criterion*/)
  {
    return std::nullopt;
  }
  /// The longest of the four sums +-b_i eps_i (n_j x n_k) / det A.
  template <class At>
  static void tellLimits(At& at)
  {
    const Criterion& criterion = at.criterion();
    if (!(criterion.position_error_max > 0.0) || !at.hasValues())
      return;
    const Configuration& there = at.configuration();
    IntervalVector reach;
    for (std::size_t leg = 0; leg < 3; ++leg)
      reach[leg] = Interval(criterion.joint_error_max[leg]) * driveScale(at.machine().legs()[leg]) * there.eta[leg];
    at.atMost(
        ConditionKind::POSITION_ERROR_MAX, -1,
        at.machine().hasTolerances() ? errorOfBuilt(at.machine(), criterion, at.place()) : largestError(there, reach),
        criterion.position_error_max);
  }

  PositionError(const Machine& machine, const Criterion& criterion) : is_asked_(criterion.position_error_max > 0.0)
  {
    if (is_asked_ && machine.hasTolerances())
      built_.emplace(machine, criterion);
    for (std::size_t leg = 0; is_asked_ && leg < 3; ++leg)
      share_[leg] = scaled(quotient<Real>(criterion.joint_error_max[leg], criterion.position_error_max),
                           driveScale(machine.legs()[leg]));
  }
  template <class Other>
  explicit PositionError(const PositionError<Other>& other) : is_asked_(other.is_asked_)
  {
    if (other.built_)
      built_.emplace(*other.built_);
    for (std::size_t leg = 0; leg < 3; ++leg)
      share_[leg] = Enclosed<Real>(other.share_[leg]);
  }

  template <class Place, class Visitor>
  void visit(const Place& place, Visitor& visitor) const
  {
    if (!is_asked_)
      return;
    SymmetricForms<Real> gram, product;  // G and y y^T / E^2, all signs positive
    if (built_)
      addBuilt(built_->evaluate(place.box, floorsOf(place.legs)), gram, product);
    else
      addJoints(place, gram, product);
    for (const auto& signs : SIGNS)
    {
      SymmetricForms<Real> matrix = gram;
      for (std::size_t i = 0; i < 3; ++i)
        matrix[3 + i] =
            signs[(i + 1) % 3] * signs[(i + 2) % 3] > 0.0 ? gram[3 + i] - product[3 + i] : gram[3 + i] + product[3 + i];
      visitor.matrix({ ConditionKind::POSITION_ERROR_MAX }, matrix);
    }
  }

  Real margin(const NearPlace<Real>& place) const
  {
    using std::min;
    Real least(NO_MARGIN);
    if (!is_asked_)
      return least;
    if (built_)
      return marginOfBuilt(place);
    for (const auto& signs : SIGNS)
    {
      std::array<Real, 3> y;
      for (std::size_t i = 0; i < 3; ++i)
        y[i] = Real(signs[i]) * share_[i].value * place.at.legs[i].drive;
      eigen::Symmetric<Real> matrix = pencilNear(place.legs, place.at, Real(0), Real(1));
      for (std::size_t i = 0; i < 3; ++i)
      {
        matrix[i] = matrix[i] - y[i] * y[i];
        matrix[3 + i] = matrix[3 + i] - y[(i + 1) % 3] * y[(i + 2) % 3];
      }
      least = min(least, eigen::leastEigenpair(matrix).value * place.per_square);
    }
    return least;
  }

private:
  template <class>
  friend class PositionError;

  /// All patterns but for a common sign.
  static constexpr double SIGNS[4][3] = {
    { 1.0, 1.0, 1.0 }, { -1.0, 1.0, 1.0 }, { 1.0, -1.0, 1.0 }, { 1.0, 1.0, -1.0 }
  };

  template <class Place>
  void addJoints(const Place& place, SymmetricForms<Real>& gram, SymmetricForms<Real>& product) const
  {
    gram = gramMatrix(place.legs, place.forms);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      gram[i] = gram[i] - share_[i] * share_[i] * place.forms.legs[i].squared_drive;
      product[3 + i] = share_[j] * share_[k] * (place.forms.legs[j].drive * place.forms.legs[k].drive);
    }
  }

  void addBuilt(const typename BuiltError<Real>::Forms& forms, SymmetricForms<Real>& gram,
                SymmetricForms<Real>& product) const
  {
    gram = forms.gram;
    for (std::size_t i = 0; i < 3; ++i)
    {
      gram[i] = gram[i] - built_->perSquare() * (forms.reach[i] * forms.reach[i]);
      product[3 + i] = built_->perSquare() * (forms.reach[(i + 1) % 3] * forms.reach[(i + 2) % 3]);
    }
  }

  static std::array<Real, 3> floorsOf(const LegModels<Real>& legs)
  {
    return { legs.floor(0), legs.floor(1), legs.floor(2) };
  }

  Real marginOfBuilt(const NearPlace<Real>& place) const
  {
    using std::min;
    SymmetricForms<Real> gram, product;
    addBuilt(built_->evaluate(CenteredBox<Real>(place.p, place.p), floorsOf(place.legs)), gram, product);
    Real least(NO_MARGIN);
    for (const auto& signs : SIGNS)
    {
      eigen::Symmetric<Real> matrix;
      for (std::size_t i = 0; i < 3; ++i)
      {
        matrix[i] = gram[i].center;
        matrix[3 + i] = gram[3 + i].center - Real(signs[(i + 1) % 3] * signs[(i + 2) % 3]) * product[3 + i].center;
      }
      least = min(least, eigen::leastEigenpair(matrix).value * place.per_square);
    }
    return least;
  }

  bool is_asked_;
  std::optional<BuiltError<Real>> built_;  ///< of a machine with tolerances
  std::array<Enclosed<Real>, 3> share_;    ///< eps_i / E
};
}  // namespace pkm_workspace
