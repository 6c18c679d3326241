// SPDX-License-Identifier: BSD-3-Clause
// Runs the targets on what fuzzing has kept: corpora CORPUS-FOLDER, of which each target has a folder of its name.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "fuzz/targets.h"

namespace
{
/// @return how many files there were
std::size_t runAll(const pkm_workspace::test::FuzzTarget& target, const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files)
  {
    std::cout << target.name << " " << file.filename().string() << std::endl;
    std::ifstream stream(file, std::ios::binary);
    target.run({ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() });
  }
  return files.size();
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: corpora CORPUS-FOLDER\n";
    return 2;
  }
  for (const auto& target : pkm_workspace::test::FUZZ_TARGETS)
    if (runAll(target, std::filesystem::path(argv[1]) / target.name) == 0)
    {
      std::cerr << "no files for " << target.name << "\n";
      return 1;
    }
  return 0;
}
