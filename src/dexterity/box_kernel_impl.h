// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The kernel for packs of doubles, and for one Precise number. Nothing here may be instantiated but on those: this file
// is compiled for several instruction sets, and the linker keeps one copy of whatever has the same name.

#include "form_collector.h"

namespace pkm_workspace
{
template <class Real>
class PackKernel : public BoxKernel
{
  using Mask = MaskOf<Real>;
  static constexpr std::size_t W = Real::WIDTH;
  using Point = std::array<Real, 3>;

  struct Verdicts
  {
    Mask inside;
    Mask outside;
  };

  /// What is asked of boxes besides their verdicts.
  struct Question
  {
    bool wants_worst = false;
    bool is_limited = false;   ///< only points where the slack is not negative count for INSIDE
    AffineForm<Real> slack{};  ///< offset - normal . p of the half-space
    AffineForm<Real> worst{};  ///< the answer: the lowest form v^T S v
  };

public:
  explicit PackKernel(const MachineModel<Real>& model) : model_(model), collector_(model_) {}

  std::size_t width() const override { return W; }

  void classify(const Box* boxes, std::size_t count, BoxVerdict* verdicts, AffineForm<double>* worst,
                const HalfSpace* within) const override
  {
    for (std::size_t first = 0; first < count; first += W)
    {
      const CenteredBox<Real> box = gather<Real>(boxes + first, count - first);
      Question question;
      if (within)
        question.slack = slackOf<Real>(within + first, count - first, box);
      question.is_limited = within != nullptr;
      question.wants_worst = worst != nullptr;
      const Verdicts found = look(model_.evaluate(box), box, question);
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
      {
        const std::size_t k = first + lane;
        verdicts[k] = verdictOf(found, static_cast<int>(lane));
        if (worst)
          worst[k] = verdicts[k] == BoxVerdict::UNDECIDED ? laneOf(question.worst, static_cast<int>(lane))
                                                          : AffineForm<double>();
      }
    }
  }

  void look(const CurvePiece* pieces, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions) const override;

  void necessaryForms(const CenteredBox<double>& centers, double size, const Eigen::Vector3d* offsets,
                      std::size_t count, NecessaryForms* results) const override
  {
    CenteredBox<Real> box;
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.center[k] = Real(centers.center[k]);
      box.half_widths[k] = Real(centers.half_widths[k]);
    }
    box.slack = Real(centers.slack);
    for (std::size_t first = 0; first < count; first += W)
      collector_.collect(box.moved(Real(size), gather<Real>(offsets + first, count - first)), results + first,
                         count - first);
  }

  void margins(const Eigen::Vector3d& center, double size, const Eigen::Vector3d* offsets, std::size_t count,
               double* results) const override
  {
    for (std::size_t first = 0; first < count; first += W)
    {
      Point p = gather<Real>(offsets + first, count - first);
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = Real(center.data()[k]) + Real(size) * p[k];
      const Real margin = model_.margin(p);
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
        results[first + lane] = margin[static_cast<int>(lane)];
    }
  }

private:
  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  static BoxVerdict verdictOf(const Verdicts& found, int lane)
  {
    return found.outside[lane] ? BoxVerdict::OUTSIDE : found.inside[lane] ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
  }

  /// The verdicts on W boxes (docs/theory.md, affine forms), and the rest of the answer to the question.
  template <class Domain>
  Verdicts look(const MachineForms<Real>& forms, const Domain& box, Question& question) const
  {
    const Criterion& criterion = model_.criterion();
    Verdicts verdicts{ everywhere(), !everywhere() };
    for (std::size_t i = 0; i < 3; ++i)
    {
      verdicts.outside = verdicts.outside | (forms.legs[i].squared_drive.upper() < model_.floor(i));
      if (!criterion.boundsAbove())  // otherwise implied by the diagonal of S_max
        require(forms.legs[i].squared_drive, question, verdicts);
    }
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (int side = 0; side < 2; ++side)
        if (model_.limited(leg, side))
          require(model_.limitMargin(leg, side, forms, box), question, verdicts);
    if (!any(!verdicts.outside))
      return verdicts;
    if (criterion.boundsFactors())
      lookAtFactors(forms, question, verdicts);
    if (model_.oriented() && !criterion.settlesAspect())
      lookAtOrientation(forms, box, question, verdicts);
    else if (model_.oriented() && !question.is_limited && any(!verdicts.outside))
      lookAtAspect(forms, verdicts);
    return verdicts;
  }

  static void require(const AffineForm<Real>& form, const Question& question, Verdicts& verdicts)
  {
    verdicts.outside = verdicts.outside | (form.upper() < Real(0.0));
    Mask holds = form.lower() > Real(0.0);
    if (question.is_limited)
      holds = holds | (lowered(form, multiplier(form, question.slack), question.slack).lower() > Real(0.0));
    verdicts.inside = verdicts.inside & holds;
  }

  /// Near a double zero of det A its factors tell more; boxes alone do well without.
  template <class Domain>
  void lookAtOrientation(const MachineForms<Real>& forms, const Domain& box, const Question& question,
                         Verdicts& verdicts) const
  {
    const Mask before = verdicts.inside;
    require(model_.orientation(forms), question, verdicts);
    const Mask open = before & !(verdicts.inside | verdicts.outside);
    if (!question.is_limited || !model_.railsMeet() || !any(open))
      return;
    Verdicts by_factors{ open, !everywhere() };
    for (const AffineForm<Real>& factor : model_.orientationFactors(forms, box))
      require(factor, question, by_factors);
    verdicts.inside = verdicts.inside | by_factors.inside;
  }

  void lookAtFactors(const MachineForms<Real>& forms, Question& question, Verdicts& verdicts) const
  {
    if (model_.criterion().boundsAbove())
      lookAtMatrix(model_.upperMatrix(forms), true, question, verdicts);
    if (model_.criterion().boundsBelow())
      lookAtMatrix(model_.lowerMatrix(forms), true, question, verdicts);
    if (!model_.criterion().boundsCondition())
      return;
    ConditionForms<Real> condition;
    model_.conditionForms(forms, condition);
    for (const AffineForm<Real>& form : condition.necessary)
      verdicts.outside = verdicts.outside | (form.upper() < Real(0.0));
    lookAtMatrix(condition.upper, false, question, verdicts);
    lookAtMatrix(condition.lower, false, question, verdicts);
  }

  /// @param is_necessary whether points where the matrix is not semidefinite are bad
  static void lookAtMatrix(const SymmetricForms<Real>& matrix, bool is_necessary, Question& question,
                           Verdicts& verdicts)
  {
    const bool counts = question.wants_worst || any(verdicts.inside);
    Mask definite = counts ? isPositiveDefinite(matrix) : !everywhere();
    // a vector with v^T S v < 0 exists only where S is not definite at the center
    const Mask open = !(definite | verdicts.outside);
    if (any(question.wants_worst ? open : open & !isDefiniteAtCenter(matrix)))
      definite = definite | lookAtVector(matrix, definite, is_necessary, question, verdicts);
    verdicts.inside = verdicts.inside & definite;
  }

  /// Tries the vector of the least eigenvalue. @return where the matrix is definite on the half-space
  static Mask lookAtVector(const SymmetricForms<Real>& matrix, Mask definite, bool is_necessary, Question& question,
                           Verdicts& verdicts)
  {
    const Point v = leastEigenvector(matrix).vector;
    AffineForm<Real> form = quadraticForm(matrix, v);
    if (is_necessary)
      verdicts.outside = verdicts.outside | (form.upper() < Real(0.0));
    Mask holds = !everywhere();
    if (question.is_limited)
    {
      // S - slack Y definite on the box: S is, where the slack is not negative. Y = y (v v^T + margin I), of which the
      // margin keeps Y semidefinite after the roundings of its entries.
      const Real y = multiplier(form, question.slack);
      const Real margin = Real(16.0) * rounding::roundoff<Real>();
      SymmetricForms<Real> less = matrix;
      for (std::size_t k = 0; k < 3; ++k)
      {
        less[k] = lowered(less[k], y * (v[k] * v[k] + margin), question.slack);
        less[3 + k] = lowered(less[3 + k], y * v[(k + 1) % 3] * v[(k + 2) % 3], question.slack);
      }
      holds = isPositiveDefinite(less);
      form = quadraticForm(less, v);
    }
    if (question.wants_worst)
    {
      const Mask open = !(definite | holds | verdicts.outside);
      question.worst = select(open & (form.lower() < question.worst.lower()), form, question.worst);
    }
    return holds;
  }

  /// Where psi_1 is bounded from below det A has no zero: one point settles its sign.
  void lookAtAspect(const MachineForms<Real>& forms, Verdicts& verdicts) const
  {
    const Enclosed<Real> center = model_.orientationAtCenter(forms);
    const Mask wrong = center.upper() < Real(0.0);
    verdicts.outside = verdicts.outside | (verdicts.inside & wrong);
    verdicts.inside = verdicts.inside & (center.lower() > Real(0.0));
    if (any(wrong & !verdicts.outside))
      verdicts.outside = verdicts.outside | (wrong & (model_.orientation(forms).upper() < Real(0.0)));
  }

  MachineModel<Real> model_;
  FormCollector<Real> collector_;
};
}  // namespace pkm_workspace

#include "path_look_impl.h"
