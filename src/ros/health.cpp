// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/health.h"

namespace pkm_workspace
{
void Health::noteComputation(const Computation& computation)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.computations;
  report_.last = computation;
}

void Health::countRefusal(const std::string& name, std::int32_t error_code, const std::string& reason)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.refusals[error_code];
  report_.last_refusal = name + ": " + reason;
}

Health::Report Health::report() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}
}  // namespace pkm_workspace
