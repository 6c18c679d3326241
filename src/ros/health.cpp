// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/health.h"

#include "pkm_workspace/common/text.h"

namespace pkm_workspace
{
namespace
{
/// What is told again and again, in a table.
constexpr std::size_t LONGEST_TEXT = 1000;
}  // namespace

void Health::noteComputation(const Computation& computation)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.computations;
  report_.last = computation;
  report_.last.question = shortened(computation.question, LONGEST_TEXT);
  report_.last.answer = shortened(computation.answer, LONGEST_TEXT);
}

void Health::countRefusal(const std::string& name, std::int32_t error_code, const std::string& reason)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++report_.refusals[error_code];
  report_.last_refusal = shortened(name + ": " + reason, LONGEST_TEXT);
}

Health::Report Health::report() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}
}  // namespace pkm_workspace
