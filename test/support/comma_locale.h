// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <stdexcept>
#include <string>

namespace pkm_workspace
{
namespace test
{
/// For as long as it lives, C and C++ write 1234,5 as 1.234,5 all over the process.
class CommaLocale
{
public:
  CommaLocale() : folder_(makeLocale()), before_(std::setlocale(LC_ALL, nullptr))
  {
    setenv("LOCPATH", folder_.c_str(), 1);
    const bool is_set = std::setlocale(LC_NUMERIC, "comma") != nullptr;
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder_);
    if (!is_set || std::strtod("0,5", nullptr) != 0.5)
      throw std::runtime_error("localedef made no locale with a comma");
    streams_ = std::locale::global(std::locale(std::locale::classic(), new Punctuation));
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale()
  {
    std::locale::global(streams_);
    std::setlocale(LC_ALL, before_.c_str());
  }

private:
  struct Punctuation : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  static std::string makeLocale()
  {
    std::string folder = testing::TempDir() + "localeXXXXXX";
    if (mkdtemp(&folder[0]) == nullptr)
      throw std::runtime_error("no folder for the locale");
    std::ofstream(folder + "/source") << "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\n"
                                      << "END LC_NUMERIC\n";
    // it lacks all other categories, which localedef tells by a code
    const int code =
        std::system(("localedef -c -i " + folder + "/source " + folder + "/comma >/dev/null 2>&1").c_str());
    return code < 0 ? "" : folder;
  }

  std::string folder_;
  std::string before_;
  std::locale streams_;
};
}  // namespace test
}  // namespace pkm_workspace
