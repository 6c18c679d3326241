// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

namespace pkm_workspace
{
/// What is proved about a number while a search goes on: it may be bracketed anew as often as one likes, and what is
/// known only gets narrower. Searches tell this bracket and answer with it, so that nobody is told a wider one later.
class RunningBracket
{
public:
  explicit RunningBracket(double lower = 0.0, double upper = std::numeric_limits<double>::infinity())
    : lower_(lower), upper_(upper)
  {}

  /// The number is proved to lie between these, too.
  void narrow(double lower, double upper)
  {
    lower_ = std::max(lower_, lower);
    upper_ = std::min(upper_, upper);
  }

  double lower() const { return lower_; }
  double upper() const { return upper_; }

private:
  double lower_;
  double upper_;
};
}  // namespace pkm_workspace
