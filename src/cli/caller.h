// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <ostream>
#include <string>

#include "pkm_workspace/interval/decimal.h"
#include "progress.h"

namespace pkm_workspace
{
namespace cli
{
/// Who runs a command: a shell, or a program in Python.
class Caller
{
public:
  virtual ~Caller() = default;
  /// The flag that a request to stop sets.
  virtual const std::atomic<bool>* stop() = 0;
  /// The same for a computation that knows no limit of time but the flag. @param seconds after which the flag is set
  /// too; 0: never
  virtual const std::atomic<bool>* stopAfter(double seconds) = 0;
  /// Whether that time has set the flag.
  virtual bool timeIsOver() const = 0;
  /// What has set the flag.
  std::string stoppedBy(double time_limit) const
  {
    return timeIsOver() ? "the time limit of " + nearly(time_limit) + " s (--time-limit)" : "a request to stop";
  }
  /// @param often whether it is asked for
  virtual Progress progress(bool often) = 0;
  virtual void warn(const std::string& text) = 0;
  virtual void note(const std::string& text) = 0;
};

/// Who typed a command: signals stop it, the rest goes to standard error.
class Shell : public Caller
{
public:
  explicit Shell(std::ostream& err) : err_(err) {}
  const std::atomic<bool>* stop() override { return stopOnSignal(); }
  const std::atomic<bool>* stopAfter(double seconds) override { return stopOnSignalOrAfter(seconds); }
  bool timeIsOver() const override { return cli::timeIsOver(); }
  Progress progress(bool often) override { return Progress(often); }
  void warn(const std::string& text) override { err_ << "pkm: warning: " << text << std::endl; }
  void note(const std::string& text) override { err_ << "pkm: note: " << text << std::endl; }

private:
  std::ostream& err_;
};
}  // namespace cli
}  // namespace pkm_workspace
