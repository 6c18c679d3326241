// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <vector>

#include "files/folder.h"
#include "pkm_workspace/common/whole_file.h"
#include "support/expect_throw.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Names = std::set<std::string>;
namespace fs = std::filesystem;

class Writing : public Folder
{
protected:
  mode_t modeOf(const std::string& name) const
  {
    struct stat status = {};
    stat(path(name).c_str(), &status);
    return status.st_mode & 07777U;
  }
};

/// As a full disk: files may not grow beyond so many bytes.
class FullDisk
{
public:
  explicit FullDisk(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited = { bytes, before_.rlim_max };
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
  rlimit before_;
};
}  // namespace

TEST_F(Writing, aFullDiskLeavesWhatIsThere)
{
  writeWholeFile(path("it"), "before");
  {
    const FullDisk disk(1000);
    expectThrow<std::invalid_argument>([this] { writeWholeFile(path("it"), std::string(5000, 'x')); },
                                       "it: cannot be written: File too large; .*by way of .*it.*part");
    expectThrow<std::invalid_argument>([this] { writeWholeFile(path("new"), std::string(5000, 'x')); }, "File too la");
  }
  EXPECT_EQ(content("it"), "before");
  EXPECT_EQ(names(), Names{ "it" });
  writeWholeFile(path("it"), std::string(5000, 'x'));
  EXPECT_EQ(content("it").size(), 5000U);
  EXPECT_EQ(names(), Names{ "it" });
}

TEST_F(Writing, keepsThePermissions)
{
  const mode_t mask = umask(027);
  writeWholeFile(path("new"), "a");
  umask(mask);
  EXPECT_EQ(modeOf("new"), 0640U);
  for (const mode_t mode : { 0600U, 0644U, 0755U, 0666U })
  {
    chmod(path("new").c_str(), mode);
    writeWholeFile(path("new"), "b");
    EXPECT_EQ(modeOf("new"), mode);
  }
}

TEST_F(Writing, keepsSymbolicLinks)
{
  fs::create_directory(folder_ / "sub");
  fs::create_symlink("sub/it", folder_ / "near");
  fs::create_symlink(folder_ / "near", folder_ / "far");
  for (const char* const link : { "far", "near" })  // the first one names nothing yet
  {
    writeWholeFile(path(link), link);
    EXPECT_TRUE(fs::is_symlink(folder_ / link));
    EXPECT_EQ(content("sub/it"), link);
  }
  EXPECT_EQ(names(), (Names{ "far", "near", "sub" }));
  fs::create_symlink("loop", folder_ / "loop");
  expectThrow<std::invalid_argument>([this] { writeWholeFile(path("loop"), "a"); }, "loop: .*symbolic links");
}

TEST_F(Writing, removesWhatKilledRunsLeft)
{
  // a draft of the process id, which had a name that returns
  put("it." + std::to_string(getpid()) + ".part", "left");
  put("it.0123456789abcdef.part", "left");
  put("other.0123456789abcdef.part", "another file's");
  put("it.notes.part", "a user's");
  put("it.0123456789abcdef.parts", "a user's");
  const Names kept = { "it." + std::to_string(getpid()) + ".part", "other.0123456789abcdef.part", "it.notes.part",
                       "it.0123456789abcdef.parts" };
  Names all = kept;
  checkWholeFile(path("it"));
  EXPECT_EQ(names(), all);
  writeWholeFile(path("it"), "a");
  all.insert("it");
  EXPECT_EQ(names(), all);
}

/// As somebody who writes that draft: it is locked and stays.
class Taken
{
public:
  explicit Taken(const std::string& draft) : file_(open(draft.c_str(), O_RDWR | O_CREAT, 0600))
  {
    flock(file_, LOCK_EX);
  }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;
  ~Taken() { close(file_); }

private:
  int file_;
};

TEST_F(Writing, triesTenNamesForItsDraft)
{
  writeWholeFile(path("it"), "before");
  const std::string digits = "00000000000000";
  std::vector<std::unique_ptr<Taken>> taken;
  Names all = { "it" };
  const auto take = [&](int k) {
    const std::string name = "it." + digits + std::to_string(k) + ".part";
    taken.push_back(std::make_unique<Taken>(path(name)));
    all.insert(name);
  };
  int asked = 10;
  const auto next = [&] { return digits + std::to_string(asked++); };
  for (int k = 10; k < 19; ++k)
    take(k);
  writeWholeFile(path("it"), "after", next);  // the tenth is free
  EXPECT_EQ(asked, 20);
  EXPECT_EQ(content("it"), "after");
  EXPECT_EQ(names(), all);

  take(19);
  asked = 10;
  expectThrow<std::invalid_argument>([&] { writeWholeFile(path("it"), "lost", next); },
                                     "it: cannot be written: File exists.*by way of .*it.0{14}19.part");
  EXPECT_EQ(asked, 20);
  EXPECT_EQ(content("it"), "after");
  EXPECT_EQ(names(), all);
}

TEST_F(Writing, manyAtOnceLeaveOneOfTheirContents)
{
  const std::string texts[] = { std::string(100000, 'a'), std::string(50000, 'b') };
  pid_t children[2];
  for (int k = 0; k < 2; ++k)
  {
    children[k] = fork();
    if (children[k] == 0)
    {
      for (int round = 0; round < 50; ++round)
        writeWholeFile(path("it"), texts[k]);
      _exit(0);
    }
  }
  for (const pid_t child : children)
  {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_TRUE(content("it") == texts[0] || content("it") == texts[1]);
  EXPECT_EQ(names(), Names{ "it" });
}

TEST_F(Writing, namesWhatItCannotReplace)
{
  const auto refuses = [](const std::string& path, const std::string& reason) {
    expectThrow<std::invalid_argument>([&] { writeWholeFile(path, "a"); }, path + ": cannot be written: " + reason);
    expectThrow<std::invalid_argument>([&] { checkWholeFile(path); }, path + ": cannot be written: " + reason);
  };
  refuses(path("none/it"), "No such file or directory; check the name and its folder");
  refuses(folder_.string(), "it is a folder");
  refuses("/dev/null", "it is not a regular file");
  EXPECT_EQ(names(), Names{});
}
}  // namespace test
}  // namespace pkm_workspace
