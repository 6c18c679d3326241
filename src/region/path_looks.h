// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// A curve, and the speed of the tool along it [m/s]; 0 where no limit on rates is held.
struct Way
{
  Curve curve;
  Interval tool_speed;
};

/// A piece of it: first <= t <= last.
struct WaySpan
{
  const Way* way;
  double first;
  double last;
};

/// Calls use(kind, leg, limit) for each limit that there is.
template <class Use>
void forEachLimit(const JointRateLimits& limits, const Use& use)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (limits.speed[i] < INF)
      use(Limit::Kind::JOINT_SPEED, i, limits.speed[i]);
    if (limits.acceleration[i] < INF)
      use(Limit::Kind::JOINT_ACCELERATION, i, limits.acceleration[i]);
  }
}

/// What such a limit is about, for a tool speed of 1 m/s.
inline const Span<double>& rateOf(const PieceRates& rates, Limit::Kind kind, std::size_t leg)
{
  return kind == Limit::Kind::JOINT_SPEED ? rates.speed[leg] : rates.acceleration[leg];
}

/// What rates for a tool speed of 1 m/s mean at another one: INSIDE where each point of a piece keeps all limits,
/// OUTSIDE where one limit is broken at all of them.
BoxVerdict verdictOn(const PieceRates& rates, const JointRateLimits& limits, const Interval& tool_speed);

/// What many looks have in common.
class PathLooks
{
public:
  /// The most pieces that are looked at side by side.
  static constexpr std::size_t MOST = 64;

  PathLooks(const BoxKernel& kernel, const PathQuery& query);

  /// Pieces looked at.
  std::int64_t count() const { return count_ + rates_count_; }
  /// What has ended the looks, once isOver() has said so.
  PathResult::End end() const { return end_; }

  /// Adds the share of so many pieces that a path has at first.
  void allowFor(std::int64_t pieces) { pieces_ += pieces; }
  /// Whether no more verdicts may be asked for.
  bool isOver();
  /// Whether no more rates may be asked for: they have a share of the same size for themselves.
  bool isOverForRates() const { return isStopped() || isSpent(rates_count_); }

  /// At most MOST pieces: whether they keep criterion and limits. @param motions may be nullptr
  void look(const WaySpan* spans, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions);
  /// At most MOST pieces.
  void rates(const WaySpan* spans, std::size_t count, PieceRates* rates);
  /// The limits on the rates that are held, at one point.
  std::vector<Limit> limitsAt(const Way& way, double t) const;

private:
  using Pieces = std::array<CurvePiece, MOST>;

  bool isStopped() const { return query_.stop != nullptr && *query_.stop; }
  bool isSpent(std::int64_t looks) const { return looks >= query_.max_looks + pieces_ * query_.looks_per_piece; }
  void ratesOf(const Pieces& pieces, const WaySpan* spans, std::size_t count, PieceRates* rates) const;
  void hold(const PieceRates& rates, const Interval& tool_speed, BoxVerdict& verdict) const;

  const BoxKernel& kernel_;
  const PathQuery& query_;
  const bool holds_;  ///< whether there is a limit to be held
  std::int64_t count_ = 0;
  std::int64_t rates_count_ = 0;
  std::int64_t pieces_ = 0;
  PathResult::End end_ = PathResult::End::COMPLETE;
};
}  // namespace pkm_workspace
