// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pkm_workspace
{
/// What became of a certificate.
struct Verification
{
  std::vector<std::string> verified;  ///< one sentence for each claim that holds
  std::string refused;                ///< the first thing that does not hold, with its place; empty where all does
};

/// Told now and then how many leaves of the proofs have been checked. @return whether to go on
using VerificationProgress = std::function<bool(std::int64_t leaves)>;

/// Checks every step of a certificate (docs/certificate.md) in arithmetic of its own: mean-value forms in balls of some
/// forty digits. It searches nothing, and shares nothing with what wrote the file but the format.
/// @param text JSON @throws std::invalid_argument where it is none
Verification verifyCertificate(const std::string& text, const VerificationProgress& progress = nullptr);
}  // namespace pkm_workspace
