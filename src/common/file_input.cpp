// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "file_trouble.h"
#include "pkm_workspace/common/whole_file.h"

namespace pkm_workspace
{
namespace
{
constexpr std::size_t BLOCK = std::size_t(1) << 16;

std::string tooLong(const std::string& what, std::size_t most)
{
  return what + " has more than the " + std::to_string(most) + " bytes that are read";
}

/// A file that is open for reading.
class InputFile
{
public:
  explicit InputFile(const std::string& path) : path_(path), file_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY))
  {
    if (file_ < 0)
      failFile(path_, "read", reasonOf(errno));
    const struct stat status = statusNow();
    if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode) && isatty(file_) == 0)
      refuse(otherKind(status.st_mode));
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile()
  {
    if (file_ >= 0)
      close(file_);
  }

  /// As a ByteSource.
  std::size_t read(char* data, std::size_t size)
  {
    ssize_t count = 0;
    do
      count = ::read(file_, data, size);
    while (count < 0 && errno == EINTR);
    if (count < 0)
      failFile(path_, "read", reasonOf(errno));
    done_ += static_cast<std::size_t>(count);
    if (count == 0)
      checkSize();
    return static_cast<std::size_t>(count);
  }

private:
  /// The destructor of an object that is not complete is not called.
  [[noreturn]] void refuse(const std::string& reason)
  {
    close(file_);
    failFile(path_, "read", reason);
  }

  struct stat statusNow() const
  {
    struct stat status = {};
    fstat(file_, &status);
    return status;
  }

  /// Files that the system makes up have the size 0.
  void checkSize() const
  {
    const struct stat status = statusNow();
    if (S_ISREG(status.st_mode) && status.st_size > 0 && static_cast<std::size_t>(status.st_size) != done_)
      failFile(path_, "read", "its size changed meanwhile; read it when nobody writes it");
  }

  const std::string& path_;
  int file_;
  std::size_t done_ = 0;
};

/// Cuts bytes into lines.
class LineCutter
{
public:
  LineCutter(const std::string& name, const LineTaker& take) : name_(name), take_(take) {}

  void put(const char* data, std::size_t size)
  {
    done_ += size;
    if (done_ > LARGEST_LINES)
      failFile(name_, "read", tooLong("it", LARGEST_LINES));
    for (const char* const end = data + size; data < end;)
    {
      const auto* const found = static_cast<const char*>(std::memchr(data, '\n', static_cast<std::size_t>(end - data)));
      const char* const last = found ? found : end;
      append(data, static_cast<std::size_t>(last - data));
      data = found ? last + 1 : end;
      if (found)
        give();
    }
  }

  /// The last line may lack its end.
  void finish()
  {
    if (!line_.empty())
      give();
  }

private:
  void append(const char* data, std::size_t size)
  {
    if (line_.size() + size > LONGEST_LINE)
      failFile(name_, "read", tooLong("line " + std::to_string(number_), LONGEST_LINE));
    line_.append(data, size);
  }

  void give()
  {
    take_(line_, number_++);
    line_.clear();
  }

  const std::string& name_;
  const LineTaker& take_;
  std::string line_;
  std::size_t number_ = 1;
  std::size_t done_ = 0;
};
}  // namespace

std::string readWholeFile(const std::string& path, std::size_t most)
{
  InputFile file(path);
  std::string content;
  std::vector<char> block(BLOCK);
  while (const std::size_t count = file.read(block.data(), block.size()))
  {
    if (count > most - content.size())
      failFile(path, "read", tooLong("it", most));
    content.append(block.data(), count);
  }
  return content;
}

void readLines(const std::string& name, const ByteSource& source, const LineTaker& take)
{
  LineCutter lines(name, take);
  std::vector<char> block(BLOCK);
  while (const std::size_t count = source(block.data(), block.size()))
    lines.put(block.data(), count);
  lines.finish();
}

void readLines(const std::string& path, const LineTaker& take)
{
  InputFile file(path);
  readLines(
      path, [&file](char* data, std::size_t size) { return file.read(data, size); }, take);
}
}  // namespace pkm_workspace
