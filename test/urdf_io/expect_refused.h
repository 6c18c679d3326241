// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
/// The Orthoglide's URDF: what the tests break.
inline const std::string& good()
{
  static const std::string urdf = writeUrdf(orthoglide());
  return urdf;
}

inline void expectRefused(const std::string& urdf, const std::string& pattern, const UrdfOptions& options = {})
{
  expectThrow<std::invalid_argument>([&] { readUrdf(urdf, options); }, pattern);
}
}  // namespace test
}  // namespace pkm_workspace
