// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <iostream>
#include <new>

#include "application.h"

namespace
{
/// Ends here and now: without memory, neither an exception nor a stream tells what happened.
[[noreturn]] void endWithoutMemory()
{
  const char* const text = pkm_workspace::cli::OUT_OF_MEMORY;
  const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
  _exit(written < 0 ? 3 : 1);
}
}  // namespace

int main(int argc, char** argv)
{
  std::set_new_handler(endWithoutMemory);
  std::signal(SIGPIPE, SIG_IGN);  // a reader that is gone, or a full disk, is told as an error: then --save still works
  std::signal(SIGXFSZ, SIG_IGN);
  std::ios::sync_with_stdio(false);
  std::cerr.tie(nullptr);  // what goes wrong is told even where standard output fails
  return pkm_workspace::cli::run({ argv + 1, argv + argc }, std::cout, std::cerr);
}
