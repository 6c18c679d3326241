// SPDX-License-Identifier: BSD-3-Clause
#include "python_caller.h"

#include <pybind11/pybind11.h>
#include <signal.h>
#include <unistd.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace py = pybind11;

namespace pkm_workspace
{
namespace python
{
namespace
{
/// Asks callers to stop when their time is over: one thread for all of them, which begins with the first.
class AlarmClock
{
public:
  using Time = std::chrono::steady_clock::time_point;

  /// That of this process: a fork has no threads.
  static AlarmClock& instance()
  {
    static std::mutex mutex;
    static AlarmClock* clock = nullptr;
    static pid_t process = 0;
    const std::lock_guard<std::mutex> lock(mutex);
    if (process != getpid())
      clock = new AlarmClock;  // never ends, as the process may at any time
    process = getpid();
    return *clock;
  }

  void add(Time time, PythonCaller* caller)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto added = alarms_.emplace(time, caller);
    if (added == alarms_.begin())
      wake_.notify_one();
  }

  void remove(const PythonCaller* caller)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto alarm = alarms_.begin(); alarm != alarms_.end();)
      alarm = alarm->second == caller ? alarms_.erase(alarm) : std::next(alarm);
  }

private:
  AlarmClock()
  {
    std::thread([this] { run(); }).detach();
  }

  void run()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    std::unique_lock<std::mutex> lock(mutex_);
    while (true)
    {
      if (alarms_.empty())
        wake_.wait(lock);
      else
        wake_.wait_until(lock, Time(alarms_.begin()->first));
      while (!alarms_.empty() && alarms_.begin()->first <= std::chrono::steady_clock::now())
      {
        alarms_.begin()->second->askToStop(true);
        alarms_.erase(alarms_.begin());
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::multimap<Time, PythonCaller*> alarms_;
};

/// Longer than any computation takes [s].
constexpr double LONGEST = 1e8;

std::atomic<PythonCaller*> interrupted{ nullptr };
std::atomic<int> presses{ 0 };
std::atomic<bool> asks_python{ false };
struct sigaction python_action = {};

void onInterrupt(int signal)
{
  if (PythonCaller* const caller = interrupted)
    caller->askToStop(false);
  if (++presses > 1 || asks_python)
    python_action.sa_handler(signal);
}
}  // namespace

PythonCaller::~PythonCaller()
{
  if (has_alarm_)
    AlarmClock::instance().remove(this);
}

const std::atomic<bool>* PythonCaller::stopAfter(double seconds)
{
  has_alarm_ = seconds > 0.0;
  if (has_alarm_)
    AlarmClock::instance().add(
        std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(std::min(seconds, LONGEST))),
        this);
  return &stop_;
}

cli::Progress PythonCaller::progress(bool often)
{
  return often ? cli::Progress(true) : cli::Progress();
}

void PythonCaller::askToStop(bool by_time)
{
  if (by_time)
    time_is_over_ = true;
  stop_ = true;
}

StopsOnInterrupt::StopsOnInterrupt(PythonCaller& caller)
{
  const py::module_ threading = py::module_::import("threading");
  if (py::cast<unsigned long>(threading.attr("main_thread")().attr("ident")) != PyThread_get_thread_ident())
    return;
  struct sigaction action = {};
  sigaction(SIGINT, nullptr, &python_action);
  const bool is_python = (python_action.sa_flags & SA_SIGINFO) == 0 && python_action.sa_handler != SIG_IGN &&
                         python_action.sa_handler != SIG_DFL;
  if (!is_python)
    return;
  const py::module_ signals = py::module_::import("signal");
  asks_python = !signals.attr("getsignal")(SIGINT).is(signals.attr("default_int_handler"));
  presses = 0;
  interrupted = &caller;
  action.sa_handler = onInterrupt;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  is_set_ = true;
}

StopsOnInterrupt::~StopsOnInterrupt()
{
  if (!is_set_)
    return;
  sigaction(SIGINT, &python_action, nullptr);
  interrupted = nullptr;
}
}  // namespace python
}  // namespace pkm_workspace
