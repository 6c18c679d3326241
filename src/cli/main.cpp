// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "application.h"

int main(int argc, char** argv)
{
  return pkm_workspace::cli::run({ argv + 1, argv + argc }, std::cout, std::cerr);
}
