// SPDX-License-Identifier: BSD-3-Clause
// g++ calls a function at each edge, libFuzzer looks at counters: it takes those of this section beside clang's own.
#include <cstddef>
#include <cstdint>

namespace
{
constexpr std::size_t COUNTERS = std::size_t(1) << 18;
[[gnu::section("__libfuzzer_extra_counters")]] std::uint8_t counters[COUNTERS];
}  // namespace

extern "C" [[gnu::no_sanitize_coverage]] void __sanitizer_cov_trace_pc()
{
  const auto caller = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
  ++counters[(caller ^ (caller >> 18)) % COUNTERS];
}

// Comparisons of numbers that have a point, of which libFuzzer knows nothing.
extern "C" void __sanitizer_cov_trace_cmpf(float /*a*/, float /*b*/) {}
extern "C" void __sanitizer_cov_trace_cmpd(double /*a*/, double /*b*/) {}
