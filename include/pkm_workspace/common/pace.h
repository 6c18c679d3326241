// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pkm_workspace
{
/// Between two reports of a search [s], where nothing else is asked for.
constexpr double PROGRESS_PERIOD = 0.1;

/// Tells when it is time for the next report.
class Pace
{
public:
  /// @param period [s]; 0: always
  explicit Pace(double period) : period_(period), next_(period) {}

  /// @param now since the beginning [s] @return whether a report is due; it counts as given then
  bool isDue(double now)
  {
    if (now < next_)
      return false;
    next_ = now + period_;
    return true;
  }

private:
  double period_;
  double next_;
};
}  // namespace pkm_workspace
