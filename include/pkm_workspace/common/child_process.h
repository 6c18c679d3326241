// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pkm_workspace
{
/// Another program that runs as long as this object lives: no shell starts it, it reads nothing, and what it prints is
/// read from here.
class ChildProcess
{
public:
  /// @param words its name, which is looked for in PATH, and its arguments
  /// @param errors the file that takes its standard error
  /// @throws std::invalid_argument with the reason of the system where it cannot be started
  ChildProcess(const std::vector<std::string>& words, const std::string& errors);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  /// Kills it.
  ~ChildProcess();

  /// As a ByteSource of its standard output. @param is_over ends the wait: then there is nothing more to read
  std::size_t read(char* data, std::size_t size, const std::function<bool()>& is_over);
  /// Waits until it has ended. @param is_over kills it
  /// @return its exit code; 128 more than the number of a signal that ended it
  int wait(const std::function<bool()>& is_over);

private:
  pid_t id_ = -1;
  int output_ = -1;
};

/// A new folder for temporary files, which is gone with this object.
class TemporaryFolder
{
public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  std::string path(const std::string& name) const { return path_ + "/" + name; }

private:
  std::string path_;
};
}  // namespace pkm_workspace
