// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "pkm_workspace/dexterity/criterion.h"
#include "pkm_workspace/machine/machine.h"

namespace pkm_workspace
{
/// What has no bounded answer, with the reason. The remedy is the caller's to name: it knows what its options are
/// called.
class Unbounded : public std::invalid_argument
{
public:
  enum class What
  {
    SET,   ///< the points are too many
    SHAPE  ///< they are bounded but along the rails, and the shape is not across them
  };

  Unbounded(What what, const std::string& reason, const Machine& machine, const Criterion& criterion);

  What kind() const { return what_; }
  /// Whether the machine has joint limits, and whether they were asked for and did not bound it.
  bool hasLimits() const { return has_limits_; }
  bool asksForLimits() const { return asks_for_limits_; }

private:
  What what_;
  bool has_limits_;
  bool asks_for_limits_;
};

/// @throws Unbounded: the set is longer than 1000 struts
[[noreturn]] void throwUnbounded(const Machine& machine, const Criterion& criterion);

/// What a caller's options can do about it, each as the end of "ask for ...".
struct Remedy
{
  std::string limits;  ///< how joint limits are asked for
  std::string part;    ///< what bounds the points, "a search box" for instance; empty where there is nothing
};

/// The reason, and the remedies that exist for it.
std::string describe(const Unbounded& unbounded, const Remedy& remedy);

/// The answer of @p ask. @throws std::invalid_argument with the remedy where it throws Unbounded
template <class Ask>
auto withRemedy(const Remedy& remedy, const Ask& ask)
{
  try
  {
    return ask();
  }
  catch (const Unbounded& unbounded)
  {
    throw std::invalid_argument(describe(unbounded, remedy));
  }
}
}  // namespace pkm_workspace
