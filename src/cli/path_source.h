// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "job.h"
#include "options.h"
#include "path_text.h"

namespace pkm_workspace
{
namespace cli
{
/// The path that a question is about: --file, --segment or --gcode.
class PathSource
{
public:
  /// @param others more options that may take its place
  void declare(Options& options, const Words& others = {});
  /// The constant speed along it, and what joints are held against. @pre declare()
  /// @param may_ask_for_feed whether --largest-feed is one of the options
  void declareRates(Options& options, PathRatesTask& rates, bool may_ask_for_feed);

  bool isGiven() const { return job_.isGiven() || path_.size() > 0; }
  JobOption& job() { return job_; }
  const JobOption& job() const { return job_; }
  PathText& text() { return path_; }
  const PathText& text() const { return path_; }

private:
  void finish(const Options& options, const Words& others, Problems& problems);

  PathText path_;
  JobOption job_;
  std::string file_;
};
}  // namespace cli
}  // namespace pkm_workspace
