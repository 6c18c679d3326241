// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/version.h"

namespace pkm_workspace
{
const char* version()
{
  return PKM_WORKSPACE_VERSION;
}
}  // namespace pkm_workspace
