// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// A folder of its own for each test.
class Folder : public testing::Test
{
protected:
  Folder()
  {
    std::string name = testing::TempDir() + "filesXXXXXX";
    if (mkdtemp(&name[0]) == nullptr)
      throw std::runtime_error("no folder for the test");
    folder_ = name;
  }
  ~Folder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const
  {
    std::ifstream stream(path(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(stream), {} };
  }
  void put(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::set<std::string> names() const
  {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      found.insert(entry.path().filename().string());
    return found;
  }

  std::filesystem::path folder_;
};
}  // namespace test
}  // namespace pkm_workspace
