// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/definiteness.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "support/forms.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Matrix = SymmetricForms<double>;

constexpr int MEMBERS = 4;
// Entries in the order of SymmetricForms.
constexpr std::size_t ROW[] = { 0, 1, 2, 1, 0, 0 };
constexpr std::size_t COLUMN[] = { 0, 1, 2, 2, 2, 1 };

Form constantForm(double value, double radius = 0.0)
{
  return { value, { 0.0, 0.0, 0.0 }, radius };
}

std::string toText(const Matrix& m)
{
  std::ostringstream text;
  for (std::size_t k = 0; k < 6; ++k)
    text << ROW[k] << COLUMN[k] << ": " << m[k] << "\n";
  return text.str();
}

/// Sylvester's criterion; true only when the matrix is proved not to be positive definite.
bool isNotDefinite(const std::array<Exact, 6>& m)
{
  const Exact minor = m[0] * m[1] - m[5] * m[5];
  const ExactVector rows[] = { { m[0], m[5], m[4] }, { m[5], m[1], m[3] }, { m[4], m[3], m[2] } };
  return m[0].certainlyNotPositive() || minor.certainlyNotPositive() ||
         determinant(rows[0], rows[1], rows[2]).certainlyNotPositive();
}

std::array<Exact, 6> memberOf(const Matrix& m, Forms& forms)
{
  std::array<Exact, 6> result;
  for (std::size_t k = 0; k < 6; ++k)
    result[k] = forms.member(m[k]);
  return result;
}

/// v v^T + w w^T, singular but for rounding, plus a few ulps on the diagonal, plus small gradients and errors or none:
/// such matrices stand at the limit of being definite.
Matrix nearlySingular(Forms& forms)
{
  Random& random = forms.random();
  const Eigen::Vector3d v(forms.number(), forms.number(), forms.number());
  const Eigen::Vector3d w(forms.number(), forms.number(), forms.number());
  Eigen::Matrix3d m = v * v.transpose() + w * w.transpose();
  const double trace = m.trace();
  m.diagonal().array() += trace * std::ldexp(random.integer(-2, 8), -random.integer(20, 54));
  const double ripple = random.once(2) ? 0.0 : trace * std::ldexp(1.0, -random.integer(5, 60));
  const double error = random.once(2) ? 0.0 : trace * std::ldexp(1.0, -random.integer(5, 60));
  Matrix result;
  for (std::size_t k = 0; k < 6; ++k)
  {
    result[k] = constantForm(m(static_cast<int>(ROW[k]), static_cast<int>(COLUMN[k])), error);
    for (auto& g : result[k].gradient)
      g = ripple * random.uniform(-1.0, 1.0);
  }
  return result;
}

class DefinitenessContainment : public testing::TestWithParam<RoundingMode>
{
};

TEST_P(DefinitenessContainment, whatIsProvedDefiniteIsDefiniteInEveryMember)
{
  int proofs = 0;
  const int tries = cases(4000);
  for (int seed = 0; seed < tries; ++seed)
  {
    Forms forms(static_cast<std::uint64_t>(seed));
    const Matrix m = nearlySingular(forms);
    if (!under<bool>(GetParam(), [&] { return isPositiveDefinite(m); }))
      continue;
    ++proofs;
    for (int i = 0; i < MEMBERS; ++i, forms.move())
      ASSERT_FALSE(isNotDefinite(memberOf(m, forms))) << toText(m) << "seed " << seed;
  }
  EXPECT_GT(proofs, tries / 20) << "too few proofs to mean anything";
  EXPECT_LT(proofs, tries * 19 / 20) << "too many proofs: the cases are not at the limit";
}

TEST_P(DefinitenessContainment, quadraticFormHoldsThatOfEveryMember)
{
  for (int seed = 0; seed < cases(400); ++seed)
  {
    Forms forms(static_cast<std::uint64_t>(seed));
    Random& random = forms.random();
    const Matrix m = nearlySingular(forms);
    const std::array<double, 3> v = { random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                      random.integer(-1, 1) * 1.0 };
    const Form form = under<Form>(GetParam(), [&] { return quadraticForm(m, v); });
    for (int i = 0; i < MEMBERS; ++i, forms.move())
    {
      const auto x = memberOf(m, forms);
      Exact value = 0.0;
      for (std::size_t k = 0; k < 6; ++k)
        value = value + x[k] * (ROW[k] == COLUMN[k] ? 1.0 : 2.0) * v[ROW[k]] * v[COLUMN[k]];
      ASSERT_TRUE(forms.holds(form, value)) << toText(m) << form << " seed " << seed;
    }
  }
}

TEST_P(DefinitenessContainment, multipleHoldsThatOfEveryMember)
{
  for (int seed = 0; seed < cases(); ++seed)
  {
    Forms forms(static_cast<std::uint64_t>(seed));
    const Matrix m = nearlySingular(forms);
    const Interval s = hull(Interval(forms.number()), Interval(forms.number()));
    const Matrix product = under<Matrix>(GetParam(), [&] { return Enclosed<double>(s) * m; });
    for (std::size_t k = 0; k < 6; ++k)
      ASSERT_TRUE(forms.holds(product[k], Exact(s.upper()) * forms.member(m[k]))) << s << "\n" << toText(m);
  }
}

INSTANTIATE_TEST_SUITE_P(All, DefinitenessContainment, testing::ValuesIn(MODES), nameOfMode);

Matrix diagonal(double a, double b, double c)
{
  return { constantForm(a), constantForm(b), constantForm(c), Form{}, Form{}, Form{} };
}

TEST(DefinitenessTightness, matricesWithAMarginOfManyUlpsAreProved)
{
  for (int seed = 0; seed < cases(400); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    Eigen::Matrix3d m, g[3];
    for (auto* matrix : { &m, &g[0], &g[1], &g[2] })
    {
      const auto entries = Eigen::Matrix3d::NullaryExpr([&] { return random.uniform(-1.0, 1.0); }).eval();
      *matrix = entries + entries.transpose();
    }
    double least = 1e300;
    for (int c = 0; c < 8; ++c)
    {
      const auto sign = [c](int j) { return (c >> j) & 1 ? 1.0 : -1.0; };
      const Eigen::Matrix3d corner = m + sign(0) * g[0] + sign(1) * g[1] + sign(2) * g[2];
      least = std::min(least, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(corner).eigenvalues()[0]);
    }
    for (const double margin : { 1e-9, -1e-9 })
    {
      Matrix forms;
      for (std::size_t k = 0; k < 6; ++k)
      {
        const auto i = static_cast<int>(ROW[k]), j = static_cast<int>(COLUMN[k]);
        forms[k] = { m(i, j) + (i == j ? margin - least : 0.0), { g[0](i, j), g[1](i, j), g[2](i, j) }, 0.0 };
      }
      EXPECT_EQ(isPositiveDefinite(forms), margin > 0.0) << "least eigenvalue " << margin << ", seed " << seed;
    }
  }
}

TEST(Definiteness, errorsOfARowComeOffItsDiagonal)
{
  Matrix m = diagonal(1.0, 1.0, 1.0);
  m[4].radius = m[5].radius = 0.49;
  EXPECT_TRUE(isPositiveDefinite(m));
  m[4].radius = m[5].radius = 0.51;
  EXPECT_FALSE(isPositiveDefinite(m)) << "row sums above 1 are not proved";
  m = diagonal(1.0, 1.0, 1.0);
  m[1].radius = 1.0;
  EXPECT_FALSE(isPositiveDefinite(m)) << "the entry 11 may be 0";
}

TEST(Definiteness, oneBadCornerIsEnough)
{
  Matrix m = diagonal(1.0, 1.0, 1.0);
  for (std::size_t k = 0; k < 6; ++k)
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const auto slopes = [corner](double size) {
        return std::array<double, 3>{ corner & 1U ? size : -size, corner & 2U ? size : -size,
                                      corner & 4U ? size : -size };
      };
      Matrix bad = m;
      bad[k].gradient = slopes(0.4);
      EXPECT_FALSE(isPositiveDefinite(bad)) << "entry " << k << ", corner " << corner;
      bad[k].gradient = slopes(0.3);
      EXPECT_TRUE(isPositiveDefinite(bad)) << "entry " << k << ", corner " << corner;
    }
}

TEST(Definiteness, singularIndefiniteAndUndefinedMatricesAreNotProved)
{
  EXPECT_TRUE(isPositiveDefinite(diagonal(1.0, 2.0, 3.0)));
  EXPECT_FALSE(isPositiveDefinite(diagonal(1.0, 2.0, 0.0)));
  EXPECT_FALSE(isPositiveDefinite(diagonal(-1.0, -2.0, 3.0))) << "two negative eigenvalues: det > 0";
  EXPECT_FALSE(isPositiveDefinite(diagonal(1.0, -2.0, -3.0)));
  EXPECT_FALSE(isPositiveDefinite(diagonal(1e308, 1e308, 1e308))) << "overflow";
  EXPECT_FALSE(isPositiveDefinite(diagonal(INF, INF, INF)));
  for (std::size_t k = 0; k < 6; ++k)
  {
    Matrix m = diagonal(1.0, 1.0, 1.0);
    m[k].center = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isPositiveDefinite(m));
    m = diagonal(1.0, 1.0, 1.0);
    m[k].radius = INF;
    EXPECT_FALSE(isPositiveDefinite(m));
  }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
