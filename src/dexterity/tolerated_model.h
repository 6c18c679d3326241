// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that stands for all machines within tolerances as MachineModel does for one.

#include "worst_finder.h"

namespace pkm_workspace
{
/// How far a point is from violating the conditions, in floating point, without unit: visits them at the point.
template <class Base>
class MarginLook
{
public:
  /// @param per_length powers of 1 / the longest strut, 0 to 3
  explicit MarginLook(const std::array<Base, 4>& per_length) : per_length_(per_length) {}

  Base margin() const { return margin_; }
  static constexpr bool isSettled() { return false; }

  void scalar(const Subject& /*subject*/, const AffineForm<Base>& form, int power) { take(form.center, power); }

  template <class Alternative>
  void scalarOr(const Subject& subject, const AffineForm<Base>& form, int power, bool /*exists*/,
                const Alternative& /*alternative*/)
  {
    scalar(subject, form, power);
  }

  template <class Enough>
  void anyOf(const Subject& /*subject*/, const AlternativeForms<Base>& forms, int power, const Enough& /*enough*/)
  {
    Base most = forms.form[0].center;
    for (std::size_t k = 1; k < forms.count; ++k)
      most = max(most, forms.form[k].center);
    take(most, power);
  }

  static constexpr void sufficient(const SymmetricForms<Base>& /*matrix*/) {}
  template <class Parts>
  static constexpr void sufficientOr(const SymmetricForms<Base>& /*matrix*/, const Parts& /*parts*/)
  {}
  void necessary(const Subject& /*subject*/, const SymmetricForms<Base>& matrix)
  {
    take(leastEigenvector(matrix).value, 2);
  }
  void necessary(const Subject& /*subject*/, const PlainVector<Base>& /*u*/, const PlainVector<Base>& /*v*/,
                 const AffineForm<Base>& form, int power)
  {
    take(form.center, power);
  }

  template <class Form>
  void oneSigned(const Subject& /*subject*/, const Enclosed<Base>& center, const Form& /*form*/, int power)
  {
    take(center.value, power);
  }

private:
  void take(const Base& value, int power)
  {
    margin_ = min(margin_, value * per_length_[static_cast<std::size_t>(power)]);
  }

  const std::array<Base, 4>& per_length_;
  Base margin_ = Base(NO_MARGIN);
};

/// All machines within tolerances and a criterion, prepared for the evaluation of boxes: what visitors are told is
/// about the worst machine at each point. Base is a pack of doubles.
template <class Base>
class ToleratedModel
{
  using Worst = WorstParameters<Base>;
  using Real = typename Worst::Real;

public:
  ToleratedModel(const MachineModel<double>& all, const LegSpreads& spreads) : model_(all, spreads), worst_(spreads)
  {
    const Base per_length = Base(1) / sqrt(Base(model_.legs().squaredScale()));
    per_length_ = { Base(1), per_length, per_length * per_length, per_length * per_length * per_length };
  }

  const LegModels<Real>& legs() const { return model_.legs(); }

  template <class Domain>
  MachineForms<Real> evaluate(const Domain& box) const
  {
    return model_.evaluate(lifted(box));
  }

  AffineForm<Base> squaredDrive(const MachineForms<Real>& forms, std::size_t leg) const
  {
    return worst_.of(forms.legs[leg].squared_drive);
  }
  Base floor(std::size_t leg) const { return Base(model_.floor(leg)); }

  template <class Domain, class Visitor>
  void visit(const MachineForms<Real>& forms, const Domain& box, Visitor& visitor) const
  {
    WorstCase<Base, Visitor> worst_case(worst_, visitor);
    model_.visit(forms, lifted(box), worst_case);
  }

  Base margin(const PlainVector<Base>& p) const
  {
    const CenteredBox<Base> point(p, p);
    const MachineForms<Real> forms = evaluate(point);
    Base reach(NO_MARGIN);
    for (std::size_t leg = 0; leg < 3; ++leg)
      reach = min(reach, (squaredDrive(forms, leg).center - floor(leg)) * per_length_[2]);
    MarginLook<Base> look(per_length_);
    visit(forms, point, look);
    return select(reach < Base(0), reach, min(reach, look.margin()));
  }

  WorstMachine worst(const PlainVector<Base>& p) const
  {
    const CenteredBox<Real> point = lifted(CenteredBox<Base>(p, p));
    const MachineForms<Real> forms = model_.evaluate(point);
    WorstFinder<Base> finder(worst_, per_length_);
    for (std::size_t leg = 0; leg < 3; ++leg)
      finder.scalar({ ConditionKind::REACH, leg }, forms.legs[leg].squared_drive, 2);
    model_.visit(forms, point, finder);
    return finder.found();
  }

  /// The box in the type of number that forms are made of.
  static CenteredBox<Real> lifted(const CenteredBox<Base>& box)
  {
    CenteredBox<Real> result;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.center[k] = Real(box.center[k]);
      result.half_widths[k] = Real(box.half_widths[k]);
    }
    result.slack = Real(box.slack);
    return result;
  }
  static SkewBox<Real> lifted(const SkewBox<Base>& box)
  {
    SkewBox<Real> result;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.center[k] = Real(box.center[k]);
      for (std::size_t j = 0; j < 3; ++j)
        result.edges[k][j] = Real(box.edges[k][j]);
    }
    result.slack = Real(box.slack);
    return result;
  }

private:
  MachineModel<Real> model_;
  Worst worst_;
  std::array<Base, 4> per_length_;
};
}  // namespace pkm_workspace
