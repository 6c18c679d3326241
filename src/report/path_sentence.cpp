// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/path_sentence.h"

#include <cmath>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/report/binding_limit.h"

namespace pkm_workspace
{
namespace
{
using End = PathResult::End;

/// Parts that are shorter than this are told by one number; those that are shorter than the other by more digits.
constexpr double SHORT = 2e-6;
constexpr double VERY_SHORT = 1e-9;

std::string text(const PathPart& part)
{
  const double length = part.last - part.first;
  if (length <= SHORT)
    return "near t = " + nearly(part.last, length <= VERY_SHORT ? 9 : 6);
  const int decimals = decimalsFor(part.first, part.last);
  return "between t = " + roundedDown(part.first, decimals) + " and t = " + roundedUp(part.last, decimals);
}

/// What is open before the path is outside for certain, or all that is open.
std::string openParts(const PathOffence& offence)
{
  const std::size_t count = offence.open.size() - (offence.bad_at ? 1 : 0);
  std::string parts;
  for (std::size_t k = 0; k < count; ++k)
    parts += (k == 0 ? "" : k + 1 == count ? " and " : ", ") + text(offence.open[k]);
  return parts;
}

std::string speedOf(const PathOffence& offence)
{
  const Interval& speed = offence.tool_speed;
  return speed.lower() == speed.upper() ? exact(speed.lower()) : nearly(speed.mid());
}

class Sentence
{
public:
  Sentence(const PathResult& result, const Machine& machine, const std::function<std::string(std::size_t)>& place,
           const std::string& stopped_by)
    : result_(result), machine_(machine), place_(place), stopped_by_(stopped_by)
  {}

  std::string operator()() const
  {
    if (result_.verdict == Containment::INSIDE)
      return "Proved: every point of the path is in the set.";
    const PathOffence& first = *result_.first;
    if (first.bad_at)
      return proved(first) + (first.open.size() > 1 ? " Before that it comes within rounding of the border " +
                                                          openParts(first) + ", where nothing is decided."
                                                    : "");
    if (result_.proved)
      return proved(*result_.proved) + " Before that it is not decided " + undecided(first) + ".";
    return "Not decided " + undecided(first) +
           (result_.end == End::COMPLETE ? ": " + describe(first.limit, machine_) + "."
                                         : ". Nothing that was looked at is proved to be outside.");
  }

private:
  std::string where(const PathOffence& offence, const std::string& parts) const
  {
    return "on " + place_(offence.segment) + ", " + parts + " of its way";
  }

  std::string proved(const PathOffence& offence) const
  {
    const PathPart& last = offence.open.back();
    const bool leaves = last.first > 0.0;
    const bool is_long = leaves && last.last - last.first > SHORT;
    const bool is_fast = isRate(offence.limit.kind);
    const std::string what =
        is_fast ? "Proved: at " + speedOf(offence) + " m/s the path " + (leaves ? "becomes" : "is") +
                      " too fast for the joints "
                : std::string("Proved: the path ") + (leaves ? "leaves the set " : "is outside the set ");
    return what + where(offence, text(leaves ? last : PathPart{ last.last, last.last })) +
           (is_long ? std::string(", and is ") + (is_fast ? "so" : "outside") + " somewhere between these" : "") +
           ": " + describe(offence.limit, machine_) + ".";
  }

  std::string undecided(const PathOffence& offence) const
  {
    const std::string place = where(offence, openParts(offence));
    if (result_.end == End::LOOKS)
      return place + ", because " + std::to_string(result_.looks) + " looks were not enough";
    return place + (result_.end == End::STOPPED ? ", because " + stopped_by_ + " ended the proof"
                                                : ", where the path comes within rounding of the border");
  }

  const PathResult& result_;
  const Machine& machine_;
  const std::function<std::string(std::size_t)>& place_;
  const std::string& stopped_by_;
};
}  // namespace

std::string describe(const PathResult& result, const Machine& machine,
                     const std::function<std::string(std::size_t)>& place, const std::string& stopped_by)
{
  return Sentence(result, machine, place, stopped_by)();
}
}  // namespace pkm_workspace
