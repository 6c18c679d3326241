// SPDX-License-Identifier: BSD-3-Clause
/// A disk that fails, or a computer that stops, for tests that preload it. FAILING_FILE can be read up to FAILING_AFTER
/// bytes; then the system reports an input/output error. At the call of the number FAILING_CALL, of those that change
/// the disk (files are created, written, flushed and renamed), the disk is full, or with FAILING_HOW=kill the process
/// is killed; a write has brought half of its bytes to the disk by then.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

namespace
{
template <class Function>
Function* next(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool isFailing(int file)
{
  const char* const failing = std::getenv("FAILING_FILE");
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  char name[PATH_MAX] = {};
  return failing != nullptr && readlink(link.c_str(), name, sizeof(name) - 1) > 0 && std::strcmp(name, failing) == 0;
}

std::size_t numberIn(const char* variable, std::size_t otherwise)
{
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

/// Counts a call. @return whether it has to fail, with errno set
bool fails()
{
  static std::size_t left = numberIn("FAILING_CALL", 0);
  if (left == 0 || --left > 0)
    return false;
  const char* const how = std::getenv("FAILING_HOW");
  if (how != nullptr && std::strcmp(how, "kill") == 0)
    raise(SIGKILL);
  errno = ENOSPC;
  return true;
}
}  // namespace

extern "C" ssize_t read(int file, void* data, size_t size)
{
  static const auto real = next<ssize_t(int, void*, size_t)>("read");
  static std::size_t left = numberIn("FAILING_AFTER", 0);
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

extern "C" int open(const char* path, int flags, ...)
{
  static const auto real = next<int(const char*, int, ...)>("open");
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return (flags & O_CREAT) != 0 && fails() ? -1 : real(path, flags, mode);
}

extern "C" ssize_t write(int file, const void* data, size_t size)
{
  static const auto real = next<ssize_t(int, const void*, size_t)>("write");
  if (file <= STDERR_FILENO)
    return real(file, data, size);
  const ssize_t half = real(file, data, size / 2);
  if (fails())
    return -1;
  const ssize_t rest = real(file, static_cast<const char*>(data) + half, size - static_cast<std::size_t>(half));
  return rest < 0 ? rest : half + rest;
}

extern "C" int fsync(int file)
{
  static const auto real = next<int(int)>("fsync");
  return fails() ? -1 : real(file);
}

extern "C" int rename(const char* from, const char* to) noexcept
{
  static const auto real = next<int(const char*, const char*)>("rename");
  return fails() ? -1 : real(from, to);
}
