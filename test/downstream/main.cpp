// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "pkm_workspace/machine/catalogue.h"

int main()
{
  const pkm_workspace::Machine machine = pkm_workspace::orthoglide();
  std::cout << machine.name() << ' ' << machine.geometryHash() << '\n';
}
