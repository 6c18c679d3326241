// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/joint_values.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/random.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A part of the text, from one place of @p mark (or anywhere) to the next.
std::pair<std::size_t, std::size_t> anyPart(const std::string& text, char mark, Random& random)
{
  const auto anywhere = static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
  const std::size_t begin = std::min(text.find(mark, anywhere), text.size() - 1);
  const std::size_t end = std::min(text.find(mark, begin + 1), text.size());
  return { begin, end - begin };
}

/// Changes one thing: a byte, an element lost or doubled, two elements or values exchanged, a value that is hard to
/// bear.
std::string mutated(std::string text, Random& random)
{
  const char* const values[] = { "",         "0",      "-0",  "1e308", "-1e-308", "1e-320", "nan",
                                 "inf",      "0 0 0",  "1 1", "tip_1", "\xff",    "1,5",    "1e9 0 0",
                                 "0 0 1e-9", "rail_x", "-1",  "1e400", "0x1p3",   " 1 2 3 " };
  const char mark = random.once(3) ? '"' : '<';
  const auto part = anyPart(text, mark, random);
  const auto other = anyPart(text, mark, random);
  switch (random.integer(0, 5))
  {
    case 0:
      text[part.first] = static_cast<char>(random.integer(0, 255));
      return text;
    case 1:
      return text.erase(part.first, part.second);
    case 2:
      return text.insert(part.first, text.substr(other.first, other.second));
    case 3:
      return text.replace(part.first, part.second, text.substr(other.first, other.second));
    case 4:
    {
      const auto value = anyPart(text, '"', random);
      return text.replace(value.first, value.second, std::string("\"") + values[random.integer(0, 19)]);
    }
    default:
      return text.substr(0, part.first) + text.substr(part.first + 1);
  }
}

/// Reads a text that may be anything: it is a machine that can be written, or refused with a reason.
bool isReadOrRefused(const std::string& text)
{
  try
  {
    const UrdfMachine urdf = readUrdf(text);
    EXPECT_TRUE(readUrdf(writeUrdf(urdf.machine)).machine.aspect() == urdf.machine.aspect());
    jointValues(urdf, urdf.machine.zero());
    return true;
  }
  catch (const std::invalid_argument& refusal)
  {
    EXPECT_FALSE(std::string(refusal.what()).empty());
    return false;
  }
}
}  // namespace

TEST(UrdfFuzz, brokenFilesAreReadOrRefused)
{
  const std::uint64_t seed = 31058;
  Random random(seed);
  const std::string files[] = { writeUrdf(orthoglide()), mounted(writeUrdf(uranesx()), "rpy=\"0.1 0.2 0.3\"") };
  int read = 0;
  const int runs = cases(3000);
  for (int run = 0; run < runs; ++run)
  {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", run " + std::to_string(run));
    std::string text = files[run % 2];
    for (int changes = random.integer(1, 3); changes > 0; --changes)
      text = mutated(text, random);
    read += isReadOrRefused(text) ? 1 : 0;
  }
  // Most of a file is looks: a part of the changes does no harm, a part does.
  EXPECT_GT(read, runs / 100);
  EXPECT_LT(read, runs);
}
}  // namespace test
}  // namespace pkm_workspace
