// SPDX-License-Identifier: BSD-3-Clause
// What libFuzzer calls: the target whose name is in PKM_WORKSPACE_FUZZ_TARGET.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const pkm_workspace::test::FuzzTarget& target = []() -> const pkm_workspace::test::FuzzTarget& {
    const char* const name = std::getenv("PKM_WORKSPACE_FUZZ_TARGET");
    return pkm_workspace::test::fuzzTarget(name == nullptr ? "" : name);
  }();
  target.run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
