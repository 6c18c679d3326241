// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "file_trouble.h"

extern char** environ;

namespace pkm_workspace
{
namespace
{
constexpr int LOOK_EVERY = 50;  // milliseconds
constexpr int BY_SIGNAL = 128;

/// What the program has in place of this one's files.
class ChildFiles
{
public:
  ChildFiles(int output, const std::string& errors)
  {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawnattr_init(&attributes_);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);  // which this program may ignore
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
  }
  ChildFiles(const ChildFiles&) = delete;
  ChildFiles& operator=(const ChildFiles&) = delete;
  ~ChildFiles()
  {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  int start(const std::vector<std::string>& words, pid_t& id) const
  {
    std::vector<char*> arguments;
    for (const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: posix_spawn takes them so, and leaves them
    arguments.push_back(nullptr);
    return posix_spawnp(&id, arguments[0], &actions_, &attributes_, arguments.data(), environ);
  }

private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};
}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::string& errors)
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::invalid_argument(words[0] + " cannot be started: " + reasonOf(errno));
  const int error = ChildFiles(ends[1], errors).start(words, id_);
  close(ends[1]);
  output_ = ends[0];
  if (error == 0)
    return;
  close(output_);
  throw std::invalid_argument(
      words[0] + " cannot be started: " + (error == ENOENT ? "there is no such program in PATH" : reasonOf(error)));
}

ChildProcess::~ChildProcess()
{
  close(output_);
  if (id_ < 0)
    return;
  wait([] { return true; });
}

std::size_t ChildProcess::read(char* data, std::size_t size, const std::function<bool()>& is_over)
{
  pollfd watched = { output_, POLLIN, 0 };
  for (int ready = 0; ready == 0;)
  {
    if (is_over())
      return 0;
    ready = poll(&watched, 1, LOOK_EVERY);
    if (ready < 0 && errno == EINTR)
      ready = 0;
  }
  const ssize_t count = ::read(output_, data, size);
  if (count < 0)
    throw std::invalid_argument("what the program prints cannot be read: " + reasonOf(errno));
  return static_cast<std::size_t>(count);
}

int ChildProcess::wait(const std::function<bool()>& is_over)
{
  int status = 0;
  for (bool is_killed = false;;)
  {
    const pid_t ended = waitpid(id_, &status, is_killed ? 0 : WNOHANG);
    if (ended == id_ || (ended < 0 && errno != EINTR))
      break;
    if (is_killed)
      continue;
    if (is_over())
      is_killed = kill(id_, SIGKILL) == 0;
    else
      poll(nullptr, 0, LOOK_EVERY);
  }
  id_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : BY_SIGNAL + WTERMSIG(status);
}

TemporaryFolder::TemporaryFolder()
{
  std::error_code none;
  path_ = (std::filesystem::temp_directory_path(none) / "pkm_workspace.XXXXXX").string();
  if (none || !mkdtemp(path_.data()))
    failFile(path_, "made", reasonOf(none ? none.value() : errno));
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code none;
  std::filesystem::remove_all(path_, none);
}
}  // namespace pkm_workspace
