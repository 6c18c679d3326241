// SPDX-License-Identifier: BSD-3-Clause
#include "rate_search.h"

#include <algorithm>

namespace pkm_workspace
{
namespace
{
/// How near the two ends of the largest feed come to each other, relative to it.
constexpr double FEED_ACCURACY = 1e-3;
/// Looks at a segment beside those at its first pieces: some levels of eight each are enough but next to a singularity.
constexpr std::int64_t MOST_MORE = 512;
/// Parts are divided into so many, down to this length, in t.
constexpr std::size_t PARTS = 8;
constexpr double SHORTEST_PART = 0x1p-40;

/// Encloses the tool speed at which a rate of that much for each m/s reaches its limit.
Span<double> feedAt(Limit::Kind kind, double limit, double rate)
{
  if (rate == 0.0 || rate == INF)
    return rate == 0.0 ? Span<double>{ INF, INF } : Span<double>{ 0.0, 0.0 };
  const Interval quotient = Interval(limit) / Interval(rate);
  const Interval feed = kind == Limit::Kind::JOINT_SPEED ? quotient : sqrt(quotient);
  return { feed.lower(), feed.upper() };
}
}  // namespace

PathRates noRates()
{
  return { { 0.0, 0.0, 0.0 }, {} };
}

void merge(const PathRates& part, PathRates& sum)
{
  for (std::size_t i = 0; i < 3; ++i)
    sum.joint_acceleration[i] = std::max(sum.joint_acceleration[i], part.joint_acceleration[i]);
  const double upper = std::min(sum.feed.upper, part.feed.upper);
  if (part.feed.lower < sum.feed.lower)
    sum.feed = part.feed;
  sum.feed.upper = upper;
}

RateSearch::RateSearch(const Way& way, std::size_t pieces, PathLooks& looks, const PathQuery& query)
  : way_(way), pieces_(pieces), looks_(looks), query_(query)
{}

PathRates RateSearch::run()
{
  add(0.0, 1.0, pieces_);
  const std::int64_t most = looks_.count() + MOST_MORE;
  while (!isDone() && looks_.count() < most && !looks_.isOverForRates())
  {
    std::pop_heap(parts_.begin(), parts_.end(), isFaster);
    const Part slowest = parts_.back();
    parts_.pop_back();
    add(slowest.first, slowest.last, PARTS);
  }
  return result();
}

bool RateSearch::isDone() const
{
  const Part& slowest = parts_.front();
  return slowest.last - slowest.first <= SHORTEST_PART || slowest.feed.lower * (1.0 + FEED_ACCURACY) >= upper_;
}

/// Looks at equal parts of [first, last]. Where no more looks are allowed, nothing is known of what is left.
void RateSearch::add(double first, double last, std::size_t parts)
{
  std::array<WaySpan, PathLooks::MOST> spans;
  std::array<PieceRates, PathLooks::MOST> rates;
  const auto at = [&](std::size_t k) {
    return k == parts ? last : first + static_cast<double>(k) / static_cast<double>(parts) * (last - first);
  };
  for (std::size_t begin = 0; begin < parts; begin += PathLooks::MOST)
  {
    const std::size_t count = std::min(PathLooks::MOST, parts - begin);
    for (std::size_t k = 0; k < count; ++k)
    {
      spans[k] = { &way_, at(begin + k), at(begin + k + 1) };
      rates[k].speed.fill({ 0.0, INF });
      rates[k].acceleration.fill({ 0.0, INF });
    }
    if (!looks_.isOverForRates())
      looks_.rates(spans.data(), count, rates.data());
    for (std::size_t k = 0; k < count; ++k)
    {
      const Part part = partOf(spans[k], rates[k]);
      upper_ = std::min(upper_, part.feed.upper);
      parts_.push_back(part);
      std::push_heap(parts_.begin(), parts_.end(), isFaster);
    }
  }
}

RateSearch::Part RateSearch::partOf(const WaySpan& span, const PieceRates& rates) const
{
  Part part{ span.first, span.last, {}, {} };
  for (std::size_t i = 0; i < 3; ++i)
    part.acceleration[i] = rates.acceleration[i].upper;
  forEachLimit(query_.limits, [&](Limit::Kind kind, std::size_t leg, double limit) {
    const Span<double>& rate = rateOf(rates, kind, leg);
    const double lower = feedAt(kind, limit, rate.upper).lower;
    part.feed.upper = std::min(part.feed.upper, feedAt(kind, limit, rate.lower).upper);
    if (lower < part.feed.lower)
    {
      part.feed.lower = lower;
      part.feed.kind = kind;
      part.feed.leg = static_cast<int>(leg);
    }
  });
  return part;
}

PathRates RateSearch::result() const
{
  PathRates rates = noRates();
  rates.feed = parts_.front().feed;
  rates.feed.upper = upper_;
  const Interval square = sqr(way_.tool_speed);
  for (std::size_t i = 0; i < 3; ++i)
  {
    double most = 0.0;
    for (const Part& part : parts_)
      most = std::max(most, part.acceleration[i]);
    rates.joint_acceleration[i] = (Interval(0.0, most) * square).upper();
  }
  return rates;
}
}  // namespace pkm_workspace
