// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace pkm_workspace
{
/// What the node remembers of its own work, for those who look after it. Thread-safe.
class Health
{
public:
  /// A computation that has ended.
  struct Computation
  {
    std::string question;
    std::string answer;
    double seconds = 0.0;
    bool stopped = false;  ///< before the accuracy asked for was reached
  };

  /// What there is to tell.
  struct Report
  {
    std::int64_t computations = 0;
    Computation last;
    std::map<std::int32_t, std::int64_t> refusals;  ///< how many, for each constant of ErrorCode.msg
    std::string last_refusal;
  };

  void noteComputation(const Computation& computation);
  void countRefusal(const std::string& name, std::int32_t error_code, const std::string& reason);
  Report report() const;

private:
  mutable std::mutex mutex_;
  Report report_;
};
}  // namespace pkm_workspace
