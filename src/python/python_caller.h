// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

#include "caller.h"
#include "keywords.h"
#include "values.h"

namespace pkm_workspace
{
namespace python
{
/// A program that calls: what is said to it is kept, and each call has a flag of its own.
class PythonCaller : public cli::Caller
{
public:
  ~PythonCaller() override;
  const std::atomic<bool>* stop() override { return &stop_; }
  const std::atomic<bool>* stopAfter(double seconds) override;
  bool timeIsOver() const override { return time_is_over_; }
  cli::Progress progress(bool often) override;
  void warn(const std::string& text) override { warnings.push_back(withKeywords(text)); }
  void note(const std::string& text) override { notes.push_back(withKeywords(text)); }

  /// Sets the flag. @param by_time whether a limit of time is the reason. Thread-safe, and safe in a signal's handler.
  void askToStop(bool by_time);

  cli::Words warnings;
  cli::Words notes;

private:
  std::atomic<bool> stop_{ false };
  std::atomic<bool> time_is_over_{ false };
  bool has_alarm_ = false;
};

/// While it lives, Ctrl-C stops the call in place of raising KeyboardInterrupt; pressed again, it does both. A handler
/// that a program has set is called, too. Only for the main thread, and where Python handles the signal.
class StopsOnInterrupt
{
public:
  /// @pre the interpreter is locked
  explicit StopsOnInterrupt(PythonCaller& caller);
  ~StopsOnInterrupt();
  StopsOnInterrupt(const StopsOnInterrupt&) = delete;
  StopsOnInterrupt& operator=(const StopsOnInterrupt&) = delete;

private:
  bool is_set_ = false;
};
}  // namespace python
}  // namespace pkm_workspace
