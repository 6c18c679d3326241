// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_search.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
/// Boxes that are looked at side by side.
constexpr std::size_t WAVE = 16;
/// Starts of the local search besides the zero configuration: the best of a grid of this many centers along each axis.
constexpr int GRID = 4;
constexpr std::size_t STARTS = 2;
/// How far below the local optimum a region is certified, as shares of the accuracy; the first that is proved counts.
constexpr double BACK_OFFS[] = { 1e-4, 1e-3, 1e-2, 0.1, 0.4 };
/// Where regions may be turned, the search begins with parts of the angles that are no wider [rad].
constexpr double WIDEST_SECTOR = 0.3;
/// If none of these is, a region is certified that is this much smaller.
constexpr double SHRINKAGES[] = { 0.999, 0.99, 0.9, 0.7, 0.4, 0.1 };
/// New witness points that one climb may learn from failed certificates.
constexpr int LESSONS = 24;
/// The bounds of open boxes are lowered after so many boxes, and whenever they have doubled: in searches that turn out
/// long; where a box budget will end them, from early on. It holds to the end: larger budgets never give wider
/// brackets.
constexpr std::int64_t CHECKPOINT = 2048;
constexpr std::int64_t FIRST_CHECKPOINT = 64;
/// The finest accuracies that are tried in doubles and with multi-precision, as lengths relative to the longest strut.
/// Sizes are doubles.
constexpr double LEAST_ACCURACY = 1e-12;
constexpr double LEAST_PRECISE_ACCURACY = 5e-14;

double leastAccuracy(const RegionQuery& query)
{
  return query.precision == Precision::DOUBLE ? LEAST_ACCURACY : LEAST_PRECISE_ACCURACY;
}

/// Angles that a box is narrow over: a single 0, or parts of those by which regions may be turned.
std::vector<Interval> sectorsOf(const Interval& angles)
{
  if (angles.isSingle())
    return { angles };
  const int count = static_cast<int>(std::ceil(angles.width() / WIDEST_SECTOR));
  std::vector<Interval> sectors;
  double lower = angles.lower();
  for (int k = 1; k <= count; ++k)
  {
    const double upper = k == count ? angles.upper() : angles.lower() + k * (angles.width() / count);
    sectors.emplace_back(lower, upper);
    lower = upper;
  }
  return sectors;
}

/// Decides what is bad wherever a point stands along parallel rails.
std::optional<BoxTest> withoutLimits(const Machine& machine, const RegionQuery& query, const CenterSpace& space)
{
  if (!space.travel)
    return std::nullopt;
  Criterion criterion = query.criterion;
  criterion.joint_limits = false;
  return BoxTest(machine, criterion, query.precision);
}
}  // namespace

CenterSearch::CenterSearch(const Machine& machine, const RegionQuery& query, double known,
                           std::int64_t verification_boxes)
  : query_(query)
  , budget_(query.budget)
  , test_(machine, query.criterion, query.precision)
  , space_(centerSpace(machine, query))
  , test_across_rails_(withoutLimits(machine, query, space_))
  , travel_(space_.travel && space_.travel->binds() ? &*space_.travel : nullptr)
  , witnesses_(*query.shape, test_.zonesToKeepOut())
  , center_tests_(WAVE, CenterTest(testOfCenters(), *query.shape, witnesses_, travel_, tellsReasons()))
  , local_search_(testOfClimbs(), *query.shape, witnesses_, travel_ ? travel_->centers() : space_.centers, query.angles,
                  travel_)
  , pool_(query.budget.threads)
  , scale_(machine.scale())
  , accuracy_(std::max(query.accuracy, leastAccuracy(query) * scale_ / query.shape->halfExtents().per_size.maxCoeff()))
  , incumbent_(machine, test_, query_, budget_, known, verification_boxes)
  , is_part_(verification_boxes > 0)
  , checkpoint_(query.budget.max_boxes > 0 && !is_part_ ? FIRST_CHECKPOINT : CHECKPOINT)
  , bracket_(0.0, space_.size_bound)
  , pace_(query.progress_period)
  , zero_(machine.zero())
{}

/// The least size whose absence proves the answer to the accuracy, rounded so that the bracket is never wider.
double CenterSearch::target() const
{
  return rounding::add(incumbent_.size(), accuracy_).lower;
}

double CenterSearch::upperBound() const
{
  const double open = open_.isEmpty() ? 0.0 : open_.first().bound;
  return std::min(bracket_.upper(), std::max({ incumbent_.size(), excluded_bound_, unsettled_bound_, open }));
}

/// Certifies a region a little smaller than the candidate. @return whether one was found
bool CenterSearch::certifyBelow(const Candidate& candidate)
{
  const double before = incumbent_.size();
  for (const double share : BACK_OFFS)
    if (incumbent_.size() == before)
      certify(candidate.ofSize(candidate.size - share * accuracy_));
  for (const double share : SHRINKAGES)
    if (incumbent_.size() == before)
      certify(candidate.ofSize(share * candidate.size));
  return incumbent_.size() > before;
}

/// Climbs and certifies; a bad point that the witness points missed becomes one of them, and the climb starts anew.
void CenterSearch::climbFrom(const Candidate& start)
{
  Candidate found = searched(start);
  for (int lesson = 0; lesson < LESSONS && !budget_.isOver(); ++lesson)
  {
    found = local_search_.climb(found, BACK_OFFS[0] * accuracy_);
    const ContainmentResult proof = certify(found.ofSize(found.size - BACK_OFFS[0] * accuracy_));
    if (!proof.bad_point)
      break;
    learn(found, proof);
  }
  if (found.size > incumbent_.size() + 0.5 * accuracy_)
    certifyBelow(found);
}

void CenterSearch::start()
{
  const Box& centers = space_.centers;
  std::vector<std::pair<double, Eigen::Vector3d>> starts;
  for (int index = 0; index < GRID * GRID * GRID; ++index)
  {
    Eigen::Vector3d share((index % GRID + 0.5) / GRID, (index / GRID % GRID + 0.5) / GRID,
                          (index / (GRID * GRID) + 0.5) / GRID);
    const Eigen::Vector3d center = centers.lower + share.cwiseProduct(centers.upper - centers.lower);
    starts.emplace_back(-testOfClimbs().margin(searched({ center, 0.0 }).center), center);
  }
  const Eigen::Vector3d zero = zero_.cwiseMax(centers.lower).cwiseMin(centers.upper);
  std::partial_sort(starts.begin(), starts.begin() + STARTS, starts.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  const std::vector<Interval> sectors = sectorsOf(query_.angles);
  for (const Interval& sector : sectors)
    climbFrom({ zero, 0.0, sector.mid() });
  for (std::size_t k = 0; k < STARTS; ++k)
    climbFrom({ starts[k].second, 0.0, sectors[k % sectors.size()].mid() });
  for (const Interval& sector : sectors)
    open_.put({ centers, space_.size_bound, 0.0, sector });
}

/// Asks whether the middle of a box that could not be excluded carries a region of that size: if so, climbs from there;
/// if not, the bad point serves the boxes to come.
void CenterSearch::tryCenter(const Node& node, double size)
{
  const Candidate candidate = searched({ node.centers.center(), size, node.angles.mid() });
  if (!center_tests_.front().isPromising(candidate))
    return;
  const ContainmentResult proof = certify(candidate);
  if (proof.bad_point)
    learn(candidate, proof);
  else if (incumbent_.size() == size)
  {
    grow();
    climbFrom(incumbent_.candidate());
  }
}

/// Enlarges the incumbent about its center by steps that double, as C of the paper's section 2.4 does.
void CenterSearch::grow()
{
  for (double step = accuracy_;; step *= 2.0)
  {
    const Candidate larger = incumbent_.candidate().ofSize(incumbent_.size() + step);
    const ContainmentResult proof = certify(larger);
    if (proof.bad_point)
      learn(larger, proof);
    if (incumbent_.size() != larger.size)
      return;
  }
}

/// A wave ends at a budget and at a checkpoint: what a larger budget does begins with what a smaller one does.
std::size_t CenterSearch::waveSize() const
{
  std::int64_t allowed = std::min(static_cast<std::int64_t>(WAVE), checkpoint_ - boxes_);
  if (query_.budget.max_boxes > 0)
    allowed = std::min(allowed, query_.budget.max_boxes - boxes_);
  return static_cast<std::size_t>(allowed);
}

/// The open nodes copy themselves into twice the room where they grow.
std::size_t CenterSearch::bytes(std::size_t open)
{
  return 3 * sizeof(Node) * (open + std::min(WAVE, open));
}

bool CenterSearch::expand(const std::vector<Node>& wave)
{
  const double size = target();
  std::vector<Look> looks(wave.size());
  pool_.forEach(wave.size(), [&](std::size_t k) { looks[k] = lookAt(wave[k], size, center_tests_[k]); });
  for (std::size_t k = 0; k < wave.size(); ++k)
    settle(wave[k], looks[k]);
  if (boxes_ == checkpoint_)
  {
    lowerBounds();
    checkpoint_ *= 2;
  }
  return true;
}

void CenterSearch::tellProgress()
{
  const double now = query_.progress ? budget_.seconds() : 0.0;
  if (!query_.progress || !pace_.isDue(now))
    return;
  bracket_.narrow(incumbent_.size(), upperBound());
  const Shape& shape = *query_.shape;
  query_.progress({ bracket_.lower(), bracket_.upper(), shape.volume(bracket_.lower()).lower(),
                    shape.volume(bracket_.upper()).upper(), boxes_, static_cast<std::int64_t>(open_.size()), now });
}

LargestRegion CenterSearch::run()
{
  if (!space_.centers.isValid())
    return result(Ending::EXHAUSTED);
  start();
  const Ending ending = branchAndBound(open_, *this, budget_);
  if (ending != Ending::EXHAUSTED && (query_.budget.max_boxes == 0 || is_part_) && boxes_ < CHECKPOINT)
    lowerBounds();  // a moment's work where next to nothing is known
  return result(ending);
}

LargestRegion CenterSearch::result(Ending ending)
{
  bracket_.narrow(0.0, upperBound());
  LargestRegion region;
  region.shape = query_.shape;
  region.center = incumbent_.candidate().center;
  region.size = incumbent_.isFound() ? incumbent_.size() : 0.0;
  if (query_.turns())
    region.angle = incumbent_.candidate().angle;
  region.size_upper_bound = bracket_.upper();
  region.boxes = boxes_;
  region.verification_boxes = incumbent_.boxes();
  region.seconds = budget_.seconds();
  region.out_of_memory = ending == Ending::MEMORY;
  conclude(region, query_.accuracy, ending == Ending::EXHAUSTED ? "" : budget_.endedBy(boxes_, region.out_of_memory),
           query_.precision == Precision::DOUBLE);
  return region;
}
}  // namespace pkm_workspace
