// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The kernel for packs of W doubles. Nothing here may be instantiated but on packs: this file is compiled for several
// instruction sets, and the linker keeps one copy of whatever has the same name.

#include "pkm_workspace/dexterity/box_kernel.h"
#include "pkm_workspace/interval/pack.h"

namespace pkm_workspace
{
template <int W>
class PackKernel : public BoxKernel
{
  using Real = Pack<W>;
  using Mask = LaneMask<W>;
  using Point = std::array<Real, 3>;

  struct Verdicts
  {
    Mask inside;
    Mask outside;
  };

public:
  explicit PackKernel(const MachineModel<double>& model) : model_(model)
  {
    int exponent = 0;
    frexp(model.squaredScale(), &exponent);
    for (int power = 0; power < 4; ++power)
      per_scale_[static_cast<std::size_t>(power)] = Real(ldexp(1.0, -exponent / 2 * power));
  }

  std::size_t width() const override { return W; }

  void classify(const Box* boxes, std::size_t count, BoxVerdict* verdicts, AffineForm<double>* worst) const override
  {
    for (std::size_t first = 0; first < count; first += W)
    {
      double lower[3][W], upper[3][W];
      for (std::size_t lane = 0; lane < W; ++lane)
        for (std::size_t k = 0; k < 3; ++k)
        {
          const Box& box = boxes[first + lane < count ? first + lane : count - 1];
          lower[k][lane] = box.lower.data()[k];
          upper[k][lane] = box.upper.data()[k];
        }
      AffineForm<Real> form;
      const Verdicts found = look(CenteredBox<Real>(pointOf(lower), pointOf(upper)), worst ? &form : nullptr);
      for (int lane = 0; lane < W && first + static_cast<std::size_t>(lane) < count; ++lane)
      {
        const std::size_t k = first + static_cast<std::size_t>(lane);
        verdicts[k] = found.outside[lane]  ? BoxVerdict::OUTSIDE
                      : found.inside[lane] ? BoxVerdict::INSIDE
                                           : BoxVerdict::UNDECIDED;
        if (worst)
          worst[k] = laneOf(form, lane);
      }
    }
  }

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
      collect(box.moved(Real(size), gather(offsets + first, count - first)), results + first, count - first);
  }

  void margins(const Eigen::Vector3d& center, double size, const Eigen::Vector3d* offsets, std::size_t count,
               double* results) const override
  {
    for (std::size_t first = 0; first < count; first += W)
    {
      Point p = gather(offsets + first, count - first);
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = Real(center.data()[k]) + Real(size) * p[k];
      const Real margin = model_.margin(p);
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
        results[first + lane] = margin[static_cast<int>(lane)];
    }
  }

private:
  static Point pointOf(const double (&coordinates)[3][W])
  {
    return { Real::load(coordinates[0]), Real::load(coordinates[1]), Real::load(coordinates[2]) };
  }

  /// Vectors side by side; lanes beyond the last repeat it.
  static Point gather(const Eigen::Vector3d* vectors, std::size_t count)
  {
    double coordinates[3][W];
    for (std::size_t lane = 0; lane < W; ++lane)
      for (std::size_t k = 0; k < 3; ++k)
        coordinates[k][lane] = vectors[lane < count ? lane : count - 1].data()[k];
    return pointOf(coordinates);
  }

  static Mask everywhere() { return Real(1.0) > Real(0.0); }

  /// The verdicts on W boxes (design, section 3, items 1 and 2), and, if asked for, the form v^T S v that is lowest.
  Verdicts look(const CenteredBox<Real>& box, AffineForm<Real>* worst) const
  {
    const MachineForms<Real> forms = model_.evaluate(box);
    Verdicts verdicts{ everywhere(), !everywhere() };
    for (std::size_t i = 0; i < 3; ++i)
    {
      verdicts.outside = verdicts.outside | (forms.radicand[i].upper() < model_.floor(i));
      verdicts.inside = verdicts.inside & (forms.radicand[i].lower() > model_.floor(i));
    }
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (int side = 0; side < 2; ++side)
        if (model_.limited(leg, side))
          require(model_.limitMargin(leg, side, forms, box), verdicts);
    if (!any(!verdicts.outside))
      return verdicts;
    if (model_.criterion().set == Criterion::Set::DEXTROUS)
      lookAtFactors(forms, verdicts, worst);
    else if (model_.oriented())
      require(model_.orientation(forms), verdicts);
    return verdicts;
  }

  static void require(const AffineForm<Real>& form, Verdicts& verdicts)
  {
    verdicts.outside = verdicts.outside | (form.upper() < Real(0.0));
    verdicts.inside = verdicts.inside & (form.lower() > Real(0.0));
  }

  void lookAtFactors(const MachineForms<Real>& forms, Verdicts& verdicts, AffineForm<Real>* worst) const
  {
    for (const bool upper : { true, false })
    {
      const SymmetricForms<Real> matrix = upper ? model_.upperMatrix(forms) : model_.lowerMatrix(forms);
      const Mask definite = worst || any(verdicts.inside) ? isPositiveDefinite(matrix) : !everywhere();
      verdicts.inside = verdicts.inside & definite;
      // a vector with v^T S v < 0 exists only where S is not definite at the center
      const Mask open = !(definite | verdicts.outside);
      if (!any(worst ? open : open & !isDefiniteAtCenter(matrix)))
        continue;
      const AffineForm<Real> form = quadraticForm(matrix, leastEigenvector(matrix).vector);
      verdicts.outside = verdicts.outside | (form.upper() < Real(0.0));
      if (worst)
        *worst = select((!definite) & (form.lower() < worst->lower()), form, *worst);
    }
    if (!model_.oriented() || !any(!verdicts.outside))
      return;
    // Where S_min is definite det A has no zero: one point settles its sign.
    const Enclosed<Real> center = model_.orientationAtCenter(forms);
    const Mask wrong = center.upper() < Real(0.0);
    verdicts.outside = verdicts.outside | (verdicts.inside & wrong);
    verdicts.inside = verdicts.inside & (center.lower() > Real(0.0));
    if (any(wrong & !verdicts.outside))
      verdicts.outside = verdicts.outside | (wrong & (model_.orientation(forms).upper() < Real(0.0)));
  }

  void collect(const CenteredBox<Real>& box, NecessaryForms* results, std::size_t count) const
  {
    const MachineForms<Real> forms = model_.evaluate(box);
    Mask violated = !everywhere();
    for (std::size_t i = 0; i < 3; ++i)
      violated = violated | (forms.radicand[i].upper() < model_.floor(i));
    const bool dextrous = model_.criterion().set == Criterion::Set::DEXTROUS;
    begin(results, count, violated, dextrous ? 2 : 0);
    for (std::size_t m = 0; m < 2 && dextrous; ++m)
    {
      SymmetricForms<Real> matrix = m == 0 ? model_.upperMatrix(forms) : model_.lowerMatrix(forms);
      for (AffineForm<Real>& entry : matrix)
        entry = scaled(entry, 2);
      for (std::size_t entry = 0; entry < 6; ++entry)
        for (std::size_t lane = 0; lane < W && lane < count; ++lane)
          results[lane].matrix[m][entry] = laneOf(matrix[entry], static_cast<int>(lane));
      append(quadraticForm(matrix, leastEigenvector(matrix).vector), everywhere(), results, count);
    }
    for (std::size_t i = 0; i < 3 && !dextrous; ++i)
      append(scaled(forms.radicand[i], 2), everywhere(), results, count);
    if (model_.oriented())
      appendOrientation(forms, results, count);
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (int side = 0; side < 2; ++side)
        if (model_.limited(leg, side))
          append(scaled(model_.limitMargin(leg, side, forms, box), 1), everywhere(), results, count);
  }

  /// Where S_min is definite the sign of det A at one point is the one everywhere: its form helps only where it is
  /// wrong.
  void appendOrientation(const MachineForms<Real>& forms, NecessaryForms* results, std::size_t count) const
  {
    Mask useful = everywhere();
    if (model_.criterion().set == Criterion::Set::DEXTROUS)
      useful = model_.orientationAtCenter(forms).lower() < Real(0.0);
    if (any(useful))
      append(scaled(model_.orientation(forms), 3), useful, results, count);
  }

  /// The form over a power of the machine's scale, to be without unit: powers of two, which round nothing.
  AffineForm<Real> scaled(const AffineForm<Real>& form, std::size_t power) const
  {
    const Real factor = per_scale_[power];
    return { form.center * factor,
             { form.gradient[0] * factor, form.gradient[1] * factor, form.gradient[2] * factor },
             form.radius * factor };
  }

  static AffineForm<Real> select(Mask mask, const AffineForm<Real>& a, const AffineForm<Real>& b)
  {
    using pkm_workspace::select;
    return { select(mask, a.center, b.center),
             { select(mask, a.gradient[0], b.gradient[0]), select(mask, a.gradient[1], b.gradient[1]),
               select(mask, a.gradient[2], b.gradient[2]) },
             select(mask, a.radius, b.radius) };
  }

  static AffineForm<double> laneOf(const AffineForm<Real>& form, int lane)
  {
    return { form.center[lane],
             { form.gradient[0][lane], form.gradient[1][lane], form.gradient[2][lane] },
             form.radius[lane] };
  }

  static void begin(NecessaryForms* results, std::size_t count, Mask violated, std::size_t matrices)
  {
    for (std::size_t lane = 0; lane < W && lane < count; ++lane)
    {
      results[lane].violated = violated[static_cast<int>(lane)];
      results[lane].matrices = matrices;
      results[lane].forms = 0;
    }
  }

  static void append(const AffineForm<Real>& form, Mask useful, NecessaryForms* results, std::size_t count)
  {
    for (std::size_t lane = 0; lane < W && lane < count; ++lane)
      if (useful[static_cast<int>(lane)])
        results[lane].form[results[lane].forms++] = laneOf(form, static_cast<int>(lane));
  }

  MachineModel<Real> model_;
  std::array<Real, 4> per_scale_;  ///< powers of about 1 / the longest strut
};
}  // namespace pkm_workspace
