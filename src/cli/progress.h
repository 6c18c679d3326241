// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

namespace pkm_workspace
{
namespace cli
{
/// Makes the first SIGINT or SIGTERM set a flag, and the second one end the program. @return the flag
const std::atomic<bool>* stopOnSignal();
/// The same for a computation that knows no limit of time but the flag. @param seconds after which the flag is set too;
/// 0: never
const std::atomic<bool>* stopOnSignalOrAfter(double seconds);
/// Whether that time has set the flag.
bool timeIsOver();

constexpr const char* PROGRESS_HELP = "tells the progress once a second where standard error is not a terminal, too";

/// Tells on standard error how far a long computation has come: on a terminal once a second, in one line that it
/// removes at the end; elsewhere in lines of their own, every five seconds, or once a second when asked to.
/// Thread-safe.
class Progress
{
public:
  explicit Progress(bool often);
  /// Tells nobody.
  Progress();
  /// @param period between two messages
  Progress(std::ostream& stream, bool is_terminal, std::chrono::nanoseconds period);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says what the next message is to be: until then it is that the computation goes on.
  void tell(const std::string& text);

private:
  void run();
  void print();

  std::ostream& stream_;
  const bool is_terminal_;
  const std::chrono::nanoseconds period_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable wake_;
  std::string text_ = "still computing";
  bool has_printed_ = false;
  bool ends_ = false;
  std::thread thread_;
};
}  // namespace cli
}  // namespace pkm_workspace
