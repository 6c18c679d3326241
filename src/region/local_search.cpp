// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/local_search.h"

#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/eigen_witness.h"

namespace pkm_workspace
{
namespace
{
constexpr int MAX_STEPS = 60;
constexpr int CUT_ROUNDS = 6;
constexpr double PENALTY = 8.0;      ///< what a violation costs against size
constexpr double DIFFERENCE = 1e-7;  ///< half width of the boxes that give gradients, relative to the longest strut
constexpr double SMALLEST_TRUST = 1e-12;  ///< relative to the longest strut
}  // namespace

LocalSearch::LocalSearch(const BoxTest& test, const Shape& shape, const Box& centers)
  : test_(test)
  , shape_(shape)
  , centers_(centers)
  , scale_(std::sqrt(test.model().squaredScale()))
  , reach_(shape.halfExtents().maxCoeff())
{}

LocalSearch::Step LocalSearch::assess(const Candidate& candidate, const std::vector<Eigen::Vector3d>& witnesses) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& k : witnesses)
    least = std::min(least, test_.margin(candidate.center + candidate.size * k));
  return { candidate, scale_ * std::max(0.0, -least) };
}

double LocalSearch::merit(const Step& step) const
{
  return reach_ * step.candidate.size - PENALTY * step.violation;
}

/// Appends form(p) >= 0 around p = center + size * witness, in steps of the trust region. Lengths of the form's
/// gradient are those of the small box that it was evaluated on.
void LocalSearch::addRow(const AffineForm<double>& form, double scale, double trust, const Eigen::Vector3d& witness)
{
  const double unit = scale_ / (scale * DIFFERENCE * scale_);  // to a length [m] per [m]
  LinearProgramme<5>::Row row{ scale_ * form.center / scale, {} };
  for (std::size_t j = 0; j < 3; ++j)
  {
    const double slope = form.gradient[j] * unit * trust;
    row.slope[j] = slope;
    row.slope[3] += slope * witness[static_cast<int>(j)] / reach_;
  }
  row.offset += 0.5 * slack_;  // the unknown violation runs from 0 to slack_
  row.slope[4] = 0.5 * slack_;
  programme_.add(row);
}

void LocalSearch::linearize(const Candidate& from, double trust, const Eigen::Vector3d& witness)
{
  const MachineModel<double>& model = test_.model();
  CenteredBox<double> box(Box{ from.center, from.center });
  box = box.moved(from.size, witness);
  box.half_widths.fill(DIFFERENCE * scale_);
  const MachineForms<double> forms = model.evaluate(box);
  const double squared = model.squaredScale();
  for (std::size_t i = 0; i < 3; ++i)
  {
    AffineForm<double> reach = forms.radicand[i];
    reach.center -= model.floor(i);
    addRow(reach, squared, trust, witness);
  }
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (int side = 0; side < 2; ++side)
      if (model.limited(leg, side))
        addRow(model.limitMargin(leg, side, forms, box), scale_, trust, witness);
  if (model.oriented())
    addRow(model.orientation(forms), squared * scale_, trust, witness);
  if (model.criterion().set != Criterion::Set::DEXTROUS)
    return;
  for (const auto& matrix : { model.upperMatrix(forms), model.lowerMatrix(forms) })
  {
    addRow(quadraticForm(matrix, leastEigenvector(matrix).vector), squared, trust, witness);
    matrices_.push_back(matrix);
    matrix_witnesses_.push_back(witness);
  }
}

/// Adds a row for every matrix that is not semidefinite at the programme's optimum.
bool LocalSearch::addCuts(double trust)
{
  const auto& x = programme_.point();
  const double squared = test_.model().squaredScale();
  bool added = false;
  for (std::size_t m = 0; m < matrices_.size(); ++m)
  {
    std::array<double, 3> delta;
    for (std::size_t j = 0; j < 3; ++j)
      delta[j] = trust * (x[j] + x[3] * matrix_witnesses_[m][static_cast<int>(j)] / reach_) / (DIFFERENCE * scale_);
    const auto pair = leastEigenvector(matrices_[m], delta);
    if (pair.value * scale_ / squared > -1e-3 * trust)
      continue;
    addRow(quadraticForm(matrices_[m], pair.vector), squared, trust, matrix_witnesses_[m]);
    added = true;
  }
  return added;
}

Candidate LocalSearch::propose(const Step& step, double trust, const std::vector<Eigen::Vector3d>& witnesses)
{
  const Candidate& from = step.candidate;
  slack_ = 2.0 * step.violation + 4.0 * trust;
  matrices_.clear();
  matrix_witnesses_.clear();
  programme_.reset({ 0.0, 0.0, 0.0, trust, -0.5 * PENALTY * slack_ });
  for (const Eigen::Vector3d& k : witnesses)
    linearize(from, trust, k);
  for (int round = 0; round < CUT_ROUNDS; ++round)
    if (!programme_.solve() || !addCuts(trust))
      break;
  const auto& x = programme_.point();
  const Eigen::Vector3d center = from.center + trust * Eigen::Vector3d(x[0], x[1], x[2]);
  return { center.cwiseMax(centers_.lower).cwiseMin(centers_.upper), std::max(0.0, from.size + trust * x[3] / reach_) };
}

Candidate LocalSearch::climb(const Candidate& start, const std::vector<Eigen::Vector3d>& witnesses)
{
  Step best = assess(start, witnesses);
  double trust = 0.2 * scale_;
  for (int step = 0; step < MAX_STEPS && trust > SMALLEST_TRUST * scale_; ++step)
  {
    const Step next = assess(propose(best, trust, witnesses), witnesses);
    const double gain = merit(next) - merit(best);
    if (gain <= 0.0)
    {
      trust *= 0.25;
      continue;
    }
    const double move = std::max((next.candidate.center - best.candidate.center).cwiseAbs().maxCoeff(),
                                 reach_ * std::abs(next.candidate.size - best.candidate.size));
    best = next;
    trust = move > 0.5 * trust ? std::min(2.0 * trust, scale_) : std::max(2.0 * move, 0.25 * trust);
  }
  while (best.violation > 0.0 && best.candidate.size > 0.0)
  {
    const double reduction = std::max(2.0 * best.violation / reach_, 1e-15 * scale_);
    best = assess({ best.candidate.center, std::max(0.0, best.candidate.size - reduction) }, witnesses);
  }
  return best.violation > 0.0 ? Candidate{ best.candidate.center, 0.0 } : best.candidate;
}
}  // namespace pkm_workspace
