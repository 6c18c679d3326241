// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The kernel for packs of doubles, and for one Precise number. Nothing here may be instantiated but on those: this file
// is compiled for several instruction sets, and the linker keeps one copy of whatever has the same name.

#include "box_look.h"
#include "cut_collector.h"
#include "form_collector.h"
#include "hull_look.h"
#include "tolerated_model.h"

namespace pkm_workspace
{
/// Ends the use of wide registers: what follows would be slower as long as their upper halves are in use, which the
/// compiler does not see to where calls pass masks.
template <class Real>
struct WideRegisters
{
  ~WideRegisters()
  {
#ifdef __AVX__
    __builtin_ia32_vzeroupper();
#endif
  }
};

/// @tparam Model of one machine, or of all within tolerances
template <class Real, class Model = MachineModel<Real>>
class PackKernel : public BoxKernel
{
  static constexpr std::size_t W = Real::WIDTH;

public:
  explicit PackKernel(const Model& model)
    : model_(model), per_length_(powersPerLength(Real(model.legs().squaredScale())))
  {}

  std::size_t width() const override { return W; }

  void classify(const Box* boxes, std::size_t count, BoxVerdict* verdicts, AffineForm<double>* worst,
                const HalfSpace* within) const override
  {
    const WideRegisters<Real> wide;
    for (std::size_t first = 0; first < count; first += W)
    {
      const CenteredBox<Real> box = gather<Real>(boxes + first, count - first);
      Question<Real> question;
      if (within)
        question.slack = slackOf<Real>(within + first, count - first, box);
      question.is_limited = within != nullptr;
      question.wants_worst = worst != nullptr;
      const BoxLook<Real> found = look(model_.evaluate(box), box, question);
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
      {
        const std::size_t k = first + lane;
        verdicts[k] = found.verdict(static_cast<int>(lane));
        if (worst)
          worst[k] = verdicts[k] == BoxVerdict::UNDECIDED ? laneOf(question.worst, static_cast<int>(lane))
                                                          : AffineForm<double>();
      }
    }
  }

  void classify(const SmallHull* hulls, std::size_t count, BoxVerdict* verdicts) const override
  {
    const WideRegisters<Real> wide;
    for (std::size_t first = 0; first < count; first += W)
    {
      HullLook<Real> look(hulls + first, count - first);
      look.visit(model_);
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
        verdicts[first + lane] = look.verdict(static_cast<int>(lane));
    }
  }

  void look(const CurvePiece* pieces, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions) const override;
  void rates(const CurvePiece* pieces, const SkewBox<double>* curvatures, std::size_t count,
             PieceRates* rates) const override;

  void necessaryForms(const CenteredBox<double>& centers, double size, const GrowingVector* offsets, std::size_t count,
                      NecessaryForms* results, FormOrigin* origins) const override
  {
    const WideRegisters<Real> wide;
    CenteredBox<Real> box;
    for (std::size_t k = 0; k < 3; ++k)
    {
      box.center[k] = Real(centers.center[k]);
      box.half_widths[k] = Real(centers.half_widths[k]);
    }
    box.slack = Real(centers.slack);
    for (std::size_t first = 0; first < count; first += W)
      FormCollector<Real>(per_length_, results + first, origins ? origins + first * NecessaryForms::MOST : nullptr,
                          count - first)
          .collect(model_, gatherMoved(box, Real(size), offsets + first, count - first));
  }

  void cuts(const Box* boxes, std::size_t count, BoxCuts* results) const override
  {
    const WideRegisters<Real> wide;
    for (std::size_t first = 0; first < count; first += W)
      CutCollector<Real>(results + first, count - first).collect(model_, gather<Real>(boxes + first, count - first));
  }

  void margins(const Eigen::Vector3d* points, std::size_t count, double* results) const override
  {
    const WideRegisters<Real> wide;
    for (std::size_t first = 0; first < count; first += W)
    {
      const Real margin = model_.margin(gather<Real>(points + first, count - first));
      for (std::size_t lane = 0; lane < W && first + lane < count; ++lane)
        results[first + lane] = margin[static_cast<int>(lane)];
    }
  }

  WorstMachine worst(const Eigen::Vector3d& point) const override
  {
    if constexpr (std::is_same<Model, MachineModel<Real>>::value)
      return {};
    else
    {
      const WideRegisters<Real> wide;
      return model_.worst(gather<Real>(&point, 1));
    }
  }

private:
  /// Looks at W boxes; the rest of the answer is in the question.
  template <class Forms, class Domain>
  BoxLook<Real> look(const Forms& forms, const Domain& box, Question<Real>& question) const
  {
    BoxLook<Real> look(model_, forms, question);
    if (!look.isSettled())
      model_.visit(forms, box, look);
    return look;
  }

  Model model_;
  std::array<Real, 4> per_length_;
};
}  // namespace pkm_workspace

#include "path_look_impl.h"
