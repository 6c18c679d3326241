// SPDX-License-Identifier: BSD-3-Clause
#include "path_looks.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
void complainOfLimits(const char* name, const std::array<double, 3>& limits, const char* unit, Problems& problems)
{
  for (const double limit : limits)
    if (!(limit > 0.0))
      complain(problems, name, limit, unit);
}

/// The rate at a speed of the tool.
Interval atSpeed(const Span<double>& rate, Limit::Kind kind, const Interval& tool_speed)
{
  return Interval(rate.lower, rate.upper) * (kind == Limit::Kind::JOINT_SPEED ? tool_speed : sqr(tool_speed));
}
}  // namespace

void JointRateLimits::validate(Problems& problems) const
{
  complainOfLimits("joint_speed_max = ", speed, " m/s must be > 0, or infinite for none", problems);
  complainOfLimits("joint_acceleration_max = ", acceleration, " m/s^2 must be > 0, or infinite for none", problems);
}

BoxVerdict verdictOn(const PieceRates& rates, const JointRateLimits& limits, const Interval& tool_speed)
{
  bool keeps = true;
  bool breaks = false;
  forEachLimit(limits, [&](Limit::Kind kind, std::size_t leg, double limit) {
    const Interval rate = atSpeed(rateOf(rates, kind, leg), kind, tool_speed);
    keeps = keeps && rate.upper() <= limit;
    breaks = breaks || rate.lower() > limit;
  });
  return breaks ? BoxVerdict::OUTSIDE : keeps ? BoxVerdict::INSIDE : BoxVerdict::UNDECIDED;
}

PathLooks::PathLooks(const BoxKernel& kernel, const PathQuery& query)
  : kernel_(kernel), query_(query), holds_(query.holds_limits && query.limits.any())
{}

bool PathLooks::isOver()
{
  const bool is_over = isStopped() || isSpent(count_);
  if (is_over)
    end_ = isStopped() ? PathResult::End::STOPPED : PathResult::End::LOOKS;
  return is_over;
}

void PathLooks::look(const WaySpan* spans, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions)
{
  Pieces pieces;
  for (std::size_t k = 0; k < count; ++k)
    pieces[k] = spans[k].way->curve.piece(spans[k].first, spans[k].last);
  kernel_.look(pieces.data(), count, verdicts, motions);
  count_ += static_cast<std::int64_t>(count);
  const auto counts = [](const WaySpan& span) { return span.way->tool_speed.upper() > 0.0; };
  if (!holds_ || std::none_of(spans, spans + count, counts))
    return;
  std::array<PieceRates, MOST> rates;
  ratesOf(pieces, spans, count, rates.data());
  for (std::size_t k = 0; k < count; ++k)
    if (counts(spans[k]))
      hold(rates[k], spans[k].way->tool_speed, verdicts[k]);
}

void PathLooks::rates(const WaySpan* spans, std::size_t count, PieceRates* rates)
{
  Pieces pieces;
  for (std::size_t k = 0; k < count; ++k)
    pieces[k] = spans[k].way->curve.piece(spans[k].first, spans[k].last);
  ratesOf(pieces, spans, count, rates);
  rates_count_ += static_cast<std::int64_t>(count);
}

void PathLooks::ratesOf(const Pieces& pieces, const WaySpan* spans, std::size_t count, PieceRates* rates) const
{
  std::array<SkewBox<double>, MOST> curvatures;
  for (std::size_t k = 0; k < count; ++k)
    curvatures[k] = spans[k].way->curve.curvatures(spans[k].first, spans[k].last);
  kernel_.rates(pieces.data(), curvatures.data(), count, rates);
}

void PathLooks::hold(const PieceRates& rates, const Interval& tool_speed, BoxVerdict& verdict) const
{
  const BoxVerdict held = verdictOn(rates, query_.limits, tool_speed);
  if (held == BoxVerdict::OUTSIDE || verdict == BoxVerdict::INSIDE)
    verdict = held;
}

std::vector<Limit> PathLooks::limitsAt(const Way& way, double t) const
{
  std::vector<Limit> limits;
  if (!holds_ || way.tool_speed.upper() == 0.0)
    return limits;
  const CurvePiece piece = way.curve.piece(t, t);
  const SkewBox<double> curvature = way.curve.curvatures(t, t);
  PieceRates rates;
  kernel_.rates(&piece, &curvature, 1, &rates);
  forEachLimit(query_.limits, [&](Limit::Kind kind, std::size_t leg, double limit) {
    const Interval rate = atSpeed(rateOf(rates, kind, leg), kind, way.tool_speed);
    if (rate.isBounded())
      limits.push_back({ kind, static_cast<int>(leg), rate, limit, Interval(limit) - rate });
  });
  return limits;
}
}  // namespace pkm_workspace
