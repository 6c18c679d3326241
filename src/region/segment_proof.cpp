// SPDX-License-Identifier: BSD-3-Clause
#include "segment_proof.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace
{
/// Pieces are divided down to this, in t: eight times the distance of doubles below 1.
constexpr double LEAST_PIECE = 0x1p-50;
/// The same where enough is open already: there only bad points are of interest, and along the border nothing would be
/// decided at any width.
constexpr double LEAST_PIECE_BEHIND = 0x1p-12;
/// From where a path touches the border it mostly goes away with the square of the distance: so do the widths of the
/// pieces that are good enough, relative to the distance.
constexpr double SHARE_BESIDE = 1.0 / 16.0;
/// Where a path touches the border, rounding decides now and then: places that are nearer to each other than this are
/// one.
constexpr double LEAST_GAP = 0x1p-20;
/// Places that are followed until doubles end.
constexpr std::size_t MOST_OPEN = 16;

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

SegmentProof::SegmentProof(const Way& way, PathLooks& looks, bool to_the_end)
  : way_(way), looks_(looks), to_the_end_(to_the_end), most_open_(to_the_end ? MOST_OPEN : 1)
{}

SegmentCheck SegmentProof::run()
{
  const bool at_end = advance(0.0, 1.0);
  if (at_end && open_.empty())
  {
    result_.verdict = Containment::INSIDE;
    result_.good_until = 1.0;
  }
  else if (seen_bad_ && result_.verdict == Containment::UNDECIDED)
  {
    while (open_.back().first > *seen_bad_)
      open_.pop_back();
    open_.back().last = *seen_bad_;
    refute(*seen_bad_);
  }
  return result_;
}

/// Whether what stays undecided from here on belongs to the last open part.
bool SegmentProof::isBesideOpen(double first) const
{
  return !open_.empty() && first - open_.back().last <= std::max(LEAST_GAP, open_.back().last - open_.back().first);
}

double SegmentProof::leastPiece(double first) const
{
  if (open_.size() == most_open_)
    return LEAST_PIECE_BEHIND;
  return isBesideOpen(first) ? std::max(LEAST_PIECE, SHARE_BESIDE * (first - open_.back().first)) : LEAST_PIECE;
}

/// Looks at eight parts of [first, last], and at their parts, from the left. @return whether to go on to the right
bool SegmentProof::advance(double first, double last)
{
  if (looks_.isOver())
  {
    leaveOpen(first, 1.0);
    return false;
  }
  std::array<double, PIECES + 1> t;
  std::array<WaySpan, PIECES> pieces;
  std::array<BoxVerdict, PIECES> verdicts;
  std::array<PieceMotion, PIECES> motions;
  for (std::size_t k = 0; k <= PIECES; ++k)
    t[k] = k == PIECES ? last : first + static_cast<double>(k) / PIECES * (last - first);
  for (std::size_t k = 0; k < PIECES; ++k)
    pieces[k] = { &way_, t[k], t[k + 1] };
  looks_.look(pieces.data(), PIECES, verdicts.data(), motions.data());
  if (!to_the_end_)
    for (std::size_t k = 0; k < PIECES; ++k)
      if (verdicts[k] == BoxVerdict::OUTSIDE)
        return refute(t[k]);
  for (std::size_t k = 0; k < PIECES; ++k)
    if (!pass(t[k], t[k + 1], verdicts[k], motions[k]))
      return false;
  return true;
}

bool SegmentProof::pass(double first, double last, BoxVerdict verdict, const PieceMotion& motion)
{
  if (verdict == BoxVerdict::OUTSIDE)
  {
    leaveOpen(first, first);
    return refute(first);
  }
  if (verdict == BoxVerdict::INSIDE)
  {
    if (open_.empty())
      result_.good_until = last;
    merge(motion, motion_);
    return true;
  }
  if (last - first > leastPiece(first))
    return advance(first, last);
  return !leaveOpen(first, last) || !seekBad(first);
}

/// @return false: nothing else is looked at
bool SegmentProof::refute(double bad_at)
{
  result_.verdict = Containment::OUTSIDE;
  result_.bad_at = bad_at;
  return false;
}

/// @return whether this is a place of its own
bool SegmentProof::leaveOpen(double first, double last)
{
  const bool is_apart = !isBesideOpen(first) && open_.size() < most_open_;
  if (is_apart)
    open_.push_back({ first, last });
  else
    open_.back().last = last;
  return is_apart;
}

/// Looks at single points, at distances that double: where the path crosses the border, the first one that can be
/// decided is bad. @return whether it is
bool SegmentProof::seekBad(double from)
{
  constexpr std::size_t MOST = PathLooks::MOST;
  std::array<double, MOST> t;
  std::array<WaySpan, MOST> pieces;
  std::array<BoxVerdict, MOST> verdicts;
  std::size_t count = 0;
  for (double step = 0x1p-54; count < MOST && (count == 0 || t[count - 1] < 1.0); step *= 2.0)
  {
    t[count] = std::min(1.0, from + step);
    pieces[count] = { &way_, t[count], t[count] };
    ++count;
  }
  looks_.look(pieces.data(), count, verdicts.data(), nullptr);
  const auto end = verdicts.begin() + static_cast<std::ptrdiff_t>(count);
  const auto bad = std::find(verdicts.begin(), end, BoxVerdict::OUTSIDE);
  if (bad == end)
    return false;
  const double bad_at = t[static_cast<std::size_t>(bad - verdicts.begin())];
  if (to_the_end_ && std::find(verdicts.begin(), bad, BoxVerdict::INSIDE) != bad)
  {
    seen_bad_ = std::min(bad_at, seen_bad_.value_or(bad_at));
    return false;
  }
  open_.back().last = bad_at;
  refute(bad_at);
  return true;
}
}  // namespace pkm_workspace
