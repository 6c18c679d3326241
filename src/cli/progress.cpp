// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace pkm_workspace
{
namespace cli
{
namespace
{
constexpr const char* CLEAR_LINE = "\r\033[K";
constexpr std::chrono::seconds OFTEN(1);
constexpr std::chrono::seconds SELDOM(5);
/// More than any computation takes, and within what a timer can hold [s].
constexpr double LONGEST = 1e9;

std::atomic<bool> stop_flag{ false };
std::atomic<bool> time_flag{ false };
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free flags");

void setStopFlag(int signal)
{
  if (signal == SIGALRM)
    time_flag = true;
  stop_flag = true;
}

bool isTerminal()
{
  return isatty(STDERR_FILENO) == 1;
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

const std::atomic<bool>* stopOnSignalOrAfter(double seconds)
{
  struct sigaction action = {};
  action.sa_handler = setStopFlag;
  action.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &action, nullptr);
  const double whole = std::floor(std::min(seconds, LONGEST));
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(std::min(1e6 * (seconds - whole), 999999.0));
  if (seconds > 0.0 && whole == 0.0)
    timer.it_value.tv_usec = std::max<suseconds_t>(timer.it_value.tv_usec, 1);
  setitimer(ITIMER_REAL, &timer, nullptr);
  return stopOnSignal();
}

bool timeIsOver()
{
  return time_flag;
}

Progress::Progress(bool often) : Progress(std::cerr, isTerminal(), often || isTerminal() ? OFTEN : SELDOM) {}

Progress::Progress() : stream_(std::cerr), is_terminal_(false), period_(0) {}

Progress::Progress(std::ostream& stream, bool is_terminal, std::chrono::nanoseconds period)
  : stream_(stream), is_terminal_(is_terminal), period_(period), thread_([this] { run(); })
{}

Progress::~Progress()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable())
    thread_.join();
  if (is_terminal_ && has_printed_)
    stream_ << CLEAR_LINE << std::flush;
}

void Progress::tell(const std::string& text)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  text_ = text;
}

void Progress::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  auto next = begin_ + period_;
  while (!wake_.wait_until(lock, next, [this] { return ends_; }))
  {
    print();
    next = std::chrono::steady_clock::now() + period_;
  }
}

void Progress::print()
{
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
  stream_ << (is_terminal_ ? CLEAR_LINE : "") << std::floor(passed.count()) << " s: " << text_
          << (is_terminal_ ? "" : "\n") << std::flush;
  has_printed_ = true;
}
}  // namespace cli
}  // namespace pkm_workspace
