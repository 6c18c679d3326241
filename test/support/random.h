// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// How many random cases a law is tried on: @p few, or PKM_WORKSPACE_TEST_CASES times as many.
inline int cases(int few = 100)
{
  const char* const text = std::getenv("PKM_WORKSPACE_TEST_CASES");
  if (text == nullptr)
    return few;
  char* end = nullptr;
  const long factor = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || factor < 1 || factor > 100000)
    throw std::invalid_argument("PKM_WORKSPACE_TEST_CASES = '" + std::string(text) + "' must be from 1 to 100000");
  return few * static_cast<int>(factor);
}

/// What all random cases start from.
constexpr unsigned SEED = 20261127;

/// Random numbers that are the same on every machine: the distributions of the standard library are not.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// A number of [lower, upper].
  double uniform(double lower, double upper)
  {
    const double fraction = static_cast<double>(engine_() >> 11) * 0x1p-53;
    return lower + fraction * (upper - lower);
  }
  /// One of lower, ..., upper.
  int integer(int lower, int upper)
  {
    return lower + static_cast<int>(engine_() % static_cast<std::uint64_t>(upper - lower + 1));
  }
  /// True once in @p times, on average.
  bool once(int times) { return integer(1, times) == 1; }
  double sign() { return once(2) ? -1.0 : 1.0; }

private:
  std::mt19937_64 engine_;
};
}  // namespace test
}  // namespace pkm_workspace
