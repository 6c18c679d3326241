// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "command.h"

namespace pkm_workspace
{
namespace cli
{
void becomePython(const std::string& module, const Words& words)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = program.parent_path().parent_path() / "python3" / "dist-packages";
  const char* const before = std::getenv("PYTHONPATH");
  const bool has_path = before != nullptr && *before != '\0';
  const std::string path = (has_path ? std::string(before) + ":" : "") + beside.string();
  setenv("PYTHONSAFEPATH", "1", 1);  // no module of the current folder
  if (fs::exists(beside, error))
    setenv("PYTHONPATH", path.c_str(), 1);
  Words all = { "python3", "-m", "pkm_workspace." + module };
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  throw Failure("pkm " + module + " of files needs python3: " + std::strerror(errno));
}
}  // namespace cli
}  // namespace pkm_workspace
