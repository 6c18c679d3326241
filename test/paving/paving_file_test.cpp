// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/paving/paving_file.h"
#include "pkm_workspace/common/whole_file.h"
#include "pkm_workspace/version.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/crc.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "files/folder.h"
#include "paving/pavings.h"
#include "support/cases.h"
#include "support/expect_throw.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace
{
using test::SEED;
constexpr std::size_t SIZE_PLACE = 15;    // of the file's size in it
constexpr std::size_t FIRST_CHOICE = 80;  // behind the texts

using test::query;

class PavingFile : public test::Folder
{
protected:
  std::string read() const { return content("it.paving"); }
  void write(const std::string& bytes) const { put("it.paving", bytes); }
  std::vector<Paving> load() const { return loadPavings(file_, orthoglide(), { query(0.2) }); }
  void expectRefused(const std::string& pattern) const
  {
    test::expectThrow<std::invalid_argument>([&] { load(); }, "it\\.paving: .*" + pattern);
  }
  std::size_t filesInFolder() const { return names().size(); }

  const std::string file_ = path("it.paving");
};

/// Changes that a disk, a network or a hand may make; at least one byte is another one afterwards.
std::string corrupted(const std::string& bytes, test::Random& random)
{
  const auto place = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1)); };
  std::string result = bytes;
  while (result == bytes)
  {
    const std::size_t at = place(), size = std::min(place(), bytes.size() - at);
    switch (random.integer(0, 5))
    {
      case 0:
        result[at] = static_cast<char>(result[at] ^ (1 << random.integer(0, 7)));
        break;
      case 1:
        result.resize(at);
        break;
      case 2:
        result.erase(at, size);
        break;
      case 3:
        result.insert(at, std::string(size + 1, static_cast<char>(random.integer(0, 255))));
        break;
      case 4:
        for (std::size_t k = at; k < at + size; ++k)
          result[k] = static_cast<char>(random.integer(0, 255));
        break;
      default:
        result = bytes.substr(at) + bytes.substr(0, at);
    }
  }
  return result;
}

/// With the size and the checksum that the bytes should have.
std::string signedAgain(std::string bytes)
{
  for (std::size_t k = 0; k < 8; ++k)
    bytes[SIZE_PLACE + k] = static_cast<char>(bytes.size() >> (8 * k) & 0xff);
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size() - 4);
  for (std::size_t k = 0; k < 4; ++k)
    bytes[bytes.size() - 4 + k] = static_cast<char>(crc.checksum() >> (8 * k) & 0xff);
  return bytes;
}

/// A file of format 2, part by part: one paving of [-1, 1]^3 by one box, that is at the border.
std::string fileOfFormat2(bool joint_limits)
{
  ByteWriter writer;
  writer.raw("PKM paving\n", 11);
  writer.number(std::uint32_t(2));
  writer.number(std::uint64_t(0));  // the size
  writer.text(version());
  writer.number(std::uint32_t(1));
  writer.text("85bd3fa7-2df2-5308-98eb-f3d7b6103531");
  writer.raw("\0\0", 2);  // dextrous, own aspect
  for (const double bound : { 0.5, 2.0, 0.0, 0.0, 0.0 })
    writer.real(bound);
  writer.number(static_cast<std::uint8_t>(joint_limits));
  for (const double number : { 5.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0 })
    writer.real(number);  // resolution, box
  writer.number(static_cast<std::uint8_t>(CellState::BOUNDARY));
  writer.number(std::uint32_t(0));  // the checksum
  return signedAgain(writer.bytes());
}
}  // namespace

TEST_F(PavingFile, isOfTheFormatThatItAlwaysHad)
{
  savePavings(file_, { pave(orthoglide(), query(5.0)) });
  EXPECT_EQ(read(), fileOfFormat2(false));
}

// Joint limits of a machine that has none were told apart once.
TEST_F(PavingFile, ofEarlierDaysIsReadAndGoneOnFrom)
{
  const Paving whole = pave(orthoglide(), query(5.0));
  for (const bool were_asked_for : { false, true })
    for (const bool are_asked_for : { false, true })
    {
      write(fileOfFormat2(were_asked_for));
      PavingQuery wanted = query(0.2);
      wanted.criterion.joint_limits = are_asked_for;
      const std::vector<Paving> loaded = loadPavings(file_, orthoglide(), { wanted });
      test::expectSame(whole, loaded[0]);
      test::expectSame(pave(orthoglide(), query(0.2)), resume(orthoglide(), wanted, loaded[0]));
    }
}

TEST_F(PavingFile, givesBackWhatWasSaved)
{
  PavingQuery ended = query(0.05, Criterion::Set::REACHABLE, Criterion::Aspect::BOTH);
  ended.budget.max_boxes = 3000;
  PavingQuery plane = query(0.02);
  plane.box.reset();
  for (const Machine& machine : { orthoglide(), uranesx() })
  {
    const std::vector<PavingQuery> queries = { query(0.1), ended, machine.hasParallelRails() ? plane : ended };
    std::vector<Paving> pavings;
    for (const PavingQuery& wanted : queries)
      pavings.push_back(pave(machine, wanted));
    savePavings(file_, pavings);
    const std::vector<Paving> loaded = loadPavings(file_, machine, queries);
    ASSERT_EQ(loaded.size(), pavings.size());
    for (std::size_t k = 0; k < loaded.size(); ++k)
      test::expectSame(pavings[k], loaded[k]);
    EXPECT_EQ(filesInFolder(), 1U);
  }
}

TEST_F(PavingFile, isWhereAFinerRunGoesOn)
{
  PavingQuery wanted = query(0.1);
  wanted.budget.max_boxes = 2000;
  savePavings(file_, { pave(orthoglide(), wanted) });
  const Paving fine = resume(orthoglide(), query(0.03), loadPavings(file_, orthoglide(), { query(0.03) })[0]);
  test::expectSame(pave(orthoglide(), query(0.03)), fine);
}

TEST_F(PavingFile, ofAnEmptySetHasNoBoxes)
{
  PavingQuery wanted = query(0.1);
  wanted.box.reset();
  wanted.criterion.joint_limits = true;
  Machine::Legs legs = orthoglide().legs();
  for (Leg& leg : legs)
    leg.limits = Interval(50.0, 60.0);
  const Machine machine("far", legs, orthoglide().zero());
  const Paving paving = pave(machine, wanted);
  EXPECT_EQ(paving.volumeUpper(), 0.0);
  savePavings(file_, { paving });
  test::expectSame(paving, resume(machine, wanted, loadPavings(file_, machine, { wanted })[0]));
}

TEST_F(PavingFile, everyCorruptionIsRefused)
{
  savePavings(file_, { pave(orthoglide(), query(0.2)) });
  const std::string bytes = read();
  test::Random random(SEED);
  for (int k = 0; k < test::cases(1000); ++k)
  {
    write(corrupted(bytes, random));
    ASSERT_THROW(load(), std::invalid_argument) << "case " << k << ", seed " << SEED;
  }
}

// Whoever forges the checksum, too, gets a tree or a refusal, and neither a crash nor memory that the file does not
// fill.
TEST_F(PavingFile, garbageThatIsSignedIsATreeOrRefused)
{
  savePavings(file_, { pave(orthoglide(), query(0.2)) });
  const std::string bytes = read();
  test::Random random(SEED);
  int refused = 0;
  for (int k = 0; k < test::cases(1000); ++k)
  {
    std::string forged = corrupted(bytes, random);
    if (forged.size() < FIRST_CHOICE)
      continue;
    write(signedAgain(bytes.substr(0, SIZE_PLACE) + forged.substr(SIZE_PLACE)));
    try
    {
      const Paving paving = load()[0];
      EXPECT_LE(static_cast<std::size_t>(paving.boxes), forged.size());
      resume(orthoglide(), query(0.2), paving);
    }
    catch (const std::invalid_argument&)
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST_F(PavingFile, refusalsTellTheReason)
{
  savePavings(file_, { pave(orthoglide(), query(0.2)) });
  const std::string bytes = read();
  const auto refuses = [&](const std::string& content, const std::string& pattern) {
    write(content);
    expectRefused(pattern);
  };
  refuses("", "not a paving");
  refuses("solid cube\n", "not a paving");
  refuses(bytes.substr(0, 13), "ends too early");
  refuses(bytes.substr(0, bytes.size() - 1), "bytes instead of .*cut");
  refuses(bytes + "x", "bytes instead of .*added");
  std::string changed = bytes;
  changed[bytes.size() / 2] ^= 1;
  refuses(changed, "checksum .*altered");
  changed = bytes;
  changed[11] = 3;
  refuses(changed, "format 3, this program reads format 2");
  changed = bytes;
  changed[27] = '9';
  refuses(signedAgain(changed), "version 9\\S+ wrote it, this is version \\d");
  changed = bytes;
  changed[bytes.size() - 5] = 0;
  refuses(signedAgain(changed), "state that is not possible");
  changed.insert(bytes.size() - 4, "x");
  changed[bytes.size() - 5] = bytes[bytes.size() - 5];
  refuses(signedAgain(changed), "1 bytes are left over");
  changed = bytes;
  changed.erase(bytes.size() - 5, 1);
  refuses(signedAgain(changed), "ends too early");
}

TEST_F(PavingFile, refusesAnotherSubjectByName)
{
  savePavings(file_, { pave(orthoglide(), query(0.2)) });
  const auto refuses = [&](const Machine& machine, const PavingQuery& wanted, const std::string& pattern) {
    test::expectThrow<std::invalid_argument>([&] { loadPavings(file_, machine, { wanted }); },
                                             "it\\.paving: .*" + pattern);
  };
  refuses(uranesx(), query(0.2), orthoglide().geometryHash() + ".*" + uranesx().geometryHash());
  refuses(orthoglide(), query(0.2, Criterion::Set::REACHABLE), "criterion: ");
  PavingQuery wanted = query(0.2);
  wanted.box->lower.z() = -0.5;
  refuses(orthoglide(), wanted, "box: ");
  test::expectThrow<std::invalid_argument>(
      [&] {
        loadPavings(file_, orthoglide(), { query(0.1), query(0.1) });
      },
      "it\\.paving: .*holds 1 pavings, asked for are 2");
}

TEST_F(PavingFile, isReplacedAsAWholeOrNotAtAll)
{
  const std::vector<Paving> pavings = { pave(orthoglide(), query(0.2)) };
  savePavings(file_, pavings);
  std::filesystem::create_directory(folder_ / "sub");
  EXPECT_EQ(filesInFolder(), 2U);
  const auto refuses = [&](const std::string& path, const std::string& pattern) {
    test::expectThrow<std::invalid_argument>([&] { savePavings(path, pavings); }, pattern);
    test::expectThrow<std::invalid_argument>([&] { checkWholeFile(path); }, pattern);
  };
  refuses((folder_ / "none" / "it").string(), "none/it: cannot be written: No such file");
  refuses((folder_ / "sub").string(), "sub: cannot be written: it is a folder, not a regular file; name a file in it");
  refuses("/dev/null", "/dev/null: cannot be written: it is not a regular file");
  test::expectThrow<std::invalid_argument>([&] { loadPavings("/dev/zero", orthoglide(), {}); }, "not a regular file");
  test::expectThrow<std::invalid_argument>([&] { loadPavings((folder_ / "x").string(), orthoglide(), {}); },
                                           "x: cannot be read: No such file");
  checkWholeFile(file_);
  EXPECT_EQ(filesInFolder(), 2U);
  test::expectSame(pavings[0], load()[0]);
}
}  // namespace pkm_workspace
