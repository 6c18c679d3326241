// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <string>

namespace pkm_workspace
{
namespace cli
{
/// Makes the first SIGINT or SIGTERM set a flag, and the second one end the program. @return the flag
const std::atomic<bool>* stopOnSignal();

constexpr const char* PROGRESS_HELP = "tells the progress also where standard error is not a terminal";

/// Tells on standard error how far a computation of more than a second has come, once a second: on a terminal in one
/// line that it removes at the end, elsewhere only when asked to, in a line each. Thread-safe.
class Progress
{
public:
  explicit Progress(bool always);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void tell(double seconds, const std::string& text);

private:
  const bool terminal_;
  const bool enabled_;
  std::mutex mutex_;
  double next_ = 1.0;  ///< [s]
};
}  // namespace cli
}  // namespace pkm_workspace
