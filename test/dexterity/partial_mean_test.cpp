// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/partial_mean.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pkm_workspace
{
namespace
{
using test::SEED;

struct Part
{
  double measure;
  Interval values;
};

std::vector<Part> randomParts(std::size_t count, std::mt19937& engine)
{
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Part> parts;
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto ends = std::minmax({ share(engine), share(engine) });
    parts.push_back({ share(engine), Interval(ends.first, ends.second) });
  }
  return parts;
}

/// The least and the largest mean over all choices of parts at the border, in floating point.
Interval meanByTrial(const std::vector<Part>& whole, const std::vector<Part>& border)
{
  double least = 1.0;
  double largest = 0.0;
  for (unsigned choice = 0; choice < 1U << border.size(); ++choice)
  {
    double measure = 0.0;
    double lower = 0.0;
    double upper = 0.0;
    const auto add = [&](const Part& part) {
      measure += part.measure;
      lower += part.measure * part.values.lower();
      upper += part.measure * part.values.upper();
    };
    std::for_each(whole.begin(), whole.end(), add);
    for (std::size_t k = 0; k < border.size(); ++k)
      if (choice >> k & 1U)
        add(border[k]);
    least = std::min(least, lower / measure);
    largest = std::max(largest, upper / measure);
  }
  return { least, largest };
}

PartialMean meanOf(const std::vector<Part>& whole, const std::vector<Part>& border)
{
  PartialMean mean;
  for (const Part& part : whole)
    mean.addWhole(part.measure, part.values);
  for (const Part& part : border)
    mean.addBorder(part.measure, part.values);
  return mean;
}
}  // namespace

TEST(PartialMean, isTheWorstOverAllSharesOfTheBorder)
{
  std::mt19937 engine(SEED);
  for (int k = 0; k < 300; ++k)
  {
    const auto whole = randomParts(1 + k % 3, engine);
    const auto border = randomParts(static_cast<std::size_t>(k % 8), engine);
    const Interval expected = meanByTrial(whole, border);
    const Interval found = meanOf(whole, border).mean();
    EXPECT_LE(found.lower(), expected.lower() + 1e-15) << "seed " << SEED << ", case " << k;
    EXPECT_GE(found.upper(), expected.upper() - 1e-15) << "seed " << SEED << ", case " << k;
    EXPECT_LE(found.width(), expected.width() + 1e-11) << "seed " << SEED << ", case " << k;
  }
}

TEST(PartialMean, enclosesTheMeasure)
{
  PartialMean mean = meanOf({ { 0.1, Interval(0.5) }, { 0.2, Interval(0.5) } }, { { 0.4, Interval(0.0, 1.0) } });
  EXPECT_LE(mean.measure().lower(), 0.3);
  EXPECT_NEAR(mean.measure().lower(), 0.3, 1e-15);
  EXPECT_GE(mean.measure().upper(), 0.7);
  EXPECT_NEAR(mean.measure().upper(), 0.7, 1e-15);
}

TEST(PartialMean, isOneNumberWhereTheFunctionIs)
{
  EXPECT_EQ(Interval(0.0), meanOf({ { 1.0, Interval(0.0) } }, { { 1.0, Interval(0.0) } }).mean());
  EXPECT_EQ(Interval(1.0), meanOf({ { 1.0, Interval(1.0) } }, {}).mean());
}

TEST(PartialMean, isUnknownWithoutAMeasure)
{
  EXPECT_EQ(Interval(0.0, 1.0), meanOf({}, { { 1.0, Interval(0.25, 0.5) } }).mean());
}
}  // namespace pkm_workspace
