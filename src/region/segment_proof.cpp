// SPDX-License-Identifier: BSD-3-Clause
#include "segment_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pkm_workspace
{
namespace
{
/// Pieces are divided down to this, in t: eight times the distance of doubles below 1.
constexpr double LEAST_PIECE = 0x1p-50;
/// The same behind a piece that stays undecided: there only bad points are of interest, and along the border nothing
/// would be decided at any width.
constexpr double LEAST_PIECE_BEHIND = 0x1p-12;

constexpr double INF = std::numeric_limits<double>::infinity();

/// What is no number bounds nothing.
void widen(const Span<double>& span, Span<double>& sum)
{
  const bool is_bound = span.lower <= span.upper;
  sum.lower = is_bound ? std::min(sum.lower, span.lower) : -INF;
  sum.upper = is_bound ? std::max(sum.upper, span.upper) : INF;
}
}  // namespace

PieceMotion noMotion()
{
  PieceMotion motion;
  motion.psi.fill({ INF, -INF });
  motion.joint.fill({ INF, -INF });
  motion.speed.fill(0.0);
  return motion;
}

void merge(const PieceMotion& motion, PieceMotion& sum)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    widen(motion.psi[i], sum.psi[i]);
    widen(motion.joint[i], sum.joint[i]);
    sum.speed[i] = motion.speed[i] >= 0.0 ? std::max(sum.speed[i], motion.speed[i]) : INF;
  }
}

SegmentCheck SegmentProof::run(bool to_the_end)
{
  to_the_end_ = to_the_end;
  if (advance(0.0, 1.0) && !is_stuck_)
  {
    result_.verdict = Containment::INSIDE;
    result_.good_until = 1.0;
  }
  return result_;
}

bool SegmentProof::canDivide(double first, double last) const
{
  return last - first > (is_stuck_ ? LEAST_PIECE_BEHIND : LEAST_PIECE);
}

/// Looks at eight parts of [first, last], and at their parts, from the left. @return whether to go on to the right
bool SegmentProof::advance(double first, double last)
{
  if (looks_.isOver())
  {
    is_stuck_ = true;
    return false;
  }
  std::array<double, PIECES + 1> t;
  std::array<CurvePiece, PIECES> pieces;
  std::array<BoxVerdict, PIECES> verdicts;
  std::array<PieceMotion, PIECES> motions;
  for (std::size_t k = 0; k <= PIECES; ++k)
    t[k] = k == PIECES ? last : first + static_cast<double>(k) / PIECES * (last - first);
  for (std::size_t k = 0; k < PIECES; ++k)
    pieces[k] = curve_.piece(t[k], t[k + 1]);
  looks_.look(pieces.data(), PIECES, verdicts.data(), motions.data());
  if (!to_the_end_)
    for (std::size_t k = 0; k < PIECES; ++k)
      if (verdicts[k] == BoxVerdict::OUTSIDE)
        return pass(t[k], t[k + 1], verdicts[k], motions[k]);
  for (std::size_t k = 0; k < PIECES; ++k)
    if (!pass(t[k], t[k + 1], verdicts[k], motions[k]))
      return false;
  return true;
}

bool SegmentProof::pass(double first, double last, BoxVerdict verdict, const PieceMotion& motion)
{
  if (verdict == BoxVerdict::OUTSIDE)
  {
    result_.verdict = Containment::OUTSIDE;
    result_.bad_at = first;
    return false;
  }
  if (verdict == BoxVerdict::INSIDE)
  {
    if (!is_stuck_)
      result_.good_until = last;
    merge(motion, motion_);
    return true;
  }
  if (canDivide(first, last))
    return advance(first, last);
  const bool was_stuck = is_stuck_;
  is_stuck_ = true;
  return was_stuck || !seekBad(first);
}

/// Looks at single points, at distances that double. @return whether one of them is proved bad
bool SegmentProof::seekBad(double from)
{
  constexpr std::size_t MOST = 64;
  std::array<double, MOST> t;
  std::array<CurvePiece, MOST> pieces;
  std::array<BoxVerdict, MOST> verdicts;
  std::size_t count = 0;
  for (double step = 0x1p-54; count < MOST && (count == 0 || t[count - 1] < 1.0); step *= 2.0)
  {
    t[count] = std::min(1.0, from + step);
    pieces[count] = curve_.piece(t[count], t[count]);
    ++count;
  }
  looks_.look(pieces.data(), count, verdicts.data(), nullptr);
  const auto found =
      std::find(verdicts.begin(), verdicts.begin() + static_cast<std::ptrdiff_t>(count), BoxVerdict::OUTSIDE);
  if (found == verdicts.begin() + static_cast<std::ptrdiff_t>(count))
    return false;
  result_.verdict = Containment::OUTSIDE;
  result_.bad_at = t[static_cast<std::size_t>(found - verdicts.begin())];
  return true;
}
}  // namespace pkm_workspace
