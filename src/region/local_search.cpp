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
constexpr double MOST_TURN = 0.3;    ///< in one step [rad]
constexpr double SMALLEST_TRUST = 1e-12;  ///< relative to the longest strut
}  // namespace

LocalSearch::LocalSearch(const BoxTest& test, const Shape& shape, const WitnessPoints& witnesses, const Box& centers,
                         const Interval& angles, const RailTravel* travel)
  : test_(test)
  , shape_(shape)
  , witnesses_(witnesses)
  , centers_(centers)
  , angles_(angles)
  , travel_(travel)
  , spheres_(shape.ownProof() ? std::vector<StrutSphere>() : test.spheres())
  , scale_(std::sqrt(test.model().legs().squaredScale()))
  , reach_(shape.halfExtents().per_size.maxCoeff())
{}

LocalSearch::Step LocalSearch::assess(const Candidate& candidate)
{
  const std::vector<Eigen::Vector3d> points =
      pointsOf(candidate.placesOf(witnesses_.ofShape()), candidate.center, candidate.size);
  margins_.resize(points.size());
  test_.kernel().margins(points.data(), points.size(), margins_.data());
  double violation = -scale_ * *std::min_element(margins_.begin(), margins_.end());
  for (const Eigen::Vector3d& point : witnesses_.keptOut(candidate.center, candidate.angle, bad_))
    violation = std::max(violation, exitOf(candidate, point).depth);
  violation = std::max(violation, excessOf(candidate));
  return { candidate, std::max(0.0, violation) };
}

/// Whether the region has a point within the sphere and in its cone: then all that it has in the cone has to be within.
bool LocalSearch::reachesInto(const StrutSphere& sphere, const Candidate& candidate) const
{
  const Eigen::Vector3d nearest = shape_.nearest(sphere.center(), candidate.center, candidate.size);
  const CenteredBox<double> there(Box{ nearest, nearest });
  return nearest == sphere.center() || (sphere.hasInCone(there) && sphere.excess(there).center < 0.0);
}

/// How far the worst witness point is beyond a sphere that the region reaches into [m].
double LocalSearch::excessOf(const Candidate& candidate) const
{
  double excess = 0.0;
  for (const StrutSphere& sphere : spheres_)
    if (reachesInto(sphere, candidate))
      for (const Eigen::Vector3d& point :
           pointsOf(candidate.placesOf(witnesses_.ofShape()), candidate.center, candidate.size))
      {
        const CenteredBox<double> there(Box{ point, point });
        if (sphere.hasInCone(there))
          excess = std::max(excess, sphere.radius() * sphere.excess(there).center);
      }
  return excess;
}

/// Appends rows that keep the region within the spheres that it reaches into.
void LocalSearch::addSpheres(double trust)
{
  CenteredBox<double> box(Box{ from_.center, from_.center });
  box.half_widths.fill(DIFFERENCE * scale_);
  for (const StrutSphere& sphere : spheres_)
    if (reachesInto(sphere, from_))
      for (std::size_t k = 0; k < places_.size(); ++k)
      {
        const CenteredBox<double> there = box.moved(from_.size, places_[k]);
        if (sphere.hasInCone(there))
          addRow(-sphere.excess(there), trust, k);
      }
}

LocalSearch::Exit LocalSearch::exitOf(const Candidate& candidate, const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d center = travel_ ? travel_->placeOf(candidate.center) : candidate.center;
  const Eigen::Vector3d offset = turnedAboutZ(point - center, -candidate.angle);  // seen from the region
  const Eigen::Vector3d normal = shape_.exit(center + offset, center, candidate.size);
  const Growing<double> support = shape_.support(normal);
  return { turnedAboutZ(normal, candidate.angle), support.per_size, support.at(candidate.size) - normal.dot(offset),
           normal.y() * offset.x() - normal.x() * offset.y() };
}

/// Appends rows that keep bad points out of the region, beyond the side that each is nearest to.
void LocalSearch::addExits(double trust)
{
  for (const Eigen::Vector3d& point : witnesses_.keptOut(from_.center, from_.angle, bad_))
  {
    Exit exit = exitOf(from_, point);
    if (travel_)
      exit.normal = travel_->slopeOfPlace(exit.normal);
    LinearProgramme<6>::Row row{ 0.5 * slack_ - exit.depth, {} };
    for (std::size_t j = 0; j < 3; ++j)
      row.slope[j] = -trust * exit.normal[static_cast<int>(j)];
    row.slope[3] = -trust * exit.support / reach_;
    row.slope[4] = 0.5 * slack_;
    row.slope[5] = -turn_ * exit.turn;
    programme_.add(row);
  }
}

double LocalSearch::merit(const Step& step) const
{
  return reach_ * step.candidate.size - PENALTY * step.violation;
}

/// How far the witness goes with the largest turn [m].
Eigen::Vector3d LocalSearch::sweepOf(std::size_t witness) const
{
  const Eigen::Vector3d offset = places_[witness].at(from_.size);
  return turn_ * Eigen::Vector3d(-offset.y(), offset.x(), 0.0);
}

/// Appends form(p) >= 0 around the place p of the witness, in steps of the trust region. Lengths of the form's
/// gradient are those of the small box that it was evaluated on.
void LocalSearch::addRow(const AffineForm<double>& form, double trust, std::size_t witness)
{
  const Eigen::Vector3d growth = places_[witness].per_size / reach_;
  const Eigen::Vector3d sweep = sweepOf(witness) / trust;
  const double unit = trust / DIFFERENCE;
  LinearProgramme<6>::Row row{ scale_ * form.center, {} };
  for (std::size_t j = 0; j < 3; ++j)
  {
    const double slope = form.gradient[j] * unit;
    row.slope[j] = slope;
    row.slope[3] += slope * growth[static_cast<int>(j)];
    row.slope[5] += slope * sweep[static_cast<int>(j)];
  }
  row.offset += 0.5 * slack_;  // the unknown violation runs from 0 to slack_
  row.slope[4] = 0.5 * slack_;
  double reach = 0.0;  // of the slope within the unit cube: most rows bind nowhere in it
  for (const double slope : row.slope)
    reach += std::abs(slope);
  if (row.offset < reach && std::isfinite(row.offset) && std::isfinite(reach))
    programme_.add(row);
}

void LocalSearch::linearize(double trust)
{
  CenteredBox<double> box(Box{ from_.center, from_.center });
  box.half_widths.fill(DIFFERENCE * scale_);
  necessary_.resize(places_.size());
  test_.kernel().necessaryForms(box, from_.size, places_.data(), places_.size(), necessary_.data());
  for (std::size_t k = 0; k < places_.size(); ++k)
    for (std::size_t row = 0; row < necessary_[k].forms; ++row)
      addRow(necessary_[k].form[row], trust, k);
  addExits(trust);
  addSpheres(trust);
}

/// Adds a row for every matrix that is not semidefinite at the programme's optimum.
bool LocalSearch::addCuts(double trust)
{
  const auto& x = programme_.point();
  const Eigen::Vector3d step(x[0], x[1], x[2]);
  const double unit = trust / (DIFFERENCE * scale_);
  bool added = false;
  for (std::size_t k = 0; k < places_.size(); ++k)
  {
    const Eigen::Vector3d moved = unit * (step + x[3] / reach_ * places_[k].per_size + x[5] / trust * sweepOf(k));
    for (std::size_t m = 0; m < necessary_[k].matrices; ++m)
    {
      const std::array<double, 3> delta = { moved[0], moved[1], moved[2] };
      const SymmetricForms<double>& matrix = necessary_[k].matrix[m];
      if (isAbove(matrix, delta, -1e-3 * trust / scale_))
        continue;
      addRow(quadraticForm(matrix, leastEigenvector(matrix, delta).vector), trust, k);
      added = true;
    }
  }
  return added;
}

/// As far as its ends move by the trust region.
double LocalSearch::largestTurn(double trust) const
{
  if (angles_ == Interval(0.0))
    return 0.0;
  double arm = 0.0;
  for (const GrowingVector& place : places_)
    arm = std::max(arm, place.at(from_.size).head<2>().norm());
  return std::min(MOST_TURN, trust / std::max(arm, trust));
}

Candidate LocalSearch::propose(const Step& step, double trust)
{
  from_ = step.candidate;
  places_ = from_.placesOf(witnesses_.ofShape());
  turn_ = largestTurn(trust);
  slack_ = 2.0 * step.violation + 4.0 * trust;
  programme_.reset({ 0.0, 0.0, 0.0, trust, -0.5 * PENALTY * slack_, 0.0 });
  linearize(trust);
  for (int round = 0; round < CUT_ROUNDS; ++round)
    if (!programme_.solve() || !addCuts(trust))
      break;
  const auto& x = programme_.point();
  const Eigen::Vector3d center = from_.center + trust * Eigen::Vector3d(x[0], x[1], x[2]);
  return { center.cwiseMax(centers_.lower).cwiseMin(centers_.upper), std::max(0.0, from_.size + trust * x[3] / reach_),
           std::clamp(from_.angle + turn_ * x[5], angles_.lower(), angles_.upper()) };
}

Candidate LocalSearch::climb(const Candidate& start, double precision)
{
  Step best = assess(start);
  double trust = 0.2 * scale_;
  const double smallest = std::max(precision * reach_, SMALLEST_TRUST * scale_);
  for (int step = 0; step < MAX_STEPS && trust > smallest; ++step)
  {
    const Step next = assess(propose(best, trust));
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
  double reduction = 1e-15 * scale_;
  while (best.violation > 0.0 && best.candidate.size > 0.0)
  {
    reduction = std::max(2.0 * best.violation / reach_, 2.0 * reduction);
    best = assess({ best.candidate.center, std::max(0.0, best.candidate.size - reduction), best.candidate.angle });
  }
  return best.violation > 0.0 ? Candidate{ best.candidate.center, 0.0, best.candidate.angle } : best.candidate;
}
}  // namespace pkm_workspace
