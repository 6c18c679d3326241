// SPDX-License-Identifier: BSD-3-Clause
#include "whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace pkm_workspace
{
namespace
{
[[noreturn]] void fail(const std::string& path, const char* what, const std::string& reason)
{
  throw std::invalid_argument(path + ": cannot be " + what + ": " + reason);
}

/// Devices and folders are no place for a file, and must not be replaced by one.
void refuseOthers(const std::string& path, const char* what)
{
  struct stat status;
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    fail(path, what, "it is not a regular file");
}

/// The file beside the one to write; gone at the end unless it took its place.
class Draft
{
public:
  explicit Draft(const std::string& path) : path_(path), draft_(path + "." + std::to_string(getpid()) + ".part")
  {
    refuseOthers(path, "written");
    file_ = open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    check(file_ >= 0);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft()
  {
    if (file_ >= 0)
      close(file_);
    if (!placed_)
      unlink(draft_.c_str());
  }

  void write(const std::string& content)
  {
    for (std::size_t done = 0; done < content.size();)
    {
      const ssize_t count = ::write(file_, content.data() + done, content.size() - done);
      check(count >= 0 || errno == EINTR);
      done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    check(fsync(file_) == 0);
  }

  void takePlace()
  {
    check(std::rename(draft_.c_str(), path_.c_str()) == 0);
    placed_ = true;
    const std::size_t slash = path_.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path_.substr(0, slash + 1);
    const int directory = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0)
      return;  // a folder that may be written but not read: the name is as safe as the system makes it
    fsync(directory);
    close(directory);
  }

private:
  void check(bool success)
  {
    if (success)
      return;
    const std::string reason = std::strerror(errno);
    if (file_ < 0)
      placed_ = true;  // there is nothing to remove
    fail(path_, "written", reason);
  }

  std::string path_;
  std::string draft_;
  int file_ = -1;
  bool placed_ = false;
};
}  // namespace

std::string readWholeFile(const std::string& path)
{
  refuseOthers(path, "read");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const std::string content{ std::istreambuf_iterator<char>(file), {} };
  if (!file)
    fail(path, "read", std::strerror(errno));
  return content;
}

void writeWholeFile(const std::string& path, const std::string& content)
{
  Draft draft(path);
  draft.write(content);
  draft.takePlace();
}

void checkWholeFile(const std::string& path)
{
  const Draft draft(path);
}
}  // namespace pkm_workspace
