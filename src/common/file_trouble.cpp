// SPDX-License-Identifier: BSD-3-Clause
#include "file_trouble.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace pkm_workspace
{
namespace
{
struct Remedy
{
  int error;
  const char* text;
};

constexpr Remedy REMEDIES[] = {
  { ENOENT, "check the name and its folder" },
  { ENOTDIR, "check the name and its folder" },
  { EACCES, "ask for permission, or use a copy elsewhere" },
  { EPERM, "ask for permission, or use a copy elsewhere" },
  { EROFS, "name a file on a disk that may be written" },
  { ENOSPC, "free some space, or name a file on another disk" },
  { EDQUOT, "free some space, or name a file on another disk" },
  { EFBIG, "raise the limit on the size of files (ulimit -f), or name a file on another disk" },
  { EIO, "the disk or connection fails; use a copy elsewhere" },
  { EBUSY, "it is mounted by itself; name a file in another folder" },
};
}  // namespace

void failFile(const std::string& path, const char* done, const std::string& reason)
{
  throw std::invalid_argument(path + ": cannot be " + done + ": " + reason);
}

std::string reasonOf(int error)
{
  std::string text = std::strerror(error);
  for (const Remedy& remedy : REMEDIES)
    if (remedy.error == error)
      text += std::string("; ") + remedy.text;
  return text;
}

std::string otherKind(unsigned mode)
{
  if (S_ISREG(mode))
    return "";
  return S_ISDIR(mode) ? "it is a folder, not a regular file; name a file in it" : "it is not a regular file; name one";
}
}  // namespace pkm_workspace
