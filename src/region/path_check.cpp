// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/path_check.h"

#include <algorithm>
#include <cmath>

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

PathMotion asPathMotion(const PieceMotion& motion, double tool_speed)
{
  PathMotion result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    result.psi[i] = Interval(std::max(0.0, motion.psi[i].lower), motion.psi[i].upper);
    result.joint[i] = Interval(motion.joint[i].lower, motion.joint[i].upper);
    const Interval speed = Interval(0.0, motion.speed[i]) * Interval(tool_speed);
    result.joint_speed[i] = speed.upper();
  }
  return result;
}

/// One path: all segments are looked at piece by piece, and those that this does not prove INSIDE are followed one by
/// one.
class PathProof
{
public:
  PathProof(const PointEvaluator& evaluator, const std::vector<PathSegment>& segments, const PathQuery& query)
    : evaluator_(evaluator)
    , segments_(segments)
    , query_(query)
    , looks_(evaluator.test().kernel(), query)
    , motions_(segments.size(), noMotion())
    , is_open_(segments.size(), 0)
  {
    result_.segments.resize(segments.size());
  }

  PathResult run()
  {
    for (std::size_t i = 0; i < segments_.size() && !looks_.isOver(); ++i)
      addPieces(i);
    flush();
    for (std::size_t i = 0; i < segments_.size(); ++i)
      settle(i);
    PieceMotion sum = noMotion();
    for (const PieceMotion& motion : motions_)
      merge(motion, sum);
    if (result_.verdict == Containment::INSIDE && !segments_.empty())
      result_.motion = asPathMotion(sum, query_.tool_speed);
    result_.looks = looks_.count();
    result_.end = looks_.end();
    return std::move(result_);
  }

private:
  void addPieces(std::size_t segment)
  {
    const Curve& curve = segments_[segment].curve();
    const double longest = LONGEST_PIECE * evaluator_.machine().scale();
    const double wanted = std::max(curve.length().upper() / longest, curve.angle().magnitude() / LARGEST_ANGLE);
    const double parts = std::max(1.0, std::min(MOST_PIECES, std::ceil(wanted)));
    for (double k = 0.0; k < parts; k += 1.0)
    {
      owner_[count_] = segment;
      pieces_[count_] = curve.piece(k / parts, (k + 1.0) / parts);
      if (++count_ == BATCH)
        flush();
    }
    looked_at_ = segment + 1;
  }

  void flush()
  {
    looks_.look(pieces_.data(), count_, verdicts_.data(), found_.data());
    for (std::size_t k = 0; k < count_; ++k)
      if (verdicts_[k] == BoxVerdict::INSIDE)
        merge(found_[k], motions_[owner_[k]]);
      else
        is_open_[owner_[k]] = 1;
    count_ = 0;
  }

  void settle(std::size_t segment)
  {
    SegmentCheck& check = result_.segments[segment];
    std::vector<PathPart> open = { { 0.0, 1.0 } };
    if (segment < looked_at_ && !is_open_[segment])
    {
      check.verdict = Containment::INSIDE;
      check.good_until = 1.0;
    }
    else if (!looks_.isOver())
    {
      SegmentProof proof(segments_[segment].curve(), looks_, !result_.first);
      check = proof.run();
      open = proof.open();
      motions_[segment] = proof.motion();
    }
    if (check.verdict == Containment::INSIDE)
      check.motion = asPathMotion(motions_[segment], query_.tool_speed);
    else
      offend(segment, open);
  }

  void offend(std::size_t segment, const std::vector<PathPart>& open)
  {
    const SegmentCheck& check = result_.segments[segment];
    if (result_.verdict != Containment::OUTSIDE)
      result_.verdict = check.verdict;
    if (!result_.first)
      result_.first = offenceOf(segment, open);
    if (!result_.proved && check.verdict == Containment::OUTSIDE)
      result_.proved = result_.first->segment == segment ? *result_.first
                                                         : offenceOf(segment, { { check.good_until, *check.bad_at } });
  }

  PathOffence offenceOf(std::size_t segment, const std::vector<PathPart>& open) const
  {
    const SegmentCheck& check = result_.segments[segment];
    PathOffence offence;
    offence.segment = segment;
    offence.good_until = check.good_until;
    offence.bad_at = check.bad_at;
    offence.open = open;
    offence.point = segments_[segment].point(check.bad_at.value_or(check.good_until));
    offence.limit = evaluator_(offence.point).binding();
    return offence;
  }

  static constexpr std::size_t BATCH = 32;

  const PointEvaluator& evaluator_;
  const std::vector<PathSegment>& segments_;
  const PathQuery& query_;
  PathLooks looks_;
  PathResult result_;
  std::vector<PieceMotion> motions_;  ///< of each segment
  std::vector<char> is_open_;         ///< segments of which a piece is not INSIDE
  std::size_t looked_at_ = 0;         ///< segments of which all pieces are

  std::array<std::size_t, BATCH> owner_;
  std::array<CurvePiece, BATCH> pieces_;
  std::array<BoxVerdict, BATCH> verdicts_;
  std::array<PieceMotion, BATCH> found_;
  std::size_t count_ = 0;
};
}  // namespace

void PathQuery::validate(Problems& problems) const
{
  validatePositive("tool_speed", tool_speed, "m/s", problems);
  if (max_looks <= 0)
    problems.push_back("max_looks = " + std::to_string(max_looks) + " must be positive");
}

PathResult checkPath(const PointEvaluator& evaluator, const std::vector<PathSegment>& segments, const PathQuery& query)
{
  return PathProof(evaluator, segments, validated(query)).run();
}

PathResult checkPath(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& segments,
                     const PathQuery& query)
{
  return checkPath(PointEvaluator(machine, criterion), segments, query);
}
}  // namespace pkm_workspace
