// SPDX-License-Identifier: BSD-3-Clause
#include "support/itl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "support/expect_throw.h"
#include "support/rounding_mode.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Intervals = std::vector<Interval>;

/// What the library offers of the standard's operations, by the standard's names.
const std::map<std::string, Interval (*)(const Intervals&)> SETS = {
  { "pos", [](const Intervals& x) { return x.at(0); } },
  { "neg", [](const Intervals& x) { return -x.at(0); } },
  { "add", [](const Intervals& x) { return x.at(0) + x.at(1); } },
  { "sub", [](const Intervals& x) { return x.at(0) - x.at(1); } },
  { "mul", [](const Intervals& x) { return x.at(0) * x.at(1); } },
  { "div", [](const Intervals& x) { return x.at(0) / x.at(1); } },
  { "sqr", [](const Intervals& x) { return sqr(x.at(0)); } },
  { "sqrt", [](const Intervals& x) { return sqrtAboveZero(intersection(x.at(0), Interval(0.0, INF))); } },
  { "abs", [](const Intervals& x) { return abs(x.at(0)); } },
  { "acos", [](const Intervals& x) { return acos(x.at(0)); } },
  { "atan2", [](const Intervals& x) { return angleOf(x.at(1), x.at(0)); } },
  { "intersection", [](const Intervals& x) { return intersection(x.at(0), x.at(1)); } },
  { "convexHull", [](const Intervals& x) { return hull(x.at(0), x.at(1)); } },
};
const std::map<std::string, Interval (*)(double)> OF_SINGLE_NUMBERS = { { "sin", sin }, { "cos", cos } };
const std::map<std::string, double (*)(const Interval&)> NUMBERS = {
  { "inf", [](const Interval& x) { return x.lower(); } },
  { "sup", [](const Interval& x) { return x.upper(); } },
  { "wid", [](const Interval& x) { return x.width(); } },
  { "mag", [](const Interval& x) { return x.magnitude(); } },
  { "mig", [](const Interval& x) { return x.mignitude(); } },
};
const std::map<std::string, bool (*)(const Intervals&)> RELATIONS = {
  { "isEmpty", [](const Intervals& x) { return x.at(0).isEmpty(); } },
  { "isEntire", [](const Intervals& x) { return x.at(0) == Interval::entire(); } },
  { "isSingleton", [](const Intervals& x) { return x.at(0).isSingle(); } },
  { "equal", [](const Intervals& x) { return x.at(0) == x.at(1); } },
  { "subset", [](const Intervals& x) { return x.at(0).isSubsetOf(x.at(1)); } },
  { "disjoint", [](const Intervals& x) { return !x.at(0).intersects(x.at(1)); } },
};

enum class Outcome
{
  CONTAINED,    ///< as tight as the vector
  WIDER,        ///< contained, and wider than needed
  REFUSED,      ///< outside of the operation's domain, as interval.h says
  NOT_OFFERED,  ///< by this library
  WRONG
};
using Counts = std::map<Outcome, int>;

template <class Value>
Outcome compared(const Value& got, const Value& expected)
{
  return got == expected ? Outcome::CONTAINED : Outcome::WRONG;
}

Outcome compared(const Interval& got, const Interval& expected)
{
  return got == expected ? Outcome::CONTAINED : expected.isSubsetOf(got) ? Outcome::WIDER : Outcome::WRONG;
}

Outcome outcome(const ItlStatement& statement)
{
  Intervals x;
  for (const auto& operand : statement.operands)
    if (operand.kind == ItlLiteral::INTERVAL)
      x.push_back(operand.interval);
    else
      return Outcome::NOT_OFFERED;
  if (statement.tightest.size() != 1)
    return Outcome::NOT_OFFERED;
  const ItlLiteral& expected = statement.tightest.front();
  const std::string& name = statement.operation;
  try
  {
    if (SETS.count(name) != 0)
      return compared(SETS.at(name)(x), expected.interval);
    if (OF_SINGLE_NUMBERS.count(name) != 0 && x.at(0).isSingle())
      return compared(OF_SINGLE_NUMBERS.at(name)(x.at(0).lower()), expected.interval);
    if (NUMBERS.count(name) != 0 && expected.kind == ItlLiteral::NUMBER)  // of the empty set all but two are NaN there
      return compared(NUMBERS.at(name)(x.at(0)), expected.number);
    if (RELATIONS.count(name) != 0)
      return compared(RELATIONS.at(name)(x), expected.word == "true");
  }
  catch (const std::domain_error&)
  {
    return Outcome::REFUSED;
  }
  return Outcome::NOT_OFFERED;
}

/// The statements of one file under every rounding mode, on threads that flush subnormal numbers as well.
Counts holdAll(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  Counts counts;
  for (const ItlStatement& statement :
       ItlReader({ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() }).statements())
    for (const auto& mode : MODES)
    {
      const Outcome found = under<Outcome>(mode, [&] { return outcome(statement); });
      EXPECT_NE(found, Outcome::WRONG) << path << ":" << statement.line << ": " << statement.operation << ", " << mode;
      ++counts[found];
    }
  for (auto& count : counts)
    count.second /= static_cast<int>(std::size(MODES));
  return counts;
}

TEST(ItlVectors, ofOurOwnAreReadAndHold)
{
  const Counts counts = holdAll(PKM_WORKSPACE_SOURCE_DIR "/test/data/interval.itl");
  const Counts expected = { { Outcome::CONTAINED, 28 }, { Outcome::REFUSED, 1 }, { Outcome::NOT_OFFERED, 5 } };
  EXPECT_EQ(counts, expected);
}

TEST(ItlVectors, ofTheStandardsCommunityHold)
{
  const char* const folder = std::getenv("PKM_WORKSPACE_ITL");
  if (folder == nullptr)
    GTEST_SKIP() << "set PKM_WORKSPACE_ITL to a folder with ITF1788's test vectors (*.itl), see docs/soundness.md";
  Counts all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".itl")
      for (const auto& [found, count] : holdAll(entry.path()))
        all[found] += count;
  std::cout << all[Outcome::CONTAINED] + all[Outcome::WIDER] << " vectors contained in " << std::size(MODES)
            << " modes, " << all[Outcome::WIDER] << " of them wider than needed, " << all[Outcome::REFUSED]
            << " refused as outside of the domain, " << all[Outcome::NOT_OFFERED] << " of operations not offered\n";
  EXPECT_GT(all[Outcome::CONTAINED], 0) << folder << " has no vectors";
}

TEST(ItlReaderRefusals, nameTheLine)
{
  const auto expectRefused = [](const std::string& text, const std::string& reason) {
    expectThrow<std::invalid_argument>([&] { ItlReader(text).statements(); }, reason);
  };
  expectRefused("testcase a {\n  add [1.0, 2.0] [1.0 = [1.0, 2.0];\n}", "line 2: expected ','");
  expectRefused("testcase a {\n  add [2.0, 1.0] = [1.0, 2.0];\n}", "line 2: an interval needs lower <= upper");
  expectRefused("testcase a {\n\n  neg [1.0, 2.0];\n}", "line 3: expected a result");
  expectRefused("testcase a {\n  neg [1.0, 2.0] = [1.0, 2.0]\n}", "line 3: expected a name");
  expectRefused("/* without end", "line 1: expected '\\*/'");
  expectRefused("add [1.0, 2.0] = [1.0, 2.0];", "line 1: expected 'testcase'");
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
