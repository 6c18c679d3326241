// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <thread>
#include <vector>

#include "files/folder.h"
#include "pkm_workspace/common/whole_file.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Lines = std::vector<std::string>;

class Reading : public Folder
{
};

/// Gives the text in pieces of @p piece bytes, then fails, or ends.
ByteSource pieces(const std::string& text, std::size_t piece, bool fails)
{
  return [text, piece, fails, done = std::size_t(0)](char* data, std::size_t size) mutable {
    const std::size_t count = std::min({ piece, size, text.size() - done });
    if (count == 0 && fails)
      throw std::invalid_argument("the disk is gone");
    std::memcpy(data, text.data() + done, count);
    done += count;
    return count;
  };
}

Lines linesOf(const ByteSource& source)
{
  Lines lines;
  readLines("it", source, [&lines](const std::string& line, std::size_t number) {
    lines.push_back(line.substr(0, 100));
    EXPECT_EQ(number, lines.size());
  });
  return lines;
}
}  // namespace

TEST_F(Reading, linesAreTheSameInPiecesOfAnySize)
{
  Random random(SEED);
  for (int k = 0; k < 200; ++k)
  {
    std::string text;
    for (int byte = random.integer(0, 60); byte > 0; --byte)
      text += "a \n\0#"[random.integer(0, 4)];
    const Lines whole = linesOf(pieces(text, text.size() + 1, false));
    std::string joined;
    for (const std::string& line : whole)
      joined += line + "\n";
    EXPECT_TRUE(joined == text || joined == text + "\n") << "seed " << SEED;
    for (const std::size_t piece : { 1U, 3U, 7U })
      EXPECT_EQ(whole, linesOf(pieces(text, piece, false))) << "seed " << SEED;
  }
}

TEST_F(Reading, failsWhereTheSourceFails)
{
  for (const char* const text : { "", "start 0 0 0\n", "start 0 0 0\nline 0 0" })
    expectThrow<std::invalid_argument>([&] { linesOf(pieces(text, 5, true)); }, "the disk is gone");
}

TEST_F(Reading, endsWithTooLongALineOrText)
{
  EXPECT_EQ(linesOf(pieces(std::string(LONGEST_LINE, 'x'), 1000, false)).size(), 1U);
  expectThrow<std::invalid_argument>([] { linesOf(pieces("\n" + std::string(LONGEST_LINE + 1, 'x'), 1000, false)); },
                                     "it: cannot be read: line 2 has more than the 65536 bytes");
  const ByteSource endless = [](char* data, std::size_t size) {
    std::memset(data, ' ', size);
    data[0] = '\n';
    return size;
  };
  expectThrow<std::invalid_argument>([&] { linesOf(endless); },
                                     "it: cannot be read: it has more than the 1073741824 bytes");
}

TEST_F(Reading, givesAllOfAFileOrRefusesIt)
{
  std::string bytes(200000, '\0');
  for (std::size_t k = 0; k < bytes.size(); ++k)
    bytes[k] = static_cast<char>(k * k / 7);
  put("it", bytes);
  EXPECT_TRUE(readWholeFile(path("it"), bytes.size()) == bytes);
  expectThrow<std::invalid_argument>([&] { readWholeFile(path("it"), bytes.size() - 1); },
                                     "it: cannot be read: it has more than the 199999 bytes");
  // what is mapped nowhere cannot be read: an error of the system in a file that can be opened
  expectThrow<std::invalid_argument>([] { readWholeFile("/proc/self/mem", 100); },
                                     "/proc/self/mem: cannot be read: Input/output error");
  expectThrow<std::invalid_argument>([] { readLines("/proc/self/mem", [](const std::string&, std::size_t) {}); },
                                     "/proc/self/mem: cannot be read: Input/output error");
}

TEST_F(Reading, namesWhatIsNoFile)
{
  const auto refuses = [](const std::string& path, const std::string& reason) {
    expectThrow<std::invalid_argument>([&] { readWholeFile(path, 100); }, path + ": cannot be read: " + reason);
    expectThrow<std::invalid_argument>([&] { readLines(path, [](const std::string&, std::size_t) {}); },
                                       path + ": cannot be read: " + reason);
  };
  refuses(path("none"), "No such file or directory; check the name");
  refuses(path("none/it"), "No such file or directory; check the name");
  refuses(folder_.string(), "it is a folder, not a regular file; name a file in it");
  refuses("/dev/zero", "it is not a regular file");
}

TEST_F(Reading, takesPipes)
{
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([this] { std::ofstream(path("pipe")) << "a\nb"; });
  EXPECT_EQ(readWholeFile(path("pipe"), 100), "a\nb");
  writer.join();
}

TEST_F(Reading, refusesAFileThatGrowsMeanwhile)
{
  put("it", std::string(100000, '\n'));
  expectThrow<std::invalid_argument>(
      [this] {
        readLines(path("it"), [this](const std::string&, std::size_t number) {
          if (number == 99999)
            std::filesystem::resize_file(path("it"), 99999);
        });
      },
      "it: cannot be read: its size changed meanwhile");
}
}  // namespace test
}  // namespace pkm_workspace
