// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path_check.h"

#include <algorithm>
#include <cmath>

#include "rate_search.h"
#include "segment_proof.h"

namespace pkm_workspace
{
namespace
{
/// Pieces of the first looks are no longer than this, in struts and in radians: so that bounds of what the machine does
/// are good to about the square of it.
constexpr double LONGEST_PIECE = 1.0 / 64.0;
constexpr double LARGEST_ANGLE = 1.0 / 16.0;
constexpr double MOST_PIECES = 4096.0;

/// @param motion with speeds of joints at the speed of the tool
PathMotion asPathMotion(const PieceMotion& motion)
{
  PathMotion result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.psi[i] = Interval(std::max(0.0, motion.psi[i].lower), motion.psi[i].upper);
    result.joint[i] = Interval(motion.joint[i].lower, motion.joint[i].upper);
    result.joint_speed[i] = motion.speed[i];
  }
  return result;
}

/// From the speeds of joints at 1 m/s.
void setSpeeds(const Interval& tool_speed, PieceMotion& motion)
{
  for (double& speed : motion.speed)
    speed = tool_speed.upper() > 0.0 ? (Interval(0.0, speed) * tool_speed).upper() : 0.0;
}
}  // namespace

/// Some segments at a time: all are looked at piece by piece, and those that this does not prove INSIDE are followed
/// one by one.
class PathChecker::Proof
{
public:
  Proof(const PointEvaluator& evaluator, const PathQuery& query, const Tell& tell)
    : evaluator_(evaluator), query_(validated(query)), tell_(tell), looks_(evaluator.test().kernel(), query)
  {
    open_.reserve(AT_A_TIME);
  }

  void add(const PathStep& step)
  {
    const std::size_t index = done_ + open_.size();
    const Interval tool_speed = step.tool_speed.value_or(Interval(query_.tool_speed));
    open_.push_back({ { step.segment.curve(), tool_speed }, step.id.value_or(index) });
    if (open_.size() == AT_A_TIME)
      checkOpen();
  }

  PathResult finish()
  {
    checkOpen();
    if (result_.verdict == Containment::INSIDE && done_ > 0)
      result_.motion = asPathMotion(motion_);
    if (query_.wants_rates)
      result_.rates = rates_;
    result_.looks = looks_.count();
    result_.end = looks_.end();
    return std::move(result_);
  }

private:
  struct Open
  {
    Way way;
    std::size_t id;
    PieceMotion motion = noMotion();
    bool is_good = true;  ///< all its pieces are INSIDE
  };

  void checkOpen()
  {
    for (std::size_t i = 0; i < open_.size(); ++i)
      addPieces(i);
    flush();
    for (Open& open : open_)
    {
      settle(open);
      ++done_;
    }
    open_.clear();
  }

  /// How many pieces the curve has at first.
  double piecesOf(const Curve& curve) const
  {
    const double longest = LONGEST_PIECE * evaluator_.machine().scale();
    const double wanted = std::max(curve.length().upper() / longest, curve.angle().magnitude() / LARGEST_ANGLE);
    return std::max(1.0, std::min(MOST_PIECES, std::ceil(wanted)));
  }

  void addPieces(std::size_t index)
  {
    const Curve& curve = open_[index].way.curve;
    const double parts = piecesOf(curve);
    looks_.allowFor(static_cast<std::int64_t>(parts));
    if (looks_.isOver())
    {
      open_[index].is_good = false;
      return;
    }
    for (double k = 0.0; k < parts; k += 1.0)
    {
      owner_[count_] = index;
      pieces_[count_] = { &open_[index].way, k / parts, (k + 1.0) / parts };
      if (++count_ == BATCH)
        flush();
    }
  }

  void flush()
  {
    looks_.look(pieces_.data(), count_, verdicts_.data(), found_.data());
    for (std::size_t k = 0; k < count_; ++k)
      if (verdicts_[k] == BoxVerdict::INSIDE)
        merge(found_[k], open_[owner_[k]].motion);
      else
        open_[owner_[k]].is_good = false;
    count_ = 0;
  }

  void settle(Open& open)
  {
    SegmentCheck check;
    std::vector<PathPart> parts = { { 0.0, 1.0 } };
    if (open.is_good)
    {
      check.verdict = Containment::INSIDE;
      check.good_until = 1.0;
    }
    else if (!looks_.isOver())
    {
      SegmentProof proof(open.way, looks_, !result_.first);
      check = proof.run();
      parts = proof.open();
      open.motion = proof.motion();
    }
    if (check.verdict == Containment::INSIDE)
    {
      setSpeeds(open.way.tool_speed, open.motion);
      check.motion = asPathMotion(open.motion);
      merge(open.motion, motion_);
    }
    else
      offend(open, check, parts);
    if (query_.wants_rates)
      addRates(open, check);
    tell_(check);
  }

  void addRates(const Open& open, SegmentCheck& check)
  {
    const auto pieces = static_cast<std::size_t>(piecesOf(open.way.curve));
    check.rates = RateSearch(open.way, pieces, looks_, query_).run();
    if (check.rates->feed.lower < rates_.feed.lower)
      result_.slowest = open.id;
    merge(*check.rates, rates_);
  }

  void offend(const Open& open, SegmentCheck& check, const std::vector<PathPart>& parts)
  {
    const bool is_outside = check.verdict == Containment::OUTSIDE;
    if (result_.verdict != Containment::OUTSIDE)
      result_.verdict = check.verdict;
    const bool is_first = !result_.first;
    const bool is_proof = is_outside && !result_.proved;
    const bool is_told = offences_++ < query_.most_offences;
    if (!is_first && !is_proof && !is_told)
      return;
    const std::vector<PathPart> near_end = { { check.good_until, check.bad_at.value_or(1.0) } };
    const PathOffence offence = offenceOf(open, check, is_first ? parts : near_end);
    if (is_first)
      result_.first = offence;
    if (is_proof)
      result_.proved = offence;
    if (is_told)
      check.offence = offence;
  }

  PathOffence offenceOf(const Open& open, const SegmentCheck& check, const std::vector<PathPart>& parts) const
  {
    PathOffence offence;
    offence.segment = open.id;
    offence.good_until = check.good_until;
    offence.bad_at = check.bad_at;
    offence.open = parts;
    offence.point = mid(open.way.curve.point(check.bad_at.value_or(check.good_until)));
    offence.tool_speed = open.way.tool_speed;
    offence.limit = limitAt(open.way, offence);
    return offence;
  }

  /// What binds there, of the criterion and of the limits on the joints' rates.
  Limit limitAt(const Way& way, const PathOffence& offence) const
  {
    PointEvaluation there = evaluator_(offence.point);
    for (const Limit& limit : looks_.limitsAt(way, offence.bad_at.value_or(offence.good_until)))
      there.limits.push_back(limit);
    return there.binding();
  }

  static constexpr std::size_t AT_A_TIME = 256;  ///< segments
  static constexpr std::size_t BATCH = 32;       ///< pieces that are looked at side by side

  const PointEvaluator& evaluator_;
  const PathQuery& query_;
  const Tell tell_;
  PathLooks looks_;
  PathResult result_;
  PieceMotion motion_ = noMotion();  ///< over all segments that are INSIDE
  PathRates rates_ = noRates();      ///< over all segments
  std::size_t done_ = 0;             ///< segments
  std::size_t offences_ = 0;         ///< segments that are not INSIDE
  std::vector<Open> open_;

  std::array<std::size_t, BATCH> owner_;
  std::array<WaySpan, BATCH> pieces_;
  std::array<BoxVerdict, BATCH> verdicts_;
  std::array<PieceMotion, BATCH> found_;
  std::size_t count_ = 0;
};

PathChecker::PathChecker(const PointEvaluator& evaluator, const PathQuery& query, const Tell& tell)
  : proof_(std::make_unique<Proof>(evaluator, query, tell))
{}

PathChecker::~PathChecker() = default;

void PathChecker::add(const PathStep& step)
{
  proof_->add(step);
}

PathResult PathChecker::finish()
{
  return proof_->finish();
}

void PathQuery::validate(Problems& problems) const
{
  if (!(tool_speed >= SLOWEST_TOOL && tool_speed <= FASTEST_TOOL))
    complain(problems, "tool_speed = ", tool_speed, " m/s must be from 1e-9 to 1e9 m/s");
  limits.validate(problems);
  if (max_looks <= 0)
    problems.push_back("max_looks = " + std::to_string(max_looks) + " must be positive");
  if (looks_per_piece < 0)
    problems.push_back("looks_per_piece = " + std::to_string(looks_per_piece) + " must not be negative");
}

PathResult checkPath(const PointEvaluator& evaluator, const std::vector<PathSegment>& segments, const PathQuery& query)
{
  std::vector<SegmentCheck> checks;
  checks.reserve(segments.size());
  PathChecker checker(evaluator, query, [&checks](const SegmentCheck& check) { checks.push_back(check); });
  for (const PathSegment& segment : segments)
    checker.add(segment);
  PathResult result = checker.finish();
  result.segments = std::move(checks);
  return result;
}

PathResult checkPath(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& segments,
                     const PathQuery& query)
{
  return checkPath(PointEvaluator(machine, criterion), segments, query);
}
}  // namespace pkm_workspace
