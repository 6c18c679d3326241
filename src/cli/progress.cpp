// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <signal.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr const char* CLEAR_LINE = "\r\033[K";

std::atomic<bool> stop_flag{ false };
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free flags");

void setStopFlag(int)
{
  stop_flag = true;
}
}  // namespace

const std::atomic<bool>* stopOnSignal()
{
  struct sigaction action = {};
  action.sa_handler = setStopFlag;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return &stop_flag;
}

Progress::Progress(bool always) : terminal_(isatty(STDERR_FILENO) == 1), enabled_(terminal_ || always) {}

Progress::~Progress()
{
  if (terminal_ && next_ > 1.0)
    std::cerr << CLEAR_LINE << std::flush;
}

void Progress::tell(double seconds, const std::string& text)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!enabled_ || seconds < next_)
    return;
  next_ = std::floor(seconds) + 1.0;
  std::cerr << (terminal_ ? CLEAR_LINE : "") << std::floor(seconds) << " s: " << text << (terminal_ ? "" : "\n")
            << std::flush;
}
}  // namespace cli
}  // namespace pkm_workspace
