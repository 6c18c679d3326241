// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pkm_workspace
{
namespace test
{
/// What reads texts and bytes that may be anything. The properties that each checks, besides that nothing crashes: what
/// is refused is refused with a reason; what is accepted writes and reads back the same.
struct FuzzTarget
{
  const char* name;  ///< of its folder in corpus/
  void (*run)(const std::string& bytes);
};

/// All that this program has: of the core library, or of messages.
extern const std::vector<FuzzTarget> FUZZ_TARGETS;

/// Ends the program where a property does not hold.
void demand(bool holds, const char* property);
/// @return whether it was accepted; demands a reason where it was refused
bool isAccepted(const std::function<void()>& read);
/// The target of that name. Ends the program, naming all, where there is none.
const FuzzTarget& fuzzTarget(const std::string& name);
}  // namespace test
}  // namespace pkm_workspace
