// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/interval_vector.h"

#include <gtest/gtest.h>

#include "support/exact_vector.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using ExactMatrix = std::array<ExactVector, 3>;

/// Random rows, and a member of each: the third row is often nearly a combination of the others.
struct VectorCase
{
  IntervalMatrix rows;
  ExactMatrix member;

  VectorCase(const Spread& spread, int seed)
  {
    Operands operands(spread, static_cast<std::uint64_t>(seed));
    Random random(static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
      {
        rows[i][k] = operands.interval();
        if (i == 2 && !random.once(3))
          rows[i][k] = Interval(rows[0][k].lower() / 4.0 + rows[1][k].upper() / 4.0);
        member[i][k] = operands.member(rows[i][k]);
      }
  }
};

std::ostream& operator<<(std::ostream& stream, const VectorCase& x)
{
  for (const auto& row : x.rows)
    stream << row[0] << " " << row[1] << " " << row[2] << "; ";
  return stream;
}

class IntervalVectorContainment : public ModeAndSpread
{
protected:
  template <class Check>
  void forEachCase(const Check& check)
  {
    for (int seed = 0; seed < cases() && !HasFailure(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      check(VectorCase(spread(), seed));
    }
  }
};

TEST_P(IntervalVectorContainment, scalarResultsHoldTheExactOnes)
{
  forEachCase([this](const VectorCase& x) {
    const auto& [u, v, w] = x.rows;
    const auto& [a, b, c] = x.member;
    const auto got = under<IntervalVector>(mode(), [&, &u = u, &v = v, &w = w] {
      return IntervalVector{ dot(u, v), squaredNorm(u), determinant(u, v, w) };
    });
    ASSERT_TRUE(dot(a, b).mayLieIn(got[0])) << got[0] << " " << x;
    ASSERT_TRUE(dot(a, a).mayLieIn(got[1])) << got[1] << " " << x;
    ASSERT_TRUE(determinant(a, b, c).mayLieIn(got[2])) << got[2] << " " << x;
    const Interval length = under<Interval>(mode(), [&, &u = u] { return norm(u); });
    ASSERT_TRUE(sqrt(dot(a, a)).mayLieIn(length)) << length << " " << x;
  });
}

TEST_P(IntervalVectorContainment, vectorResultsHoldTheExactOnes)
{
  forEachCase([this](const VectorCase& x) {
    const auto& m = x.rows;
    const auto& n = x.member;
    const auto got = under<IntervalMatrix>(mode(), [&] {
      return IntervalMatrix{ m[0] + m[1], m[2][0] * (m[0] - m[1]), m * m[1] };
    });
    const auto crossed = under<IntervalVector>(mode(), [&] { return cross(m[0], m[1]); });
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_TRUE((n[0][k] + n[1][k]).mayLieIn(got[0][k])) << x;
      ASSERT_TRUE((n[2][0] * (n[0][k] - n[1][k])).mayLieIn(got[1][k])) << x;
      ASSERT_TRUE(dot(n[k], n[1]).mayLieIn(got[2][k])) << x;
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      ASSERT_TRUE((n[0][i] * n[1][j] - n[0][j] * n[1][i]).mayLieIn(crossed[k])) << x;
    }
  });
}

TEST_P(IntervalVectorContainment, matrixProductsHoldTheExactOnes)
{
  forEachCase([this](const VectorCase& x) {
    const auto got = under<IntervalMatrix>(mode(), [&] { return x.rows * transpose(x.rows); });
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(dot(x.member[i], x.member[k]).mayLieIn(got[i][k])) << i << k << " " << got[i][k] << " " << x;
  });
}

INSTANTIATE_TEST_SUITE_P(All, IntervalVectorContainment, everyModeAndSpread(), nameOf);

TEST(IntervalVector, vectorsMeetWhereAllComponentsMeet)
{
  const IntervalVector a = { Interval(0.0, 1.0), Interval(0.0, 1.0), Interval(0.0, 1.0) };
  EXPECT_TRUE(intersects(a, { 1.0, 0.0, 0.5 }));
  EXPECT_FALSE(intersects(a, { 1.0, 0.0, 1.5 }));
  EXPECT_EQ(mid(a), Eigen::Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(enclose(Eigen::Vector3d(1.0, 2.0, 3.0)), (IntervalVector{ 1.0, 2.0, 3.0 }));
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
