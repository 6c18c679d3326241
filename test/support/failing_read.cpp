// SPDX-License-Identifier: BSD-3-Clause
/// A disk that fails: preloaded, it lets the file FAILING_FILE be read up to FAILING_AFTER bytes; then the system tells
/// an input/output error.
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <string>

namespace
{
bool isFailing(int file)
{
  const char* const failing = std::getenv("FAILING_FILE");
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  char name[PATH_MAX] = {};
  return failing != nullptr && readlink(link.c_str(), name, sizeof(name) - 1) > 0 && std::strcmp(name, failing) == 0;
}
}  // namespace

extern "C" ssize_t read(int file, void* data, size_t size)
{
  using Read = ssize_t (*)(int, void*, size_t);
  static const auto real = reinterpret_cast<Read>(dlsym(RTLD_NEXT, "read"));
  static std::size_t left = std::strtoul(std::getenv("FAILING_AFTER"), nullptr, 10);
  if (!isFailing(file))
    return real(file, data, size);
  if (left == 0)
  {
    errno = EIO;
    return -1;
  }
  const ssize_t count = real(file, data, std::min(size, left));
  left -= static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  return count;
}
