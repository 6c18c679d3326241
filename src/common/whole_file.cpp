// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>

#include "file_trouble.h"

namespace pkm_workspace
{
namespace
{
namespace fs = std::filesystem;

constexpr int RANDOM_DIGITS = 16;
constexpr int MOST_LINKS = 40;
constexpr int MOST_DRAFTS = 10;
const std::string ENDING = ".part";

/// What a symbolic link stands for in the end.
std::string targetOf(const std::string& path)
{
  fs::path target = path;
  std::error_code none;
  for (int k = 0; fs::is_symlink(target, none); ++k)
  {
    if (k == MOST_LINKS)
      failFile(path, "written", reasonOf(ELOOP));
    const fs::path next = fs::read_symlink(target, none);
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

std::string folderOf(const std::string& path)
{
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

bool isDraftName(const std::string& name, const std::string& of)
{
  const std::size_t size = of.size() + 1 + RANDOM_DIGITS + ENDING.size();
  return name.size() == size && name.compare(0, of.size() + 1, of + ".") == 0 &&
         name.find_first_not_of("0123456789abcdef", of.size() + 1) == size - ENDING.size() &&
         name.compare(size - ENDING.size(), ENDING.size(), ENDING) == 0;
}

/// Drafts are locked as long as somebody writes them.
void removeIfLeft(const std::string& draft)
{
  const int file = open(draft.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (file < 0)
    return;
  if (flock(file, LOCK_EX | LOCK_NB) == 0)
    unlink(draft.c_str());
  close(file);
}

void removeLeftDrafts(const std::string& path)
{
  const std::string name = fs::path(path).filename().string();
  std::error_code error;
  for (fs::directory_iterator entry(folderOf(path), error), end; !error && entry != end; entry.increment(error))
    if (isDraftName(entry->path().filename().string(), name))
      removeIfLeft(entry->path().string());
}

/// The file beside the one to write; gone at the end unless it took its place.
class Draft
{
public:
  Draft(const std::string& path, const DraftNames& names) : path_(path), target_(targetOf(path))
  {
    struct stat replaced;
    const bool replaces = stat(target_.c_str(), &replaced) == 0;
    if (replaces && !S_ISREG(replaced.st_mode))
      failFile(path_, "written", otherKind(replaced.st_mode));
    removeLeftDrafts(target_);
    create(names);
    if (replaces)
      keep(replaced);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft()
  {
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
    check(std::rename(draft_.c_str(), target_.c_str()) == 0);
    placed_ = true;
    const int directory = open(folderOf(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0)
      return;  // a folder that may be written but not read: the name is as safe as the system makes it
    fsync(directory);
    close(directory);
  }

private:
  /// A name may be taken. A draft that was not locked yet may have been taken for one that was left; some file systems
  /// count no links.
  void create(const DraftNames& names)
  {
    struct stat status = {};
    for (int turn = 0; turn < MOST_DRAFTS && status.st_nlink == 0; ++turn)
    {
      if (file_ >= 0)
        close(file_);
      draft_ = target_ + "." + names() + ENDING;
      file_ = open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ < 0 && errno == EEXIST)
        continue;
      check(file_ >= 0);
      flock(file_, LOCK_EX);
      fstat(file_, &status);
    }
    check(file_ >= 0);
  }

  /// As far as the user may: only root gives files away.
  void keep(const struct stat& replaced)
  {
    const bool owned = fchown(file_, replaced.st_uid, replaced.st_gid) == 0;
    fchmod(file_, replaced.st_mode & (owned ? 07777U : 0777U));
  }

  [[noreturn]] void fail() const { failFile(path_, "written", reasonOf(errno) + " (by way of " + draft_ + ")"); }
  void check(bool success) const
  {
    if (!success)
      fail();
  }

  std::string path_;
  std::string target_;
  std::string draft_;
  int file_ = -1;
  bool placed_ = false;
};
}  // namespace

std::string unguessable()
{
  std::random_device random;
  std::string digits;
  for (int k = 0; k < RANDOM_DIGITS; ++k)
    digits += "0123456789abcdef"[random() % 16];
  return digits;
}

void writeWholeFile(const std::string& path, const std::string& content, const DraftNames& names)
{
  Draft draft(path, names);
  draft.write(content);
  draft.takePlace();
}

void checkWholeFile(const std::string& path)
{
  const Draft draft(path, unguessable);
}
}  // namespace pkm_workspace
