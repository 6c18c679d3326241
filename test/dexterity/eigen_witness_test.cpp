// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/eigen_witness.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "support/random.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Entries = eigen::Symmetric<double>;

constexpr double SCALES[] = { 1e-40, 1e-8, 1.0, 1e8, 1e40 };

Entries entriesOf(const Eigen::Matrix3d& m)
{
  return { m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1) };
}

/// A matrix with these eigenvalues, but for rounding.
Eigen::Matrix3d withEigenvalues(const Eigen::Vector3d& values, Random& random)
{
  const auto entries = Eigen::Matrix3d::NullaryExpr([&] { return random.uniform(-1.0, 1.0); }).eval();
  const Eigen::Matrix3d q = Eigen::HouseholderQR<Eigen::Matrix3d>(entries).householderQ();
  const Eigen::Matrix3d m = q * values.asDiagonal() * q.transpose();
  return 0.5 * (m + m.transpose());
}

/// Compares with Eigen: the pair's value is least up to @p share of the spectrum's width and some roundings of the
/// largest entry; it is what the vector gives, which has length 1.
void expectLeast(const Eigen::Matrix3d& m, double share)
{
  const auto pair = eigen::leastEigenpair(entriesOf(m));
  const Eigen::Vector3d wanted = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvalues();
  const double rounding = 1e-14 * m.cwiseAbs().maxCoeff();
  const Eigen::Vector3d v(pair.vector[0], pair.vector[1], pair.vector[2]);
  EXPECT_NEAR(v.norm(), 1.0, 1e-15) << m;
  EXPECT_NEAR(pair.value, v.dot(m * v), rounding) << m;
  EXPECT_GE(pair.value, wanted[0] - rounding) << m;
  EXPECT_LE(pair.value, wanted[0] + share * (wanted[2] - wanted[0]) + rounding) << m;
}

/// Tries matrices with the eigenvalues that @p draw(random) returns, in every scale.
template <class Draw>
void expectLeastOfMany(double share, const Draw& draw)
{
  for (const double scale : SCALES)
    for (int seed = 0; seed < cases(2000) && !testing::Test::HasFailure(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(static_cast<std::uint64_t>(seed));
      expectLeast(scale * withEigenvalues(draw(random), random), share);
    }
}

TEST(LeastEigenpair, isFoundToSevenDigitsOfTheSpectrumsWidth)
{
  expectLeastOfMany(1e-7, [](Random& random) {
    return Eigen::Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  });
}

TEST(LeastEigenpair, isFoundToSevenDigitsWhereItIsAlmostDouble)
{
  expectLeastOfMany(1e-7, [](Random& random) {
    const double least = random.uniform(-1.0, 1.0);
    return Eigen::Vector3d(least, least + std::pow(10.0, random.uniform(-17.0, -1.0)), least + 1.0);
  });
}

TEST(LeastEigenpair, isExactToNineDigitsWhereItStandsApart)
{
  expectLeastOfMany(1e-9, [](Random& random) {
    const double least = random.uniform(-1.0, 1.0);
    return Eigen::Vector3d(least, least + random.uniform(0.001, 1.0), least + 1.0);
  });
}

TEST(LeastEigenpair, isExactWhereTheLeastOrTheLargestIsDouble)
{
  expectLeastOfMany(1e-10, [](Random& random) {
    const double twice = random.uniform(-1.0, 1.0);
    return Eigen::Vector3d(twice, twice, twice + random.sign());
  });
}

TEST(LeastEigenpair, isExactOnDiagonalMatrices)
{
  for (const double scale : SCALES)
    for (int a = -2; a <= 2; ++a)
      for (int b = -2; b <= 2; ++b)
        for (int c = -2; c <= 2; ++c)
          expectLeast(scale * Eigen::Vector3d(a, b, c).asDiagonal().toDenseMatrix(), 1e-12);
}

TEST(LeastEigenpair, isExactOnMatricesOfRankOneAndTheirOpposites)
{
  for (const double scale : SCALES)
    for (int a = -2; a <= 2; ++a)
      for (int b = -2; b <= 2; ++b)
        for (int c = -2; c <= 2; ++c)
        {
          const Eigen::Vector3d v(a, b, c);
          expectLeast(scale * v * v.transpose(), 1e-12);
          expectLeast(-scale * v * v.transpose(), 1e-12);
        }
}

TEST(LeastEigenpair, isExactOnMultiplesOfTheIdentity)
{
  for (const double scale : SCALES)
    for (int seed = 0; seed < cases(); ++seed)
    {
      Random random(static_cast<std::uint64_t>(seed));
      const double value = scale * random.uniform(-1.0, 1.0);
      expectLeast(value * Eigen::Matrix3d::Identity(), 0.0);
    }
}

TEST(LeastEigenpair, ofTheZeroMatrixIsZero)
{
  const auto pair = eigen::leastEigenpair(Entries{});
  EXPECT_EQ(pair.value, 0.0);
  EXPECT_EQ(dot(pair.vector, pair.vector), 1.0);
}

TEST(LeastEigenpair, ofAPackIsThatOfEachLane)
{
  for (int seed = 0; seed < cases(1000); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    Entries lanes[2];
    eigen::Symmetric<Pack<2>> both;
    for (std::size_t k = 0; k < 6; ++k)
    {
      for (auto& lane : lanes)
        lane[k] = random.integer(-2, 2);  // multiple eigenvalues and zero matrices among them
      const double entries[] = { lanes[0][k], lanes[1][k] };
      both[k] = Pack<2>::load(entries);
    }
    const auto got = eigen::leastEigenpair(both);
    for (const int lane : { 0, 1 })
    {
      const auto wanted = eigen::leastEigenpair(lanes[lane]);
      ASSERT_TRUE(sameBits(got.value[lane], wanted.value)) << "seed " << seed;
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(sameBits(got.vector[k][lane], wanted.vector[k])) << "seed " << seed;
    }
  }
}

TEST(LeastEigenvector, ofFormsIsThatOfTheirValuesAtDelta)
{
  SymmetricForms<double> m;
  const Entries center = { 3.0, 2.0, 4.0, 0.5, -0.25, 1.0 };
  for (std::size_t k = 0; k < 6; ++k)
    m[k] = { center[k], { 0.5, 0.25, -0.125 * static_cast<double>(k) }, 7.0 };
  EXPECT_EQ(leastEigenvector(m).vector, eigen::leastEigenpair(center).vector);
  Entries there = center;
  for (std::size_t k = 0; k < 6; ++k)
    there[k] += 0.5 - 0.125 - 0.125 * static_cast<double>(k);
  EXPECT_EQ(leastEigenvector(m, { 1.0, -0.5, 1.0 }).vector, eigen::leastEigenpair(there).vector);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
